# Do the includes follow the pages? Arguments: the pages (lib/README.md, tests/README.md), then all source files.
#
# A page's rows begin with a room in backquotes, and end with the rooms that it may include (and what those may include);
# a row names only rooms above it, so that there is no circle. `x/*` are all folders in x/. Also: a file that a page names
# exists and holds the names that stand on its line; no circle between files; no folder of more than 20 source files.

function fail(text) { print text; failed = 1 }

function folder(path) { return path ~ /\// ? substr(path, 1, match(path, /\/[^\/]*$/) - 1) : "" }

# The room that a file lies in; files that lie directly in lib/ are rooms themselves. "": none.
function room_of(path,    room) {
    if (path in is_room) return path
    room = folder(path)
    if (room in is_room) return room
    return folder(room) "/*" in is_room ? folder(room) "/*" : ""
}

function may_include(from, to,    i) {
    if (from == to) return 1
    for (i = 1; i <= named[from]; i++)
        if (may_include(names[from, i], to)) return 1
    return 0
}

# The file that an include means, or "".
function find_include(name, from,    path) {
    path = folder(from) "/" name
    if (path in is_file) return path
    if (("lib/" name) in is_file) return "lib/" name
    return ("tests/" name) in is_file ? "tests/" name : ""
}

function has_word(path, word,    line, found) {
    while (!found && (getline line < path) > 0) found = index(line, word)
    close(path)
    return found
}

# What is said in backquotes: files that exist, each with one of the words.
function check_line(line,    parts, count, i, found, path, words, files) {
    count = split(line, parts, "`")
    for (i = 2; i <= count; i += 2) {
        path = tree parts[i]
        if (parts[i] ~ /\.(c|h|def|sh|md)$/) {
            if (!has_word(path, "")) fail(FILENAME ":" FNR ": there is no " path)
            files[++files_n] = path
        } else if (parts[i] ~ /^[A-Za-z0-9_]+(\(\))?$/ && !((tree parts[i]) in is_room)) words[++words_n] = parts[i]
    }
    for (i = 1; i <= words_n; i++) {
        sub(/\(\)/, "", words[i])
        found = 0
        for (count = 1; count <= files_n; count++) found = found || has_word(files[count], words[i])
        if (files_n && !found) fail(FILENAME ":" FNR ": `" words[i] "` stands in none of the files on this line")
    }
    files_n = words_n = 0
}

function take_row(    cells, parts, count, i, room, to) {
    count = split($0, cells, "|")
    split(cells[2], parts, "`")
    room = tree parts[2]
    is_room[room] = 1
    where[room] = FILENAME ":" FNR
    count = split(cells[count - 1], parts, "`")
    for (i = 2; i <= count; i += 2) {
        to = (parts[i] ~ /^lib(\/|$)/ ? "" : tree) parts[i]
        if (to != "lib" && !(to in is_room)) fail(where[room] ": " room " → " to ": no room above has this name")
        else names[room, ++named[room]] = to
    }
}

# A circle of includes that leads through this file.
function walk(file, path,    i) {
    if (state[file] == 2) return
    if (state[file] == 1) {
        fail(file ": a circle of includes:" substr(path, index(path, " " file)) " " file)
        return
    }
    state[file] = 1
    for (i = 1; i <= includes[file]; i++) walk(include[file, i], path " " file)
    state[file] = 2
}

BEGIN {
    for (i = 1; i < ARGC; i++) {
        is_file[ARGV[i]] = 1
        if (ARGV[i] !~ /\.md$/ && ++in_folder[folder(ARGV[i])] == 21)
            fail(folder(ARGV[i]) ": holds more than 20 source files")
    }
}

FNR == 1 { tree = substr(FILENAME, 1, index(FILENAME, "/")) }
FILENAME ~ /\.md$/ && /^\| `[a-z_\/.*]+` \|.*\|.*\|$/ { take_row() }
FILENAME ~ /\.md$/ { check_line($0) }

FILENAME ~ /\.md$/ || FILENAME !~ /\.(c|h|def)$/ { next }

FNR == 1 && room_of(FILENAME) == "" { fail(FILENAME ": no page has a room " folder(FILENAME)) }

/^[ \t]*#[ \t]*include[ \t]*"/ {
    split($0, parts, "\"")
    to = find_include(parts[2], FILENAME)
    from = room_of(FILENAME)
    if (to == "") { fail(FILENAME ":" FNR ": there is no file " parts[2]); next }
    include[FILENAME, ++includes[FILENAME]] = to
    to = room_of(to)
    used[from, to] = 1
    if (from == "" || to == "" || may_include(from, to) || (to ~ /^lib\// && may_include(from, "lib"))) next
    fail(FILENAME ":" FNR ": " from " → " to ": " (from ~ /^lib/ ? "lib" : "tests") "/README.md has no such arrow")
}

END {
    for (file in is_file) walk(file, "")
    for (room in named)
        for (i = 1; i <= named[room]; i++)
            if (names[room, i] != "lib" && !((room, names[room, i]) in used))
                fail(where[room] ": " room " → " names[room, i] ": nothing uses this arrow")
    exit failed
}
