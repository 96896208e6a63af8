#define _GNU_SOURCE // dladdr
#include "steps/steps.h"

#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

Steps steps;
StepState step_states[STEP_COUNT];
static long redraw_caps;

void photonlab_step_not_started(const char *id)
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

void steps_library_directory(char *directory, size_t size)
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
    const char symbol[] = "\0photonlab_step_not_started"; // the 0 at both ends counts
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
        step_states[i] = there ? STEP_NOT_STARTED : STEP_REFERENCE;
    }
    snprintf(path, sizeof path, "%s/solutions/%s.so", library, step->file);
    if (!file_exists(path))
        return error_set(error, "step %s: no reference solution at %s; run `make`", step->id, path);
    return load_slot(step, path, error);
}

// Is there a step of this folder and file name?
static bool is_step(const char *folder, const char *name)
{
    char file[512];
    snprintf(file, sizeof file, "%s/%s", folder, name);
    for (size_t i = 0; i < STEP_COUNT; i++) {
        size_t length = strlen(step_table[i].file);
        if (strncmp(file, step_table[i].file, length) == 0 && strcmp(file + length, ".so") == 0)
            return true;
    }
    return false;
}

// A misspelt object would go unnoticed, with the reference in its place.
static bool check_names(const char *student_dir, const char *folder, Error *error)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", student_dir, folder);
    DIR *directory = opendir(path);
    if (!directory)
        return true;
    bool ok = true;
    for (struct dirent *entry; ok && (entry = readdir(directory));) {
        const char *ending = strrchr(entry->d_name, '.');
        if (ending && strcmp(ending, ".so") == 0 && !is_step(folder, entry->d_name))
            ok = error_set(error, "%s/%s: no step has this name; solutions/%s/ shows what they are called", path,
                           entry->d_name, folder);
    }
    closedir(directory);
    return ok;
}

static bool check_student_dir(const char *student_dir, Error *error)
{
    DIR *directory = opendir(student_dir);
    if (!directory)
        return error_set(error, "%s: is no directory of steps: %s", student_dir, strerror(errno));
    closedir(directory);
    bool ok = true;
    for (size_t i = 0; ok && i < STEP_COUNT; i++) {
        char folder[256];
        snprintf(folder, sizeof folder, "%.*s", (int)strcspn(step_table[i].file, "/"), step_table[i].file);
        ok = check_names(student_dir, folder, error);
    }
    return ok;
}

bool steps_load(const char *student_dir, Error *error)
{
    char library[2048];
    steps_library_directory(library, sizeof library);
    if (student_dir && !check_student_dir(student_dir, error))
        return false;
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (!load_step(i, student_dir, library, error))
            return false;
    steps_play((StepChoice){0});
    return true;
}

// Stands in every slot that a graded step has no business to call.
static void step_is_absent(void)
{
    fprintf(stderr, "photonlab: a step was called that is not there while this one is graded\n");
    abort();
}

static bool load_references(const bool graded[STEP_COUNT], const char *references, Error *error)
{
    void (*absent)(void) = step_is_absent;
    for (size_t i = 0; i < STEP_COUNT; i++) {
        char path[4096];
        snprintf(path, sizeof path, "%s/%s.so", references, step_table[i].file);
        memcpy((char *)&steps + step_table[i].slot, &absent, sizeof absent);
        step_states[i] = graded[i] ? STEP_STUDENT : STEP_REFERENCE;
        if (!graded[i] && file_exists(path) && !load_slot(&step_table[i], path, error))
            return false;
    }
    return true;
}

bool steps_load_graded(const StepInfo *graded, const char *object, const char *references, Error *error)
{
    bool chosen[STEP_COUNT] = {false};
    chosen[graded - step_table] = true;
    return load_references(chosen, references, error) && load_slot(graded, object, error);
}

bool steps_load_several(const bool graded[STEP_COUNT], const char *objects, const char *references, Error *error)
{
    bool ok = load_references(graded, references, error);
    for (size_t i = 0; ok && i < STEP_COUNT; i++) {
        char path[4096];
        snprintf(path, sizeof path, "%s/%s/step.so", objects, step_table[i].id);
        ok = !graded[i] || load_slot(&step_table[i], path, error);
    }
    return ok;
}
