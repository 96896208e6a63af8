#include "preview/draw/context/library.h"

#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

void *library_open(const char *name, const char *const files[])
{
    const char *hidden = getenv("PHOTONLAB_WITHOUT");
    if (hidden && strstr(hidden, name))
        return NULL;
    for (; *files; files++) {
        void *library = dlopen(*files, RTLD_NOW | RTLD_LOCAL);
        if (library)
            return library;
    }
    return NULL;
}

void library_address_to_function(void *address, void *function)
{
    memcpy(function, &address, sizeof address); // POSIX: both kinds of pointer have one size and form
}

bool library_function(void *library, const char *name, void *function)
{
    void *address = dlsym(library, name);
    library_address_to_function(address, function);
    return address != NULL;
}
