// Shared libraries that the program does without when they are missing.
#ifndef PHOTONLAB_PREVIEW_LIBRARY_H
#define PHOTONLAB_PREVIEW_LIBRARY_H

#include <stdbool.h>

// Opens the first file of `files` (ends with NULL) that is there; NULL when none is. It is never closed again: drivers
// leave threads and exit handlers behind that would run into a hole. PHOTONLAB_WITHOUT=osmesa,egl,glfw in the
// environment hides the libraries of these names, so that their absence can be tested.
void *library_open(const char *name, const char *const files[]);

// Puts the address of a function into *function, a pointer to function of the right type. False when there is none.
bool library_function(void *library, const char *name, void *function);

// The same for an address that a library has given: C99 has no cast from one to the other.
void library_address_to_function(void *address, void *function);

#endif
