// A relocatable object file, as far as the judge has to know it. Reads strictly: everything in it comes from a
// student's source.
#ifndef PHOTONLAB_JUDGE_OBJECT_FILE_H
#define PHOTONLAB_JUDGE_OBJECT_FILE_H

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>

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

#endif
