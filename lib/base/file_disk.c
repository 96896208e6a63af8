// Files on a disk.
#include "base/file.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static bool refuse_irregular(const char *path, const struct stat *status, Error *error)
{
    return error_set(error, "%s: is %s; expected a file", path,
                     S_ISDIR(status->st_mode) ? "a directory" : "not a regular file");
}

char *file_read(const char *path, size_t most, size_t *size, Error *error)
{
    struct stat status;
    FILE *stream = NULL;
    char *bytes = NULL;
    bool is_there = stat(path, &status) == 0;
    if (is_there && !S_ISREG(status.st_mode)) // before opening: a pipe would wait for ever
        refuse_irregular(path, &status, error);
    else if (is_there && (unsigned long long)status.st_size > most)
        error_set(error, "%s: is %lld bytes long; expected at most %zu", path, (long long)status.st_size, most);
    else if (!is_there || !(stream = fopen(path, "rb")))
        error_set(error, "%s: cannot be read: %s", path, strerror(errno));
    else if (!(bytes = malloc((size_t)status.st_size + 1)))
        error_set(error, "%s: no memory for %zu bytes", path, (size_t)status.st_size);
    else
        *size = fread(bytes, 1, (size_t)status.st_size, stream);
    if (bytes && ferror(stream)) {
        error_set(error, "%s: cannot be read: %s", path, strerror(errno));
        free(bytes);
        bytes = NULL;
    }
    if (bytes)
        bytes[*size] = '\0';
    if (stream)
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

// Renaming would put the file in the place of a link, too.
static bool find_place(FileWriter *writer, Error *error)
{
    struct stat status;
    if (lstat(writer->path, &status) != 0 || !S_ISLNK(status.st_mode))
        snprintf(writer->place, sizeof writer->place, "%s", writer->path);
    else if (!realpath(writer->path, writer->place))
        return error_set(error, "%s: is a link that leads nowhere: %s", writer->path, strerror(errno));
    return true;
}

static char unfinished[sizeof((FileWriter *)NULL)->beside];

static void note_unfinished(const char *path)
{
#pragma omp critical(file_unfinished)
    snprintf(unfinished, sizeof unfinished, "%s", path);
}

static void remove_unfinished(int number)
{
    unlink(unfinished);
    signal(number, SIG_DFL);
    raise(number);
}

void file_clean_up_when_ended(void)
{
    const int ends[] = {SIGINT, SIGTERM, SIGHUP};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++)
        if (signal(ends[i], remove_unfinished) == SIG_IGN)
            signal(ends[i], SIG_IGN); // as nohup wants it
}

// Two programs never share a name, since it holds the process number; the attempt's number avoids files that a killed
// program left behind.
bool file_write_begin(FileWriter *writer, const char *path, Error *error)
{
    *writer = (FileWriter){.path = path};
    if (!may_replace(path, error) || !find_place(writer, error))
        return false;
    errno = EEXIST;
    for (int attempt = 0; attempt < 100 && !writer->stream && errno == EEXIST; attempt++) {
        int length =
            snprintf(writer->beside, sizeof writer->beside, "%s.tmp-%ld-%d", writer->place, (long)getpid(), attempt);
        if (length < (int)sizeof writer->beside)
            writer->stream = fopen(writer->beside, "wbx");
        else
            errno = ENAMETOOLONG;
    }
    if (writer->stream)
        note_unfinished(writer->beside);
    return writer->stream || error_set(error, "%s: cannot be written: %s", path, strerror(errno));
}

bool file_may_write(const char *path, Error *error)
{
    FileWriter writer;
    if (!file_write_begin(&writer, path, error))
        return false;
    file_write_end(&writer, false, NULL);
    return true;
}

bool file_write_end(FileWriter *writer, bool keep, Error *error)
{
    bool written = !ferror(writer->stream);
    written = fclose(writer->stream) == 0 && written;
    if (keep && !written)
        keep = error_set(error, "%s: cannot be written: %s", writer->path, strerror(errno));
    if (keep && rename(writer->beside, writer->place) != 0)
        keep = error_set(error, "%s: cannot be put in place: %s", writer->path, strerror(errno));
    if (!keep)
        remove(writer->beside);
    note_unfinished("");
    return keep;
}
