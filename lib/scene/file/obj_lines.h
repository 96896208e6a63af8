// Goes through the lines and words of OBJ text: comments from # to the line's end, lines carried on by a
// backslash.
#ifndef PHOTONLAB_SCENE_OBJ_LINES_H
#define PHOTONLAB_SCENE_OBJ_LINES_H

#include <stdbool.h>
#include <stddef.h>

typedef struct {
    const char *at, *end;
    long line; // from 1
} ObjCursor;

// Goes over blanks and carried-on lines.
void obj_skip_blanks(ObjCursor *cursor);
// The same. Is there nothing more on this line?
bool obj_at_line_end(ObjCursor *cursor);
// Does a word end here?
bool obj_at_word_end(const ObjCursor *cursor);
// Characters of the word from here on.
size_t obj_word_length(const ObjCursor *cursor);
// Characters of the line from here on, without a comment and the blanks at its end.
size_t obj_rest_length(const ObjCursor *cursor);
// To the next line, over what is left of this one.
void obj_next_line(ObjCursor *cursor);

#endif
