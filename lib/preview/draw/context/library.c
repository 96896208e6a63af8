#include "preview/draw/context/library.h"

#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

static bool is_hidden(const char *name)
{
    const char *list = getenv("PHOTONLAB_WITHOUT");
    size_t length = strlen(name);
    while (list && *list) {
        size_t entry = strcspn(list, ",");
        if (entry == length && memcmp(list, name, length) == 0)
            return true;
        list += entry + (list[entry] == ',');
    }
    return false;
}

void *library_open(const char *name, const char *const files[])
{
    if (is_hidden(name))
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
