// Arrays that grow.
#ifndef PHOTONLAB_SCENE_ARRAY_H
#define PHOTONLAB_SCENE_ARRAY_H

#include <stddef.h>
#include <stdlib.h>

// The array, moved if need be, with room for item number `count`. NULL when memory is short: the old array
// stays as it is.
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
