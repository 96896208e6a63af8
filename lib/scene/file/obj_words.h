// The words of an OBJ file, one after the other; for obj.c only.
#ifndef PHOTONLAB_SCENE_OBJ_WORDS_H
#define PHOTONLAB_SCENE_OBJ_WORDS_H

#include "scene/file/obj.h"

#include <string.h>

// Goes through the text word by word: comments reach from # to the line's end, a backslash there carries the line on.
typedef struct {
    const char *at, *word_end; // what is left of the word at hand
    const char *end;           // of the text
    long line;                 // from 1
    const char *name;
    const ObjNames *names;
    ObjMesh *mesh;
    uint32_t material; // of the faces to come
    Error *error;
} ObjReader;

static inline bool is_one_of(char c, const char *characters)
{
    return c != '\0' && strchr(characters, c);
}

// Goes on to the next word of the line. False, and none is at hand, at the line's end.
bool obj_next_word(ObjReader *reader);
// Goes on to the next line, at whose first word nobody has looked yet.
void obj_next_line(ObjReader *reader);

bool obj_word_is(const ObjReader *reader, const char *word);

// "name:line: …" in the error; always false.
bool obj_fault(const ObjReader *reader, const char *format, ...) PRINTF_LIKE(2, 3);
// "'7x' is not …": what is left of the word, or at least the character behind it.
bool obj_word_fault(const ObjReader *reader, const char *expected);

#endif
