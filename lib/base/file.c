#include "base/file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static bool refuse_irregular(const char *path, const struct stat *status, Error *error)
{
    return error_set(error, "%s: is %s; expected a file", path,
                     S_ISDIR(status->st_mode) ? "a directory" : "not a regular file");
}

// Reads what the stream has, which `size` promises.
static char *read_stream(FILE *stream, const char *path, size_t *size, Error *error)
{
    char *bytes = malloc(*size + 1);
    if (!bytes) {
        error_set(error, "%s: no memory for %zu bytes", path, *size);
        return NULL;
    }
    *size = fread(bytes, 1, *size, stream);
    if (ferror(stream)) {
        error_set(error, "%s: cannot be read: %s", path, strerror(errno));
        free(bytes);
        return NULL;
    }
    bytes[*size] = '\0';
    return bytes;
}

char *file_read(const char *path, size_t most, size_t *size, Error *error)
{
    struct stat status;
    if (stat(path, &status) != 0) {
        error_set(error, "%s: cannot be read: %s", path, strerror(errno));
        return NULL;
    }
    if (!S_ISREG(status.st_mode)) { // before opening: a pipe would wait for ever
        refuse_irregular(path, &status, error);
        return NULL;
    }
    if ((unsigned long long)status.st_size > most) {
        error_set(error, "%s: is %lld bytes long; expected at most %zu", path, (long long)status.st_size, most);
        return NULL;
    }
    FILE *stream = fopen(path, "rb");
    if (!stream) {
        error_set(error, "%s: cannot be read: %s", path, strerror(errno));
        return NULL;
    }
    *size = (size_t)status.st_size;
    char *bytes = read_stream(stream, path, size, error);
    fclose(stream);
    return bytes;
}

// Renaming would put a file in the place of a device or a write-protected file without asking.
static bool may_replace(const char *path, Error *error)
{
    struct stat status;
    if (stat(path, &status) != 0)
        return true; // nothing there yet; what else is wrong shows when the file is created
    if (!S_ISREG(status.st_mode))
        return refuse_irregular(path, &status, error);
    if (access(path, W_OK) != 0)
        return error_set(error, "%s: cannot be written: %s", path, strerror(errno));
    return true;
}

// Two programs never share a name, since it holds the process number; the attempt's number avoids files that a killed
// program left behind.
static FILE *create_beside(const char *path, char *beside, size_t size)
{
    int file = -1;
    for (int attempt = 0; attempt < 100; attempt++) {
        snprintf(beside, size, "%s.tmp-%ld-%d", path, (long)getpid(), attempt);
        file = open(beside, O_WRONLY | O_CREAT | O_EXCL, 0666);
        if (file >= 0 || errno != EEXIST)
            break;
    }
    if (file < 0)
        return NULL;
    FILE *stream = fdopen(file, "wb");
    if (!stream) {
        close(file);
        remove(beside);
    }
    return stream;
}

bool file_write_begin(FileWriter *writer, const char *path, Error *error)
{
    *writer = (FileWriter){NULL, NULL, NULL};
    if (!may_replace(path, error))
        return false;
    size_t length = strlen(path);
    writer->path = malloc(length + 1);
    writer->beside = malloc(length + 64);
    if (writer->path && writer->beside) {
        memcpy(writer->path, path, length + 1);
        writer->stream = create_beside(path, writer->beside, length + 64);
    }
    if (writer->stream)
        return true;
    error_set(error, "%s: cannot be written: %s", path, strerror(errno));
    free(writer->path);
    free(writer->beside);
    return false;
}

bool file_write_end(FileWriter *writer, bool keep, Error *error)
{
    bool good = keep;
    bool written = !ferror(writer->stream);
    if (fclose(writer->stream) != 0)
        written = false;
    if (good && !written)
        good = error_set(error, "%s: cannot be written: %s", writer->path, strerror(errno));
    if (good && rename(writer->beside, writer->path) != 0)
        good = error_set(error, "%s: cannot be put in place: %s", writer->path, strerror(errno));
    if (!good)
        remove(writer->beside);
    free(writer->path);
    free(writer->beside);
    return good;
}
