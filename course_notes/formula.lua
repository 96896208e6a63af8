-- Formulas on a line of their own: each has a number, and on a phone breaks where a reader would break it. A part of figure.lua.

local formula = {}
local is_html = FORMAT:match("html") ~= nil
local count = 0

-- Signs before which a line may end, outside of all brackets. `\allowbreak` in a chapter asks for one more, inside of \Big[ \Big], too.
local relations = { ["="] = true, ["\\approx"] = true, ["\\propto"] = true, ["\\Rightarrow"] = true, ["\\le"] = true,
                    ["\\leftarrow"] = true }
local groups = { ["{"] = 1, ["\\left"] = 1, ["\\begin"] = 1, ["}"] = -1, ["\\right"] = -1, ["\\end"] = -1 }
local brackets = { ["\\Big["] = 1, ["("] = 1, ["\\Big]"] = -1, [")"] = -1 }

-- TeX as a list of its words: commands, with the bracket that follows \Big, and single signs.
local function tokens(tex)
    local list, at = {}, 1
    while at <= #tex do
        local token = tex:match("^\\Big[%[%]]", at) or tex:match("^\\%a+", at) or tex:match("^\\.", at) or
                      tex:match("^[%z\1-\127\194-\244][\128-\191]*", at)
        list[#list + 1] = token
        at = at + #token
    end
    return list
end

-- The formula in pieces that may stand below one another.
function formula.pieces(tex)
    local pieces, piece, group, bracket = {}, "", 0, 0
    local function finish()
        if piece:match("%S") then
            pieces[#pieces + 1] = piece
        end
        piece = ""
    end
    for _, token in ipairs(tokens(tex)) do
        group = group + (groups[token] or 0)
        bracket = bracket + (brackets[token] or 0)
        local outside = group == 0 and bracket == 0
        local empty = not piece:gsub("\\q?quad", ""):match("[^%s\\;:,!]")
        if (outside and relations[token] or group == 0 and token == "\\allowbreak") and not empty then
            finish()
        end
        if token ~= "\\allowbreak" then
            piece = piece .. token
        end
        if outside and (token == "\\qquad" or token == "\\quad") then
            finish()
        end
    end
    finish()
    return pieces
end

-- The number of the chapter, or a letter where it has none: before a figure's and a formula's.
function formula.number(page, index)
    return (page:match("^%d+") or page:sub(1, 1):upper()) .. "." .. index
end

function formula.Math(math, page)
    if math.mathtype ~= "DisplayMath" then
        return nil
    end
    count = count + 1
    local number = formula.number(page, count)
    if not is_html then
        math.text = math.text:gsub("\\allowbreak", "") .. "\\tag{" .. number .. "}"
        return math
    end
    local id = "eq-" .. number:gsub("%.", "-")
    local out = pandoc.List({ pandoc.RawInline("html", '<span class="formula" id="' .. id .. '"><span class="pieces" tabindex="0">') })
    for _, piece in ipairs(formula.pieces(math.text)) do
        out:insert(pandoc.Math("DisplayMath", piece))
    end
    out:insert(pandoc.RawInline("html", '</span><a class="number" href="#' .. id .. '">(' .. number .. ")</a></span>"))
    return out
end

return formula
