// What went wrong, in words for the person at the terminal. A function that can fail takes an Error * last and
// returns false or NULL; `main` prints the message and exits with 1. The library itself never prints and never exits.
#pragma once

#include <stdbool.h>

typedef struct {
    char message[1024]; // "file:line: what is wrong; what was expected"
} Error;

#define PRINTF_LIKE(text, first) __attribute__((format(printf, text, first)))

// Writes the message (printf style, cut at the buffer's end) unless one stands there already, so that the first cause
// wins. Control characters, which could upset a terminal, become '?'. Always returns false, so that `return error_set(…)` reads well. `error` may be NULL.
bool error_set(Error *error, const char *format, ...) PRINTF_LIKE(2, 3);
