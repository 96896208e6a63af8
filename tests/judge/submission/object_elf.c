// ELF, 64 bits: the object files of Linux and most others.
#include "judge/submission/object_file.h"

#include <elf.h>
#include <string.h>

typedef struct {
    ObjectBytes bytes;
    Elf64_Ehdr head;
} File;

static bool section_at(const File *file, size_t i, Elf64_Shdr *section)
{
    return i < file->head.e_shnum &&
           object_take(&file->bytes, file->head.e_shoff + i * sizeof *section, section, sizeof *section);
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
        object_name(&file->bytes, names.sh_offset, names.sh_size, section->sh_name, name, size);
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
    if (!section_at(file, table->sh_link, &names) || !object_reserve(object, count))
        return false;
    for (size_t i = 0; i < count; i++) {
        Elf64_Sym symbol;
        char name[sizeof object->symbols->name];
        if (!object_take(&file->bytes, table->sh_offset + i * sizeof symbol, &symbol, sizeof symbol))
            return false;
        object_name(&file->bytes, names.sh_offset, names.sh_size, symbol.st_name, name, sizeof name);
        object_add(object, kind_of(file, &symbol), name);
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

bool object_read_format(const ObjectBytes *bytes, ObjectFile *object)
{
    File file = {.bytes = *bytes};
    return object_take(bytes, 0, &file.head, sizeof file.head) && memcmp(file.head.e_ident, ELFMAG, SELFMAG) == 0 &&
           file.head.e_ident[EI_CLASS] == ELFCLASS64 && file.head.e_shentsize == sizeof(Elf64_Shdr) &&
           file.head.e_type == ET_REL && read_sections(&file, object);
}
