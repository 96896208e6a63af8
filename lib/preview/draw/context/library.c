#include "preview/draw/context/library.h"

#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

bool library_load(const char *name, const char *const files[], const LibraryFunction *functions, const char **missing)
{
    const char *hidden = getenv("PHOTONLAB_WITHOUT");
    void *library = NULL;
    *missing = NULL;
    for (; !(hidden && strstr(hidden, name)) && *files && !library; files++)
        library = dlopen(*files, RTLD_NOW | RTLD_LOCAL);
    for (; library && functions->name && !*missing; functions++) {
        void *address = dlsym(library, functions->name);
        memcpy(functions->function, &address, sizeof address); // POSIX: both kinds of pointer have one size and form
        *missing = address ? NULL : functions->name;
    }
    return library && !*missing;
}
