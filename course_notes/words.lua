-- Lines and tables of the notes: what scrolls inside its own box, and what no line's end may part. A part of figure.lua.

local words = {}
local is_html = FORMAT:match("html") ~= nil

function words.escape(text)
    return (text:gsub("[&<>\"]", { ["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;", ['"'] = "&quot;" }))
end

function words.raw(text)
    return pandoc.RawBlock("html", text)
end

function words.tex(text)
    return pandoc.RawInline("latex", text)
end

-- Blocks with others around them.
function words.boxed(content, before, after)
    local blocks = pandoc.List(before)
    blocks:extend(content)
    blocks:extend(after)
    return blocks
end

local escape, raw, tex = words.escape, words.raw, words.tex

-- About how many letters a formula is wide.
local function letters_of(tex)
    return utf8.len((tex:gsub("\\%a+", "x"):gsub("[\\{}^_%s]", "")))
end

-- How long the longest text of each column is, as it is read: no TeX, no attributes.
local function longest_texts(block)
    local simple, longest = pandoc.utils.to_simple_table(block), {}
    for i in ipairs(block.colspecs) do
        longest[i] = 0
        local cells = pandoc.List({ simple.headers[i] or {} })
        cells:extend(simple.rows:map(function(row) return row[i] end))
        for _, cell in ipairs(cells) do
            local text = pandoc.walk_block(pandoc.Div(cell), { Math = function(math)
                return pandoc.Str(("x"):rep(letters_of(math.text) * (is_html and 1 or 2))) -- on paper, wider than letters
            end })
            longest[i] = math.max(longest[i], utf8.len(pandoc.utils.stringify(text)))
        end
    end
    return longest
end

-- Where a row's source is longer than a line, pandoc makes all columns equally wide. In the PDF a column gets a share by its
-- longest cell instead; a browser knows better by itself.
local function set_widths(block, longest, sum)
    local shares, all = {}, 0
    for i, letters in ipairs(longest) do
        shares[i] = math.min(math.max(letters, 7), 60)
        all = all + shares[i]
    end
    local specs = {}
    for i, spec in ipairs(block.colspecs) do
        specs[i] = (is_html or sum < 60) and { spec[1] } or { spec[1], shares[i] / all }
    end
    block.colspecs = specs
    return block
end

function words.Table(block)
    local longest, sum = longest_texts(block), 0
    for _, letters in ipairs(longest) do
        sum = sum + letters
    end
    if (block.colspecs[1][2] or 0) > 0 then
        block = set_widths(block, longest, sum)
    end
    -- A phone's line holds 45 letters. Two columns with a few lines in each cell are still read; three with many are not.
    local long = #longest > 2 and sum > 75
    return is_html and { raw('<div class="wide' .. (long and " long" or "") .. '" tabindex="0">'), block, raw("</div>") } or block
end

function words.Span(span)
    return span.attributes.from and span.content or nil
end

local units = {}
for unit in ("% W W/m² m cm mm µm nm s ms MB GB"):gmatch("%S+") do
    units[unit] = true
end

-- The space after `before`: one that no line may end at, between a number and its unit or its thousands, before the dot between
-- two links, after the number of a step at the beginning of a link?
local function keeps(i, before, after)
    local word = after and after.t == "Str" and after.text:gsub("[.,;:)]+$", "") or ""
    local number = before and before.t == "Str" and before.text:match("%d$")
    return word == "·" or number and (units[word] or word == "000" or i == 2 and before.text:match("^%d%.%d$"))
end

-- What stands together without a space must not be parted by a line's end, but a browser may break on both sides of a formula:
-- "(", the formula, ")." go into one box if they are short; so does a number after "k =".
function words.Inlines(inlines)
    local out, run, letters, formula = pandoc.List(), pandoc.List(), 0, false
    local function flush()
        local together = is_html and formula and #run > 1 and letters <= 30
        out:extend(together and { pandoc.Span(run, { class = "together" }) } or run)
        run, letters, formula = pandoc.List(), 0, false
    end
    for i, inline in ipairs(inlines) do
        local before, after = inlines[i - 1], inlines[i + 1]
        if inline.t == "Str" or inline.t == "Math" and inline.mathtype == "InlineMath" then
            run:insert(inline)
            letters = letters + (inline.t == "Math" and letters_of or utf8.len)(inline.text)
            formula = formula or inline.t == "Math"
        elseif inline.t == "Space" and before and before.t == "Math" and before.text:match("=%s*$") then
            run:insert(pandoc.Str("\u{a0}"))
        else
            flush()
            out:insert(inline.t == "Space" and keeps(i, before, after) and pandoc.Str("\u{a0}") or inline)
        end
    end
    flush()
    return out
end

-- A path may break at its slashes; an option, an arrow like hit->normal nowhere.
function words.Code(code)
    if not is_html then
        return nil
    end
    local text = escape(code.text)
    if text:match("^[^%s]+/[^%s]+$") and #text > 20 then
        text = text:gsub("/", "/<wbr />")
    else
        text = text:gsub("%S*%-%S+", function(word)
            return #word < 25 and '<span class="together">' .. word .. "</span>" or nil
        end)
    end
    return pandoc.RawInline("html", "<code>" .. text .. "</code>")
end

-- The text's font has no such signs.
function words.Str(str)
    if not is_html and (str.text:find("✓") or str.text:find("✗")) then
        return tex("{\\sffamily " .. str.text .. "}")
    end
end

return words
