-- What pandoc makes of the notes: figures with the command that makes them, folded answers, asides, tables and formulas that
-- scroll inside their own box, links between chapters. Works with pandoc 2.17 and 3.
--
-- Environment: NOTES_FIGURES, the folder of the figures; NOTES_PAGES, a file with lines "name<TAB>title", in reading order;
-- NOTES_PAGE, this page's name.

local here = PANDOC_SCRIPT_FILE:match("^.*/") or ""
local words = dofile(here .. "words.lua")
local formula = dofile(here .. "formula.lua")
local paper = dofile(here .. "paper.lua")
local escape, raw, tex = words.escape, words.raw, words.tex
local is_html = FORMAT:match("html") ~= nil
local figures = os.getenv("NOTES_FIGURES") or "course_notes/figures"
local page = os.getenv("NOTES_PAGE") or "page"
local figure_numbers = {} -- by "#id" and by file
local labels = { question = "Question", wrong = "What goes wrong", reading = "To read", source = "In the source text" }

local function read_file(path)
    local file = io.open(path, "rb")
    if not file then
        io.stderr:write("notes: there is no ", path, "; `make figures` makes it\n")
        return nil
    end
    local bytes = file:read("a")
    file:close()
    return bytes
end

-- ---- HTML ----

-- What a command writes, in base64; nothing if it fails.
local function base64_of(command)
    local pipe = io.popen(command .. " 2>/dev/null | base64 | tr -d '\\n'")
    local text = pipe:read("a")
    pipe:close()
    return text
end

-- Written into the page, so that a page is one file wherever it is copied to.
local function embedded(path)
    local types = { png = "image/png", svg = "image/svg+xml", jpg = "image/jpeg" }
    local kind = types[path:match("%w+$")] or "image/png"
    local text = read_file(path) and base64_of("cat '" .. path .. "'")
    if not text then
        return ""
    end
    if os.getenv("NOTES_LIVE") and kind == "image/png" then -- a tenth of the bytes for those who load it
        local packed = base64_of("cwebp -quiet -q 90 -sharp_yuv '" .. path .. "' -o -")
        if packed ~= "" and #packed < #text then
            text, kind = packed, "image/webp"
        end
    end
    return "data:" .. kind .. ";base64," .. text
end

local function inlines_of(markdown)
    local inlines = pandoc.List()
    for _, block in ipairs(pandoc.read(markdown, "markdown").blocks) do
        if block.content then
            inlines:extend(pandoc.walk_block(block, { Inlines = words.Inlines, Code = words.Code }).content)
        end
    end
    return inlines
end

-- Where the page has the module, a figure that can be moved stands below its picture, or in its place: web/figures/.
local function live_html(attributes)
    if not attributes.live or not os.getenv("NOTES_LIVE") then
        return ""
    end
    local function data(name)
        return attributes[name] and " data-" .. name .. '="' .. escape(attributes[name]) .. '"' or ""
    end
    return '<div class="live"' .. data("live") .. data("parts") .. data("pair") .. '><p class="try">' .. escape(attributes.try or "") .. "</p></div>"
end

-- A click on a picture, or the space key, fills the window with it: a box to tick, and the style does the rest.
local function figure_html(block, caption, number)
    local a = block.attributes
    local style = a.width and ' style="width:' .. escape(a.width) .. '"' or ""
    local class = a.file:match("svg$") and ' class="plot"' or ""
    local id = escape(block.identifier)
    caption:insert(1, pandoc.RawInline("html", '<a class="number" href="#' .. id .. '">Figure ' .. number .. "</a>\u{2002}"))
    return {
        raw('<figure' .. (id ~= "" and ' id="' .. id .. '"' or "") .. ">"),
        raw('<label class="zoom"><input type="checkbox" aria-label="enlarge the picture" /><img src="' .. embedded(figures .. "/" .. a.file) ..
            '" alt="' .. escape(a.alt or "") .. '"' .. class .. style .. " /></label>"),
        raw("<figcaption>"), pandoc.Plain(caption), raw("</figcaption>"), raw(live_html(a)),
        raw('<pre class="command" tabindex="0">' .. escape(block.text) .. "</pre>"), raw("</figure>"),
    }
end

-- ---- what is replaced by what ----

local function computed_by(block)
    local file, command = block.attributes.file or "", block.text
    if is_html then
        return { raw('<details class="computed"><summary>The numbers here come from <code>' .. escape(file) ..
                     "</code></summary>"), raw('<pre class="command" tabindex="0">' .. escape(command) .. "</pre></details>") }
    end
    return pandoc.Para({ tex("{\\footnotesize Numbers: "), pandoc.Code(file), tex(", computed by}" .. paper.command(command)) })
end

