// Text that came from a student's program, a compiler or a file's name, made fit for terminals, JSON, XML, HTML, TAP.
#pragma once

#include "base/error.h"

#include <stddef.h>
#include <stdio.h>

// A copy that any of them can hold: valid UTF-8; control characters as their pictures (␛), line ends and tabs as they
// are; nothing that turns the direction of writing; of more than `most` bytes the middle is left out, saying so.
// The caller frees it. NULL: no memory.
char *text_clean(const char *bytes, size_t size, size_t most);

// Bytes of the UTF-8 character at `at`, 1 to 4, and its number; 0: there is none that is valid. `left` bytes are there.
size_t text_character(const unsigned char *at, size_t left, unsigned long *code);

void text_markup(FILE *stream, const char *text); // with &lt; and so on, for HTML and XML, inside quotes too
// As fprintf, of %s, %d and %% alone, the texts with &lt; and so on.
void text_put(FILE *stream, const char *format, ...) PRINTF_LIKE(2, 3);
void text_quoted(FILE *stream, const char *text); // "…" as YAML has it, on one line
void text_base64(FILE *stream, const unsigned char *bytes, size_t size);

// Points without needless zeros: "6", "2.5". Returns `words`.
const char *text_points(double points, char *words, size_t size);

// The anchor of a mistake's tile in the notes' gallery.
void text_of_tile(const char *step, const char *mistake, char *anchor, size_t size);
