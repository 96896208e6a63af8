-- The index: for each word the sections that say most about it. A part of figure.lua, which hands over how a chapter is read.
-- In the page's source the words are parted by "·"; other spellings of one follow it after ";".

local MOST = 6 -- sections to a word

local word_index = {}

-- Text in which a word can be found with a blank on both sides.
local function plain(text)
    return " " .. text:lower():gsub("’", "'"):gsub("[%s%.,:;!?()\"“”…/\u{a0}]+", " ") .. " "
end

local function times(text, word)
    local count, at = 0, 1
    while true do
        local first, last = text:find(" " .. word .. " ", at, true)
        if not first then
            return count
        end
        count, at = count + 1, last
    end
end

-- All sections of all chapters: where, title, text, and what stands there in bold letters.
local function sections_of(pages, read)
    local sections = {}
    for _, page in ipairs(pages) do
        local section
        for _, block in ipairs(read(page.name).blocks) do
            if block.t == "Header" and block.level <= 2 then
                local where = page.name .. ".html" .. (block.level == 2 and "#" .. block.identifier or "")
                local title = pandoc.utils.stringify(block)
                section = { where = where, title = block.level == 2 and page.name:match("^%d") and page.name:match("^%d+") .. " " .. title or title,
                            text = {}, bold = {} }
                sections[#sections + 1] = section
            end
            if section and not section.where:match("#reading$") then
                table.insert(section.text, pandoc.utils.stringify(block))
                pandoc.walk_block(pandoc.Div({ block }), { Strong = function(strong)
                    table.insert(section.bold, pandoc.utils.stringify(strong))
                end, Code = function(code)
                    table.insert(section.text, code.text)
                end })
            end
        end
    end
    for _, section in ipairs(sections) do
        section.text = plain(table.concat(section.text, " "))
        section.bold = plain(table.concat(section.bold, " "))
    end
    return sections
end

local function found_in(sections, spellings)
    local found, explained = {}, false
    for i, section in ipairs(sections) do
        local count, bold = 0, 0
        for _, word in ipairs(spellings) do
            count = count + times(section.text, word:lower())
            bold = bold + times(section.bold, word:lower())
        end
        if count > 0 then
            found[#found + 1] = { section = section, count = count, at = i, first = bold > 0 and not explained }
            explained = explained or bold > 0
        end
    end
    table.sort(found, function(a, b)
        if a.first ~= b.first then return a.first end
        return a.count > b.count or a.count == b.count and a.at < b.at
    end)
    return found
end

-- A paragraph to a word; nothing for a word that these pages do not have.
function word_index.entries(text, pages, read)
    local sections, entries = sections_of(pages, read), pandoc.List()
    for entry in (text:gsub("\u{a0}", " ") .. " · "):gmatch("%s*(.-)%s*·") do
        local spellings = {}
        for word in entry:gmatch("[^;]+") do
            spellings[#spellings + 1] = word:match("^%s*(.-)%s*$")
        end
        local found, words = found_in(sections, spellings), pandoc.List({ pandoc.Str(spellings[1] or "") })
        for i = 1, math.min(#found, MOST) do
            local link = pandoc.Link(pandoc.Str((found[i].section.title:gsub(" ", "\u{a0}", 1))), found[i].section.where)
            words:extend({ pandoc.Str(i == 1 and ":" or ";"), pandoc.Space(), found[i].first and pandoc.Strong({ link }) or link })
        end
        if #found > 0 then
            entries:insert(pandoc.Para(words))
        end
    end
    table.sort(entries, function(a, b) return pandoc.utils.stringify(a):lower() < pandoc.utils.stringify(b):lower() end)
    return pandoc.Div(entries, { class = "words" })
end

return word_index
