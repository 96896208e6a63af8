// Text at a terminal: as wide as it is, in colour where there is one, and without what would upset it.
#ifndef PHOTONLAB_JUDGE_TERMINAL_H
#define PHOTONLAB_JUDGE_TERMINAL_H

#include <stdbool.h>
#include <stddef.h>

#define MOST_LINES 20 // of what a step printed

typedef struct {
    int width; // columns
    bool colour;
} Terminal;

Terminal terminal_find(void);

// An escape sequence, where colours are seen.
void terminal_paint(const Terminal *terminal, const char *code);

// Columns that the text takes: characters, but those that sit on the one before.
int terminal_columns(const char *text, size_t size);

// A copy without what is no text, to be freed; without memory for it the program ends.
char *terminal_clean(const char *text);

// Breaks the text at blanks where a line is full. A word longer than a line stays whole: it may be a path to copy.
void print_wrapped(const Terminal *terminal, const char *text);

// Lines as they stand, since a compiler's point at columns: the first `before`, and with them the last that MOST_LINES has room
// for.
void print_lines(const char *text, size_t before);

// The same as print_wrapped, less bright: both texts as one.
void print_dim(const Terminal *terminal, const char *before, const char *text);

#endif
