#define _GNU_SOURCE // dladdr
#include "steps/steps.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

Steps steps;
StepState step_states[STEP_COUNT];
static long redraw_caps;

void todo(const char *id)
{
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (strcmp(step_table[i].id, id) == 0)
            step_states[i] = STEP_NOT_STARTED;
}

void redraw_cap_reached(void)
{
#pragma omp atomic
    redraw_caps++;
}

long redraw_cap_count(void)
{
    return redraw_caps;
}

// The directory that this library lies in, so that solutions are found from wherever the program is started.
static void library_directory(char *directory, size_t size)
{
    Dl_info info;
    snprintf(directory, size, ".");
    if (!dladdr((const void *)&step_table, &info) || !info.dli_fname)
        return;
    const char *slash = strrchr(info.dli_fname, '/');
    if (slash)
        snprintf(directory, size, "%.*s", (int)(slash - info.dli_fname), info.dli_fname);
}

static bool file_exists(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (file)
        fclose(file);
    return file != NULL;
}

// A stub calls todo(), so its object names that symbol. Looked for in the file, before any of its code runs.
static bool object_calls_todo(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (!file)
        return false;
    const char symbol[] = "\0todo"; // both ends of the string count: "\0todo\0"
    size_t matched = 0;
    bool found = false;
    for (int c = getc(file); c != EOF && !found; c = getc(file)) {
        if (matched == 1 && c == '_')
            continue; // the leading underscore of other systems' symbols
        matched = c == symbol[matched] ? matched + 1 : c == '\0';
        found = matched == sizeof symbol;
    }
    fclose(file);
    return found;
}

static bool load_slot(const StepInfo *step, const char *path, Error *error)
{
    void *object = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (!object)
        return error_set(error, "step %s: cannot load %s: %s", step->id, path, dlerror());
    void *function = dlsym(object, step->symbol);
    if (!function)
        return error_set(error, "step %s: %s has no function `%s`; see the prototype in lib/steps/", step->id, path,
                         step->symbol);
    // C has no cast from object to function pointers; POSIX promises that the bytes are the same.
    memcpy((char *)&steps + step->slot, &function, sizeof function);
    return true;
}

static bool load_step(size_t i, const char *student_dir, const char *library, Error *error)
{
    const StepInfo *step = &step_table[i];
    char path[4096];
    step_states[i] = STEP_REFERENCE;
    if (student_dir) {
        snprintf(path, sizeof path, "%s/%s.so", student_dir, step->file);
        // dlopen looks for a bare name in the system's directories; ours are never bare, as step->file has a slash.
        bool there = file_exists(path);
        if (there && !object_calls_todo(path)) {
            step_states[i] = STEP_STUDENT;
            return load_slot(step, path, error);
        }
        step_states[i] = STEP_NOT_STARTED;
    }
    snprintf(path, sizeof path, "%s/solutions/%s.so", library, step->file);
    if (!file_exists(path))
        return error_set(error, "step %s: no reference solution at %s; run `make`", step->id, path);
    return load_slot(step, path, error);
}

bool steps_load(const char *student_dir, Error *error)
{
    char library[2048];
    library_directory(library, sizeof library);
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (!load_step(i, student_dir, library, error))
            return false;
    steps_play((StepChoice){GLOSSY_PHONG, false});
    return true;
}

void steps_play(StepChoice choice)
{
    steps.scatter_glossy =
        choice.glossy == GLOSSY_SOURCE_TEXT ? steps.scatter_glossy_source_text : steps.scatter_glossy_phong;
}

bool step_choice_parse(const char *text, StepChoice *choice, Error *error)
{
    char copy[64];
    *choice = (StepChoice){GLOSSY_PHONG, false};
    if (strlen(text) >= sizeof copy)
        return error_set(error, "--steps %s: expected 2.3 or 2.4, and 1.5 or 3.4, parted by commas", text);
    strcpy(copy, text);
    for (char *word = strtok(copy, ","); word; word = strtok(NULL, ",")) {
        if (strcmp(word, "2.3") == 0)
            choice->glossy = GLOSSY_SOURCE_TEXT;
        else if (strcmp(word, "2.4") == 0)
            choice->glossy = GLOSSY_PHONG;
        else if (strcmp(word, "1.5") == 0)
            choice->loop = true;
        else if (strcmp(word, "3.4") == 0)
            choice->loop = false;
        else
            return error_set(error, "--steps %s: no choice `%s`; expected 2.3 or 2.4, and 1.5 or 3.4, parted by commas",
                             text, word);
    }
    return true;
}
