#include "steps/steps.h"
#include "base/file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define DIVIDER        "----\n" // a line between two hints
#define MOST_HINT_SIZE 100000

// From the library's directory up, the first that has this step's hints below it.
static char *read_hints(const StepInfo *step, Error *error)
{
    char directory[2048], path[4096];
    size_t size;
    steps_library_directory(directory, sizeof directory);
    for (char *end = directory + strlen(directory); end; end = strrchr(directory, '/')) {
        *end = '\0';
        snprintf(path, sizeof path, "%s/lib/steps/hints/%s.txt", directory, strchr(step->file, '/') + 1);
        char *text = file_read(path, MOST_HINT_SIZE, &size, NULL);
        if (text)
            return text;
    }
    snprintf(path, sizeof path, "lib/steps/hints/%s.txt", strchr(step->file, '/') + 1);
    return file_read(path, MOST_HINT_SIZE, &size, error);
}

char *step_hint(const StepInfo *step, int level, Error *error)
{
    char *text = read_hints(step, error), *part = text;
    for (int i = 1; part && i < level; i++) {
        part = strstr(part, DIVIDER);
        part = part ? part + strlen(DIVIDER) : NULL;
    }
    if (!part) {
        error_set(error, "step %s: its hints have no part %d", step->id, level);
        free(text);
        return NULL;
    }
    char *end = strstr(part, DIVIDER);
    if (end)
        *end = '\0';
    memmove(text, part, strlen(part) + 1);
    return text;
}
