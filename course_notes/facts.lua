-- What a chapter holds, as lines of words parted by tabs, for the scripts beside:
--
--     figure KIND FILE ID ALT CAPTION COMMAND      KIND: figure, or data and what a terminal shows; in COMMAND, "\n" for a line's end, "\\" for "\"
--     anchor ID LEVEL TITLE                        LEVEL 0: no heading
--     link TARGET SECTION
--     number TEXT FROM SECTION
--     formula KIND SECTION TEX                     KIND: display or inline
--     file PATH SECTION                            `exercises/…` as the text names it
--     image PATH ALT                               beside figures: written by the command of one, too
--
-- Usage: pandoc -f markdown -t plain -o /dev/null --lua-filter facts.lua CHAPTER.md

local section = ""

local function tell(...)
    local words = {}
    for i, word in ipairs({ ... }) do
        words[i] = word:gsub("\\", "\\\\"):gsub("\n", "\\n"):gsub("\t", " ")
    end
    io.stdout:write(table.concat(words, "\t"), "\n")
end

local function figure(block)
    local kind = block.classes:includes("figure") and "figure" or (block.classes:includes("data") or block.classes:includes("terminal")) and "data"
    if kind then
        local a = block.attributes
        tell("figure", kind, a.file or "", block.identifier, a.alt or "", a.caption or "", block.text)
    end
    if block.identifier ~= "" then
        tell("anchor", block.identifier, "0", "")
    end
end

local facts = {
    CodeBlock = figure,
    Div = function(div)
        if div.identifier ~= "" then
            tell("anchor", div.identifier, "0", "")
        end
    end,
    Link = function(link) tell("link", link.target, section) end,
    Image = function(image) tell("image", image.src, pandoc.utils.stringify(image.caption)) end,
    Math = function(math)
        tell("formula", math.mathtype == "DisplayMath" and "display" or "inline", section, math.text)
    end,
    Code = function(code)
        if code.text:match("^exercises/[%w_./-]*$") then
            tell("file", code.text, section)
        end
    end,
    Span = function(span)
        if span.attributes.from then
            tell("number", pandoc.utils.stringify(span), span.attributes.from, section)
        elseif span.identifier ~= "" then
            tell("anchor", span.identifier, "0", "")
        end
    end,
}

function Pandoc(doc)
    for _, block in ipairs(doc.blocks) do
        if block.t == "Header" then
            if block.level <= 2 then
                section = block.identifier
            end
            tell("anchor", block.identifier, tostring(block.level), pandoc.utils.stringify(block))
        end
        -- A caption is Markdown, too.
        pandoc.walk_block(pandoc.Div({ block }), facts)
        pandoc.walk_block(pandoc.Div({ block }), { CodeBlock = function(code)
            for _, inner in ipairs(pandoc.read(code.attributes.caption or "", "markdown").blocks) do
                pandoc.walk_block(pandoc.Div({ inner }), facts)
            end
        end })
    end
    return pandoc.Pandoc({})
end
