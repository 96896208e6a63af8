// Whole files: reading all of one, and writing one so that it is there in full or not at all.
#pragma once

#include "base/error.h"

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

// The bytes of a regular file of at most `most` bytes, with a 0 byte behind the last; the caller frees them. NULL with
// "path: what is wrong" in the error otherwise.
char *file_read(const char *path, size_t most, size_t *size, Error *error);

// From the last dot of the file's name on; "" when it has none.
static inline const char *file_ending(const char *path)
{
    const char *slash = strrchr(path, '/');
    const char *dot = strrchr(slash ? slash : path, '.');
    return dot ? dot : "";
}

// Does it end in this one, capital or not?
static inline bool file_ends_in(const char *path, const char *ending)
{
    return strcasecmp(file_ending(path), ending) == 0;
}

// Writes a number as four bytes, little-endian on every machine; returns the place behind them.
static inline unsigned char *file_put_int(unsigned char *at, uint32_t value)
{
    for (int i = 0; i < 4; i++)
        *at++ = (unsigned char)(value >> (8 * i));
    return at;
}

static inline unsigned char *file_put_float(unsigned char *at, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return file_put_int(at, bits);
}

// A file being written beside the place it is meant for. `path` is the caller's, and is to stay till the end.
typedef struct {
    FILE *stream; // write here
    const char *path;
    char place[4096]; // where the path leads, when it is a link
    char beside[4096];
} FileWriter;

// Can `path` be written? To be asked before long work; nothing is changed.
bool file_may_write(const char *path, Error *error);

// From now on a signal that ends the program (SIGINT, SIGTERM, SIGHUP) removes the file that it last began to write.
void file_clean_up_when_ended(void);

// Opens a new file next to `path`. Refuses to replace anything but a regular file that may be written.
bool file_write_begin(FileWriter *writer, const char *path, Error *error);

// With `keep`: closes the file and renames it to the path. Otherwise, or when the disk took less than it was given,
// removes it and leaves what stood at the path as it was. True when the file is in place.
bool file_write_end(FileWriter *writer, bool keep, Error *error);
