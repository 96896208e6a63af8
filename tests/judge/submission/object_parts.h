// What the readers of object files share; one of them, object_elf.c or object_macho.c, is built into the judge.
#ifndef PHOTONLAB_JUDGE_OBJECT_PARTS_H
#define PHOTONLAB_JUDGE_OBJECT_PARTS_H

#include "judge/submission/object_file.h"

#include <stdint.h>

typedef struct {
    const unsigned char *bytes;
    size_t size;
} ObjectBytes;

// False where the file ends before that.
bool object_take(const ObjectBytes *file, uint64_t offset, void *to, size_t size);

// A name out of the table of names at `table`; "" when it lies outside.
void object_name(const ObjectBytes *file, uint64_t table, uint64_t table_size, uint64_t offset, char *name,
                 size_t size);

// Room for so many symbols more; false when there are too many.
bool object_reserve(ObjectFile *object, size_t count);
void object_add(ObjectFile *object, SymbolKind kind, const char *name);

// The reader itself: false for what is none of its files.
bool object_read_format(const ObjectBytes *file, ObjectFile *object);

#endif
