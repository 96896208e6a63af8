// Reading text: whole files, numbers, and names that were nearly right.
#pragma once

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>

// Reads a regular file of 1 … max bytes; a 0 byte follows the last. The caller frees the text. NULL when that
// fails, with "path: what is wrong" in the error.
char *text_read_file(const char *path, size_t max, size_t *size, Error *error);

// Reads a decimal number (1, -.5, 2.5e-3) at *at and moves *at behind it, with a decimal point whatever the locale.
// Too large a number gives infinity. False, and *at stays, when there is no number; 0x10, nan and inf are no numbers.
bool text_number(const char **at, const char *end, double *value);

// Where a word of C first stands by itself, comments aside; NULL: nowhere. And the number of the line that `at` lies in.
const char *text_find_word(const char *source, const char *word);
int text_line_of(const char *text, const char *at);

// Levenshtein 1966: the fewest letters inserted, removed or replaced that turn a into b, capital or not. 64 where one of
// them is that long.
size_t text_distance(const char *a, const char *b);

// Name number i of a list, NULL past the last.
typedef const char *(*TextNameAt)(const void *list, size_t i);

// The number of a name in a list; false, and *number is the list's length, when it is none of them.
bool text_find_name(const char *name, TextNameAt name_at, const void *list, size_t *number);

// What to say of a word that is not in a list: "did you mean 'radius'?" when a name is near, else "expected
// one of: a, b", each name once.
typedef struct {
    char text[400];
} TextLine;
TextLine text_suggest(const char *word, TextNameAt name_at, const void *list);

// snprintf behind the text that is there already; cut off at the end of `size` bytes.
void text_append(char *text, size_t size, const char *format, ...) PRINTF_LIKE(3, 4);
