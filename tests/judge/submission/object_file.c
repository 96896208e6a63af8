#include "judge/submission/object_file.h"
#include "base/file.h"

#include <elf.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST_BYTES   (64u << 20)
#define MOST_SYMBOLS 200000u

typedef struct {
    const unsigned char *bytes;
    size_t size;
    Elf64_Ehdr head;
} File;

static bool take(const File *file, uint64_t offset, void *to, size_t size)
{
    if (offset > file->size || size > file->size - offset)
        return false;
    memcpy(to, file->bytes + offset, size);
    return true;
}

static bool section_at(const File *file, size_t i, Elf64_Shdr *section)
{
    return i < file->head.e_shnum && take(file, file->head.e_shoff + i * sizeof *section, section, sizeof *section);
}

// A name out of a table of names; "" when it lies outside, or does not end.
static void name_at(const File *file, const Elf64_Shdr *table, uint64_t offset, char *name, size_t size)
{
    name[0] = '\0';
    if (table->sh_offset > file->size || table->sh_size > file->size - table->sh_offset || offset >= table->sh_size)
        return;
    snprintf(name, size, "%.*s", (int)(table->sh_size - offset < size ? table->sh_size - offset : size),
             (const char *)file->bytes + table->sh_offset + offset);
}

static bool starts_with(const char *text, const char *start)
{
    return strncmp(text, start, strlen(start)) == 0;
}

// Written once, by the loader: constants that hold addresses.
static bool is_constant(const char *name)
{
    return starts_with(name, ".data.rel.ro") || starts_with(name, ".eh_frame") || starts_with(name, ".got");
}

static bool is_run_at_load(const char *name)
{
    static const char *const starts[] = {".init_array", ".fini_array", ".preinit_array", ".ctors", ".dtors"};
    for (size_t i = 0; i < sizeof starts / sizeof *starts; i++)
        if (starts_with(name, starts[i]))
            return true;
    return strcmp(name, ".init") == 0 || strcmp(name, ".fini") == 0;
}

static void section_name(const File *file, const Elf64_Shdr *section, char *name, size_t size)
{
    Elf64_Shdr names;
    name[0] = '\0';
    if (section_at(file, file->head.e_shstrndx, &names))
        name_at(file, &names, section->sh_name, name, size);
}

static bool is_writable(const File *file, size_t i)
{
    Elf64_Shdr section;
    char name[128];
    if (!section_at(file, i, &section) || !(section.sh_flags & SHF_WRITE) || !(section.sh_flags & SHF_ALLOC))
        return false;
    section_name(file, &section, name, sizeof name);
    return !is_constant(name) && !is_run_at_load(name);
}

static SymbolKind kind_of(const File *file, const Elf64_Sym *symbol)
{
    int type = ELF64_ST_TYPE(symbol->st_info);
    if (type == STT_SECTION || type == STT_FILE)
        return SYMBOL_OTHER;
    if (type == STT_GNU_IFUNC)
        return SYMBOL_AT_LOAD;
    if (symbol->st_shndx == SHN_UNDEF)
        return SYMBOL_WANTED;
    if (symbol->st_shndx == SHN_COMMON || type == STT_COMMON || is_writable(file, symbol->st_shndx))
        return SYMBOL_VARIABLE;
    if (type != STT_FUNC)
        return SYMBOL_OTHER;
    return ELF64_ST_BIND(symbol->st_info) == STB_LOCAL ? SYMBOL_PRIVATE : SYMBOL_FUNCTION;
}

static bool read_symbols(const File *file, const Elf64_Shdr *table, ObjectFile *object)
{
    Elf64_Shdr names;
    size_t count = table->sh_size / sizeof(Elf64_Sym);
    if (count > MOST_SYMBOLS || !section_at(file, table->sh_link, &names))
        return false;
    ObjectSymbol *symbols = realloc(object->symbols, (object->count + count + 1) * sizeof *symbols);
    if (!symbols)
        return false;
    object->symbols = symbols;
    for (size_t i = 0; i < count; i++) {
        Elf64_Sym symbol;
        if (!take(file, table->sh_offset + i * sizeof symbol, &symbol, sizeof symbol))
            return false;
        ObjectSymbol *to = &symbols[object->count];
        to->kind = kind_of(file, &symbol);
        name_at(file, &names, symbol.st_name, to->name, sizeof to->name);
        object->count += to->kind != SYMBOL_OTHER && to->name[0];
        object->runs_at_load = object->runs_at_load || to->kind == SYMBOL_AT_LOAD;
    }
    return true;
}

static bool read_sections(const File *file, ObjectFile *object)
{
    for (size_t i = 0; i < file->head.e_shnum; i++) {
        Elf64_Shdr section;
        char name[128];
        if (!section_at(file, i, &section))
            return false;
        section_name(file, &section, name, sizeof name);
        object->runs_at_load = object->runs_at_load || (section.sh_size > 0 && is_run_at_load(name));
        object->keeps_data = object->keeps_data || (section.sh_size > 0 && is_writable(file, i));
        if (section.sh_type == SHT_SYMTAB && !read_symbols(file, &section, object))
            return false;
    }
    return true;
}

bool object_read(const char *path, ObjectFile *object, Error *error)
{
    *object = (ObjectFile){NULL, 0, false, false};
    File file = {NULL, 0, {{0}, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}};
    char *bytes = file_read(path, MOST_BYTES, &file.size, error);
    if (!bytes)
        return false;
    file.bytes = (const unsigned char *)bytes;
    bool ok = take(&file, 0, &file.head, sizeof file.head) && memcmp(file.head.e_ident, ELFMAG, SELFMAG) == 0 &&
              file.head.e_ident[EI_CLASS] == ELFCLASS64 && file.head.e_shentsize == sizeof(Elf64_Shdr) &&
              file.head.e_type == ET_REL && read_sections(&file, object);
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
