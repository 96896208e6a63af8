// Arrays that grow.
#ifndef PHOTONLAB_BASE_ARRAY_H
#define PHOTONLAB_BASE_ARRAY_H

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

// Makes room for `count` items in all. `array` points to the pointer to the first, whatever its type, which changes where
// the array has to move. False when memory is short: the old array stays as it is.
static inline bool array_reserve(void *array, size_t count, size_t *capacity, size_t item_size)
{
    if (count <= *capacity)
        return true;
    size_t larger = *capacity ? *capacity * 2 : 64;
    larger = larger > count ? larger : count;
    void *items;
    memcpy(&items, array, sizeof items);
    items = realloc(items, larger * item_size);
    if (!items)
        return false;
    memcpy(array, &items, sizeof items);
    *capacity = larger;
    return true;
}

// Is there so much memory? Asked for and given back, which a compiler would leave out: to know it before long work.
static inline bool array_has_room(double bytes)
{
    void *volatile room = bytes < (double)(SIZE_MAX / 2) ? malloc((size_t)bytes + 1) : NULL;
    free(room);
    return room != NULL;
}

#endif
