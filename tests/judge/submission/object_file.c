#include "judge/submission/object_file.h"
#include "base/file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST_BYTES   (64u << 20)
#define MOST_SYMBOLS 200000u

bool object_take(const ObjectBytes *file, uint64_t offset, void *to, size_t size)
{
    if (offset > file->size || size > file->size - offset)
        return false;
    memcpy(to, file->bytes + offset, size);
    return true;
}

void object_name(const ObjectBytes *file, uint64_t table, uint64_t table_size, uint64_t offset, char *name, size_t size)
{
    name[0] = '\0';
    if (table > file->size || table_size > file->size - table || offset >= table_size)
        return;
    snprintf(name, size, "%.*s", (int)(table_size - offset < size ? table_size - offset : size),
             (const char *)file->bytes + table + offset);
}

bool object_reserve(ObjectFile *object, size_t count)
{
    if (count > MOST_SYMBOLS)
        return false;
    ObjectSymbol *symbols = realloc(object->symbols, (object->count + count + 1) * sizeof *symbols);
    object->symbols = symbols ? symbols : object->symbols;
    return symbols != NULL;
}

void object_add(ObjectFile *object, SymbolKind kind, const char *name)
{
    object->runs_at_load = object->runs_at_load || kind == SYMBOL_AT_LOAD;
    if (kind == SYMBOL_OTHER || !name[0])
        return;
    ObjectSymbol *to = &object->symbols[object->count++];
    to->kind = kind;
    snprintf(to->name, sizeof to->name, "%s", name);
}

bool object_read(const char *path, ObjectFile *object, Error *error)
{
    ObjectBytes file;
    *object = (ObjectFile){NULL, 0, false, false};
    char *bytes = file_read(path, MOST_BYTES, &file.size, error);
    if (!bytes)
        return false;
    file.bytes = (const unsigned char *)bytes;
    bool ok = object_read_format(&file, object);
    free(bytes);
    if (!ok)
        object_free(object);
    return ok || error_set(error, "%s: is no object file of this machine's", path);
}

void object_free(ObjectFile *object)
{
    free(object->symbols);
    *object = (ObjectFile){NULL, 0, false, false};
}