local function CodeBlock(block)
    if block.classes:includes("terminal") then -- what its command has shown
        return pandoc.CodeBlock(read_file(figures .. "/" .. block.attributes.file) or "")
    elseif block.classes:includes("data") then
        return computed_by(block)
    elseif block.classes:includes("figure") then
        local caption = inlines_of(block.attributes.caption or "")
        return (is_html and figure_html or paper.figure)(block, caption, figure_numbers[block.attributes.file])
    elseif is_html then
        block.attributes.tabindex = "0" -- a box that scrolls is reached by keyboard, too
        return block
    end
end

local function answer(div)
    if is_html then
        return words.boxed(div.content, { raw('<details class="answer"><summary>Answer</summary>') }, { raw("</details>") })
    end
    return words.boxed(div.content, { pandoc.RawBlock("latex", "\\begin{quote}\\footnotesize\\emph{Answer.}") },
                 { pandoc.RawBlock("latex", "\\end{quote}") })
end

local function aside(div, class)
    if is_html then
        local id = div.identifier ~= "" and ' id="' .. escape(div.identifier) .. '"' or ""
        return words.boxed(div.content, { raw("<div" .. id .. ' class="aside ' .. class .. '"><p class="label">' .. labels[class] .. "</p>") },
                     { raw("</div>") })
    end
    return words.boxed(div.content, { pandoc.RawBlock("latex", "\\room{2cm}\\begin{aside}{" .. labels[class] .. "}") },
                 { pandoc.RawBlock("latex", "\\end{aside}") })
end

-- The pages that there are, in their order: students do not have all.
local function pages()
    local list = pandoc.List()
    for line in io.lines(os.getenv("NOTES_PAGES")) do
        local name, title = line:match("^(.-)\t(.*)$")
        list:insert({ name = name, title = title })
    end
    return list
end

local function read_page(name)
    return pandoc.read(read_file("course_notes/" .. name .. ".md"), "markdown")
end

local function contents()
    local items = pandoc.List()
    for _, other in ipairs(pages()) do
        local name, title = other.name, other.title
        local sections = pandoc.List()
        local doc = read_page(name)
        for _, block in ipairs(doc.blocks) do
            if block.t == "Header" and block.level == 2 then
                if #sections > 0 then
                    sections:extend({ pandoc.Str("\u{a0}·"), pandoc.Space() })
                end
                sections:insert(pandoc.Link(block.content, name .. ".html#" .. block.identifier))
            end
        end
        items:insert({ pandoc.Para({ pandoc.Strong({ pandoc.Link(pandoc.Str(title), name .. ".html") }) }), pandoc.Para(sections) })
    end
    return pandoc.BulletList(items)
end

local function Div(div)
    if div.classes:includes("contents") then
        return is_html and contents() or {}
    elseif div.classes:includes("words") then
        local chapters = pages():filter(function(other) return other.name:match("^%d") or other.name == "further_work" end)
        return dofile(here .. "word_index.lua").entries(pandoc.utils.stringify(div), chapters, read_page)
    elseif div.classes:includes("answer") then
        return answer(div)
    elseif not is_html and div.classes:includes("gallery") then
        return paper.gallery(div)
    elseif not is_html and div.classes:includes("tile") then
        return paper.tile(div)
    end
    for class in pairs(labels) do
        if div.classes:includes(class) then
            return aside(div, class)
        end
    end
end

-- A link without words says which figure it leads to.
local function Link(link)
    if #link.content == 0 and figure_numbers[link.target] then
        link.content = { pandoc.Str("figure\u{a0}" .. figure_numbers[link.target]) }
        return link
    end
end

local function Image(image)
    if is_html then -- as it is: pandoc's writer looks long at a picture's bytes
        return pandoc.RawInline("html", '<img src="' .. embedded("course_notes/" .. image.src) .. '" alt="' ..
            escape(pandoc.utils.stringify(image.caption)) .. '" />')
    end
    image.src = "course_notes/" .. image.src
    return image
end

-- Before all else, as a text may name a figure that comes later.
local function number_figures(doc)
    local count = 0
    pandoc.walk_block(pandoc.Div(doc.blocks), { CodeBlock = function(block)
        if block.classes:includes("figure") then
            count = count + 1
            figure_numbers[block.attributes.file or ""] = formula.number(page, count)
            figure_numbers["#" .. block.identifier] = formula.number(page, count)
        end
    end })
end

local function set_title(doc)
    for _, block in ipairs(doc.blocks) do
        if block.t == "Header" and block.level == 1 then
            doc.meta.pagetitle = pandoc.utils.stringify(block)
            return doc
        end
    end
    io.stderr:write("notes: ", page, ".md has no title; its first line should be `# …`\n")
    os.exit(1)
end

local function Math(math)
    return formula.Math(math, page)
end

local first = { Pandoc = number_figures }
local replace = { CodeBlock = CodeBlock, Div = Div, Image = Image, Link = Link, Table = words.Table, Math = Math, Span = words.Span,
                  Inlines = words.Inlines, Code = words.Code, Str = words.Str }
return is_html and { first, replace, { Pandoc = set_title } } or { first, paper.one_document, replace }
