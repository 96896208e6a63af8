# To be sourced. printable TEXT: a line that upsets no terminal.
printable() { printf '%s' "$1" | tr -d '[:cntrl:]'; echo; }

# json_text: standard input as the inside of a JSON string, on one line.
json_text() {
    LC_ALL=C tr '\n\t' '  ' | LC_ALL=C tr -d '\000-\037\177' | iconv -c -f UTF-8 -t UTF-8 | sed 's/[\\"]/\\&/g; s/ *$//'
}
