// Arrays that grow.
#ifndef PHOTONLAB_BASE_ARRAY_H
#define PHOTONLAB_BASE_ARRAY_H

#include <stddef.h>
#include <stdlib.h>

// Makes sure that items[count] may be written: returns the array, larger and moved where it was full. NULL when memory
// is short: the old array stays as it is.
static inline void *array_reserve(void *items, size_t count, size_t *capacity, size_t item_size)
{
    if (count < *capacity)
        return items;
    size_t larger = *capacity ? *capacity * 2 : 64;
    void *moved = realloc(items, larger * item_size);
    if (moved)
        *capacity = larger;
    return moved;
}

#endif
