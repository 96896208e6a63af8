// base/file.h where there is no disk: files that JavaScript put here, and takes away.
#include "base/file.h"
#include "web/module/web.h"

#include <stdlib.h>

#define MOST_FILES 32
typedef struct {
    char name[256];
    char *bytes; // with a 0 behind the last
    size_t size;
} MemoryFile;
static MemoryFile files[MOST_FILES];

static MemoryFile *find(const char *name)
{
    for (int i = 0; i < MOST_FILES; i++)
        if (strcmp(files[i].name, name) == 0)
            return &files[i];
    return NULL;
}

// The bytes, from malloc, are the file's from now on. False: there are too many.
bool EXPORT(web_put_file)(const char *name, char *bytes, size_t size)
{
    MemoryFile *file = find(name);
    if (!file)
        file = find("");
    if (!file)
        return false;
    free(file->bytes);
    snprintf(file->name, sizeof file->name, "%s", name);
    file->bytes = bytes;
    file->size = size;
    return true;
}

const char *EXPORT(web_file)(const char *name) // NULL: there is none
{
    MemoryFile *file = find(name);
    return file ? file->bytes : NULL;
}

size_t EXPORT(web_file_size)(const char *name)
{
    MemoryFile *file = find(name);
    return file ? file->size : 0;
}

char *file_read(const char *path, size_t most, size_t *size, Error *error)
{
    const MemoryFile *file = find(path);
    if (!file || file->size > most) {
        error_set(error, file ? "%s: is too long" : "%s: cannot be read: there is no such file", path);
        return NULL;
    }
    char *copy = malloc(file->size + 1);
    if (copy) {
        memcpy(copy, file->bytes, file->size);
        copy[file->size] = '\0';
        *size = file->size;
    } else
        error_set(error, "%s: no memory for %zu bytes", path, file->size);
    return copy;
}

static char *written; // by the one file that is being written
static size_t written_size;

bool file_write_begin(FileWriter *writer, const char *path, Error *error)
{
    *writer = (FileWriter){.path = path, .stream = open_memstream(&written, &written_size)};
    return writer->stream || error_set(error, "%s: not enough memory", path);
}

bool file_write_end(FileWriter *writer, bool keep, Error *error)
{
    bool whole = fclose(writer->stream) == 0;
    if (keep && (!whole || !web_put_file(writer->path, written, written_size)))
        keep = error_set(error, "%s: cannot be written", writer->path);
    if (!keep)
        free(written);
    return keep;
}
