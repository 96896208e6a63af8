#include "scene/file/obj_lines.h"

#include <string.h>

// The length of a backslash and the line's end behind it; 0 when there is no such thing here.
static size_t continuation_length(const char *at, const char *end)
{
    if (at >= end || *at != '\\')
        return 0;
    size_t length = at + 1 < end && at[1] == '\r' ? 3 : 2;
    return (size_t)(end - at) >= length && at[length - 1] == '\n' ? length : 0;
}

void obj_skip_blanks(ObjCursor *cursor)
{
    while (cursor->at < cursor->end) {
        size_t carried_on = continuation_length(cursor->at, cursor->end);
        if (!carried_on && *cursor->at != ' ' && *cursor->at != '\t' && *cursor->at != '\r')
            break;
        cursor->line += carried_on > 0;
        cursor->at += carried_on ? carried_on : 1;
    }
}

bool obj_at_line_end(ObjCursor *cursor)
{
    obj_skip_blanks(cursor);
    return cursor->at == cursor->end || *cursor->at == '\n' || *cursor->at == '#';
}

bool obj_at_word_end(const ObjCursor *cursor)
{
    return cursor->at == cursor->end || memchr(" \t\r\n\\#", *cursor->at, 6);
}

size_t obj_word_length(const ObjCursor *cursor)
{
    ObjCursor probe = *cursor;
    while (!obj_at_word_end(&probe))
        probe.at++;
    return (size_t)(probe.at - cursor->at);
}

size_t obj_rest_length(const ObjCursor *cursor)
{
    size_t length = 0;
    for (const char *p = cursor->at; p < cursor->end && *p != '\n'; p++) {
        bool blank = *p == ' ' || *p == '\t' || *p == '\r';
        if (*p == '#' && length < (size_t)(p - cursor->at))
            break; // behind a blank; a name may hold the sign inside
        if (!blank)
            length = (size_t)(p - cursor->at) + 1;
    }
    return length;
}

void obj_next_line(ObjCursor *cursor)
{
    bool comment = cursor->at < cursor->end && *cursor->at == '#';
    for (bool carried_on = true; carried_on && cursor->at < cursor->end;) {
        const char *newline = memchr(cursor->at, '\n', (size_t)(cursor->end - cursor->at));
        const char *last = newline ? newline : cursor->end;
        last -= last > cursor->at && last[-1] == '\r';
        carried_on = !comment && last > cursor->at && last[-1] == '\\';
        cursor->line += newline != NULL;
        cursor->at = newline ? newline + 1 : cursor->end;
    }
}
