// What a look at a submission's files tells, before anything is compiled.
#include "judge/submission/submission.h"
#include "base/file.h"
#include "base/text.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <ftw.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

// Is this a step's source, as a path from the submission's folder?
static bool is_step_file(const char *path)
{
    for (size_t i = 0; i < STEP_COUNT; i++) {
        size_t length = strlen(step_table[i].file);
        if (strncmp(path, step_table[i].file, length) == 0 && strcmp(path + length, ".c") == 0)
            return true;
    }
    return false;
}

// Names the step that a file of this name would be, were it in its place.
static void say_misplaced(const char *code, const char *path)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    size_t length = strlen(name);
    if (length < 3 || strcmp(name + length - 2, ".c") != 0 || is_step_file(path))
        return;
    for (size_t i = 0; i < STEP_COUNT; i++) {
        const char *id = step_table[i].id;
        size_t digits = strlen(id);
        if (strncmp(name, id, digits) != 0 || isdigit((unsigned char)name[digits]))
            continue;
        Error said = {""};
        error_set(&said, "── %s/%s is not graded: step %s is looked for in %s/%s.c", code, path, id, code,
                  step_table[i].file);
        fprintf(stderr, "%s\n", said.message);
    }
}

static const char *looked_into; // the folder, for look_at alone
static Error *look_error;

// Compilers would wait for ever to read from a pipe.
static int look_at(const char *path, const struct stat *status, int kind, struct FTW *place)
{
    const char *name = path + strlen(looked_into);
    name += strspn(name, "/");
    if (kind == FTW_F && !S_ISREG(status->st_mode))
        return !error_set(look_error, "%s: is neither file nor folder; expected one laid out like exercises/", path);
    if (place->level <= 2 && name[0] != '.' && !strstr(name, "/."))
        say_misplaced(looked_into, name);
    return 0;
}

Status words_say(StepWords *words, Status status, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(words->message, sizeof words->message, format, arguments);
    va_end(arguments);
    return status;
}

bool submission_look_over(const char *code, Error *error)
{
    DIR *directory = opendir(code);
    if (!directory)
        return error_set(error, "%s: %s; expected a folder laid out like exercises/", code, strerror(errno));
    closedir(directory);
    looked_into = code;
    look_error = error;
    return nftw(code, look_at, 16, FTW_PHYS) == 0 || error_set(error, "%s: cannot be looked through", code);
}

// The same but for white space?
static bool same_words(const char *a, const char *b)
{
    for (;; a++, b++) {
        while (isspace((unsigned char)*a))
            a++;
        while (isspace((unsigned char)*b))
            b++;
        if (*a != *b)
            return false;
        if (!*a)
            return true;
    }
}

void submission_note_todo(const GradeOptions *options, const StepInfo *step, const char *source, StepWords *words)
{
    char path[4200];
    size_t size;
    Error ignored = {""};
    snprintf(path, sizeof path, "%s/exercises/.stubs/%s.c", options->root, step->file);
    char *stub = file_read(path, 1u << 20, &size, &ignored);
    char *text = file_read(source, 1u << 20, &size, &ignored);
    const char *call = text ? strstr(text, "todo(") : NULL; // a comment may hold it, too
    if (stub && call && !same_words(stub, text))
        words_say(
            words, STATUS_TODO,
            "there is code of yours, but line %d still calls todo(), which says that it is not started: take that "
            "line away",
            text_line_of(text, call));
    free(stub);
    free(text);
}
