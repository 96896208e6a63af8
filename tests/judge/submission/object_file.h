// A relocatable object file, as far as the judge has to know it. Reads strictly: everything in it comes from a
// student's source.
#pragma once

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum {
    SYMBOL_WANTED,   // from elsewhere
    SYMBOL_FUNCTION, // seen from outside
    SYMBOL_PRIVATE,  // a static function
    SYMBOL_VARIABLE, // that can be written to
    SYMBOL_AT_LOAD,  // a function that the loader calls by itself
    SYMBOL_OTHER
} SymbolKind;

typedef struct {
    SymbolKind kind;
    char name[128];
} ObjectSymbol;

typedef struct {
    ObjectSymbol *symbols;
    size_t count;
    bool keeps_data;   // a section that can be written to holds something, named or not
    bool runs_at_load; // has constructors or destructors
} ObjectFile;

bool object_read(const char *path, ObjectFile *object, Error *error);
void object_free(ObjectFile *object);

// ---- what the readers share; one of them, object_elf.c or object_macho.c, is built into the judge

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
