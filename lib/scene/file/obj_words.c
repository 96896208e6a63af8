#include "scene/file/obj_words.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

// The length of a blank, or of a backslash and the line's end behind it; 0 when there is no such thing here.
static size_t blank_length(const char *at, const char *end)
{
    if (is_one_of(*at, " \t\r"))
        return 1;
    size_t left = (size_t)(end - at), length = left > 2 && at[1] == '\r' ? 3 : 2;
    return *at == '\\' && left >= length && at[length - 1] == '\n' ? length : 0;
}

bool obj_next_word(ObjReader *reader)
{
    const char *at = reader->word_end, *end = reader->end;
    for (size_t length; at < end && (length = blank_length(at, end)); at += length)
        reader->line += length > 1;
    reader->at = reader->word_end = at;
    if (at == end || is_one_of(*at, "\n#"))
        return false;
    static const bool ends[256] = {[' '] = 1, ['\t'] = 1, ['\r'] = 1, ['\n'] = 1, ['\\'] = 1, ['#'] = 1};
    while (at < end && !ends[(unsigned char)*at]) // of a mesh's millions of characters, most come by here
        at++;
    reader->word_end = at > reader->at ? at : at + 1; // a backslash inside a line is a word
    return true;
}

void obj_next_line(ObjReader *reader)
{
    while (obj_next_word(reader))
        ;
    const char *newline = memchr(reader->at, '\n', (size_t)(reader->end - reader->at));
    reader->word_end = newline ? newline + 1 : reader->end;
    reader->line += newline != NULL;
}

bool obj_fault(const ObjReader *reader, const char *format, ...)
{
    char what[700];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    return error_set(reader->error, "%s:%ld: %s", reader->name, reader->line, what);
}

bool obj_word_fault(const ObjReader *reader, const char *expected)
{
    size_t length = (size_t)(reader->word_end - reader->at);
    length = length || reader->at == reader->end ? length : 1;
    return obj_fault(reader, "'%.*s' is not %s", (int)(length < 40 ? length : 40), reader->at, expected);
}

bool obj_word_is(const ObjReader *reader, const char *word)
{
    size_t length = (size_t)(reader->word_end - reader->at);
    return strlen(word) == length && memcmp(word, reader->at, length) == 0;
}
