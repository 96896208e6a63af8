// Headers of the student's own: when one is saved, the steps that include it are built anew.
#include "preview/watch/watch_internal.h"
#include "base/file.h"
#include "math/rng.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST_BYTES (1u << 20) // of what a compiler writes about one object

// The next path of a make rule: parted by blanks, with a backslash before a blank that belongs to it. NULL: no more.
static char *next_path(char **text)
{
    char *from = *text;
    while (*from == ' ' || *from == '\n' || (*from == '\\' && from[1] == '\n'))
        from++;
    char *path = from, *to = from;
    while (*from && *from != ' ' && *from != '\n') {
        from += *from == '\\' && from[1] == ' ';
        *to++ = *from++;
    }
    *text = from + (*from != '\0');
    *to = '\0';
    return path < to ? path : NULL;
}

static bool is_own_header(const Watch *watch, const char *path)
{
    size_t folder = strlen(watch->source), length = strlen(path);
    return length > folder + 2 && strncmp(path, watch->source, folder) == 0 && path[folder] == '/' &&
           strcmp(path + length - 2, ".h") == 0;
}

uint64_t watch_headers(const Watch *watch, size_t i)
{
    char rules[4096];
    size_t size;
    watch_path(rules, watch->objects, i, ".d");
    char *text = file_read(rules, MOST_BYTES, &size, NULL), *rest = text;
    uint64_t sum = 0;
    for (char *path; text && (path = next_path(&rest));)
        if (is_own_header(watch, path))
            sum = watch_fingerprint(hash_u64(sum + 1), path);
    free(text);
    return sum;
}
