// Arrays that grow, and large ones.
#pragma once

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#ifdef __linux__
#include <sys/mman.h>
#endif

#define CACHE_LINE 64
#define LARGE_PAGE ((size_t)2 << 20)

// Memory to free() again, aligned for the cache; in large pages where it is large and the system has them: making small ones, and
// looking up where each lies, costs as much as using them.
static inline void *array_allocate(size_t bytes)
{
    void *memory = NULL;
    if (posix_memalign(&memory, bytes < LARGE_PAGE ? CACHE_LINE : LARGE_PAGE, bytes + (bytes == 0)))
        return NULL;
#ifdef MADV_HUGEPAGE
    if (bytes >= LARGE_PAGE)
        madvise(memory, bytes, MADV_HUGEPAGE); // a wish; that it fails is no error
#endif
    return memory;
}

// For a program of many photon passes, at its start: what it gives back stays with it, up to so much. The system would clear it
// anew for each of them, which is a tenth of a pass's time. Not for the preview, which stays open.
static inline void array_keep_memory(void)
{
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 1 << 30);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
#endif
}

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
