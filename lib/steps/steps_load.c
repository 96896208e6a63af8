// Fills the slots from objects: the reference's, and a student's where there are some.
#define _GNU_SOURCE // dladdr
#include "steps/steps.h"
#include "base/file.h"

#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define MOST_OBJECT_BYTES (1u << 30)

void steps_library_directory(char *directory, size_t size)
{
    Dl_info info = {.dli_fname = NULL};
    dladdr((const void *)&step_table, &info);
    const char *slash = info.dli_fname ? strrchr(info.dli_fname, '/') : NULL;
    snprintf(directory, size, "%.*s", slash ? (int)(slash - info.dli_fname) : 1, slash ? info.dli_fname : ".");
}

// An ELF file ends with its table of sections. The loader looks no farther than the code, and dies of what is missing.
static bool is_cut_off(const char *bytes, size_t size)
{
    uint64_t table;
    uint16_t row, rows;
    if (size < 64 || memcmp(bytes, "\177ELF\2", 5) != 0)
        return false; // another kind, which the loader judges
    memcpy(&table, bytes + 0x28, sizeof table);
    memcpy(&row, bytes + 0x3a, sizeof row);
    memcpy(&rows, bytes + 0x3c, sizeof rows);
    return table > size || (uint64_t)row * rows > size - table;
}

// What can be said before any of its code runs. A stub calls todo(), so its object names that symbol.
static bool look_at_object(const StepInfo *step, const char *path, StepState *state, Error *error)
{
    const char symbol[] = "\0photonlab_step_not_started"; // the 0 at both ends counts
    const char other[] = "\0_photonlab_step_not_started"; // as other systems spell it
    size_t size;
    Error why = {""};
    char *bytes = file_read(path, MOST_OBJECT_BYTES, &size, &why);
    if (!bytes)
        return error_set(error, "step %s: %s", step->id, why.message);
    bool whole = !is_cut_off(bytes, size);
    bool stub = memmem(bytes, size, symbol, sizeof symbol) || memmem(bytes, size, other, sizeof other);
    *state = stub ? STEP_NOT_STARTED : STEP_STUDENT;
    free(bytes);
    return whole || error_set(error, "step %s: %s is cut off; build it again", step->id, path);
}

bool steps_load_slot(const StepInfo *step, const char *path, Error *error)
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
        if (access(path, R_OK) == 0 && !look_at_object(step, path, &step_states[i], error))
            return false;
    }
    if (step_states[i] != STEP_STUDENT)
        snprintf(path, sizeof path, "%s/solutions/%s.so", library, step->file);
    if (access(path, R_OK) != 0)
        return error_set(error, "step %s: no reference solution at %s; run `make`", step->id, path);
    // dlopen looks for a bare name in the system's directories; ours are never bare, as step->file has a slash.
    return steps_load_slot(step, path, error);
}

// A misspelt object would go unnoticed, with the reference in its place.
static bool check_name(const char *student_dir, const char *folder, const char *name, Error *error)
{
    size_t length = strlen(name);
    if (length < 3 || strcmp(name + length - 3, ".so") != 0)
        return true;
    char file[512];
    snprintf(file, sizeof file, "%s/%.*s", folder, (int)length - 3, name);
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (strcmp(file, step_table[i].file) == 0)
            return true;
    return error_set(error, "%s/%s/%s: no step has this name; solutions/%s/ shows what they are called", student_dir,
                     folder, name, folder);
}

static bool check_student_dir(const char *student_dir, Error *error)
{
#define STAGE(number, scene) "/" FOLDER,
    static const char *const folders[] = {
        "",
#include "steps/steps.def"
    };
    bool ok = true;
    for (size_t i = 0; ok && i < sizeof folders / sizeof *folders; i++) {
        char path[4096];
        snprintf(path, sizeof path, "%s%s", student_dir, folders[i]);
        DIR *directory = opendir(path);
        if (!directory && i == 0)
            return error_set(error, "%s: is no directory of steps: %s", student_dir, strerror(errno));
        for (struct dirent *entry; i > 0 && directory && ok && (entry = readdir(directory));)
            ok = check_name(student_dir, folders[i] + 1, entry->d_name, error);
        if (directory)
            closedir(directory);
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
