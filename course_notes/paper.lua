-- What only the PDF needs: LaTeX for figures and the gallery, and anchors for all chapters in one document. A part of figure.lua.

local words = dofile((PANDOC_SCRIPT_FILE:match("^.*/") or "") .. "words.lua")
local tex = words.tex
local figures = os.getenv("NOTES_FIGURES") or "course_notes/figures"
local page = os.getenv("NOTES_PAGE") or "page"
local paper = {}

local function tex_escape(text)
    local special = { ["\\"] = "\\textbackslash{}", ["~"] = "\\textasciitilde{}", ["^"] = "\\textasciicircum{}",
                      [" "] = "\\ \\allowbreak{}", ["/"] = "/\\allowbreak{}", ["_"] = "\\_\\allowbreak{}", ["-"] = "{-}",
                      ["'"] = "\\textquotesingle{}", ["`"] = "\\textasciigrave{}", ['"'] = "\\textquotedbl{}" }
    return (text:gsub("[\\~^%s/_'`\"-]", special):gsub("[&%%$#]", "\\%0"))
end

function paper.command(command)
    local lines = {}
    for line in command:gmatch("[^\n]+") do
        lines[#lines + 1] = tex_escape((line:gsub("[{}]", { ["{"] = "(", ["}"] = ")" })))
    end
    return "{\\raggedright\\scriptsize\\ttfamily\\color{gray}" .. table.concat(lines, "\\\\ ") .. "\\par}"
end

function paper.figure(block, caption, number)
    local a = block.attributes
    local label = block.identifier ~= "" and tex("\\phantomsection\\label{" .. block.identifier .. "}") or tex("")
    local image = pandoc.Image({}, figures .. "/" .. a.file, "", { width = a.width or a.file:match("png$") and "58%" or "80%" })
    -- A small one stays where it is; a large one may float to where it leaves no gap.
    local place = a.width and "[H]" or "[!htbp]"
    local body = pandoc.List({ tex("\\begin{figure}" .. place .. "\\centering "), label, image, tex("\\caption{Figure " .. number .. ".\\enspace ") })
    body:extend(caption)
    body:insert(tex("}" .. paper.command(block.text) .. "\\end{figure}"))
    return pandoc.Para(body)
end

-- The gallery in the PDF: tiles in four columns. (HTML does it by its style.)
function paper.gallery(div)
    return words.boxed(div.content, { pandoc.RawBlock("latex", "\\begin{multicols}{4}\\raggedcolumns") },
                 { pandoc.RawBlock("latex", "\\end{multicols}") })
end

function paper.tile(div)
    local label = div.identifier ~= "" and "\\hypertarget{" .. div.identifier .. "}{}" or ""
    local content = pandoc.walk_block(div, { Image = function(image)
        image.attributes.width = "100%"
        return { image, tex("\\newline ") }
    end, Code = function(code) -- a path may break at its slashes
        return tex("\\texttt{" .. tex_escape((code.text:gsub("[{}]", ""))) .. "}")
    end }).content
    return words.boxed(content, { pandoc.RawBlock("latex", "\\begin{tile}" .. label) }, { pandoc.RawBlock("latex", "\\end{tile}") })
end

-- In the PDF all chapters are one document: an anchor gets its chapter's name before it, and so do the links to it.
paper.one_document = {
    Header = function(header)
        header.identifier = header.level == 1 and page or page .. "--" .. header.identifier
        -- A heading of the gallery stays with its first tiles: where they would not fit, the page ends.
        local room = page == "gallery" and header.level == 2
        return room and { pandoc.RawBlock("latex", "\\room{9cm}"), header } or header
    end,
    Link = function(link)
        local name, anchor = link.target:match("^([%w_]*)%.?h?t?m?l?#?(.*)$")
        if link.target:match("^#") then
            link.target = "#" .. page .. "--" .. link.target:sub(2)
        elseif link.target:match("^[%w_]+%.html") then
            link.target = "#" .. name .. (anchor ~= "" and "--" .. anchor or "")
        end
        return link
    end,
    CodeBlock = function(block)
        if block.identifier ~= "" then
            block.identifier = page .. "--" .. block.identifier
        end
        return block
    end,
    Div = function(div)
        if div.identifier ~= "" then
            div.identifier = page .. "--" .. div.identifier
        end
        return div
    end,
}

return paper
