// Shared libraries that the program does without when they are missing.
#pragma once

#include <stdbool.h>

typedef struct {
    const char *name;
    void *function; // points to a pointer to function of the right type
} LibraryFunction;

// Opens the first file of `files` (ends with NULL) that is there, and fills in the functions (end with NULL). False:
// *missing is the name of one that the library has not, or NULL when there is no such file. It is never closed again:
// drivers leave threads and exit handlers behind that would run into a hole. PHOTONLAB_WITHOUT=osmesa,egl,glfw in the
// environment hides the libraries of these names, so that their absence can be tested.
bool library_load(const char *name, const char *const files[], const LibraryFunction *functions, const char **missing);
