// Mach-O, 64 bits: the object files of a Mac. Its structs stand here and not in Apple's headers' words, so that a test can read
// such files on any machine.
#include "judge/submission/object_file.h"

#include <string.h>

#define MAGIC 0xfeedfacfu
enum { RELOCATABLE = 1, SEGMENT = 0x19, SYMBOLS = 2, MOST_SECTIONS = 255 };
typedef struct {
    uint32_t magic, processor, processor_kind, file_type, command_count, commands_size, flags, reserved;
} Head;
typedef struct {
    uint32_t command, size;
} Command;
typedef struct {
    Command command;
    char name[16];
    uint64_t address, memory_size, offset, file_size;
    uint32_t most_rights, rights, section_count, flags;
} Segment;
typedef struct {
    char name[16], segment[16]; // not ended by a zero when full
    uint64_t address, size;
    uint32_t offset, align, relocations, relocation_count, flags, reserved[3];
} Section;
typedef struct {
    Command command;
    uint32_t offset, count, names, names_size;
} SymbolTable;
typedef struct {
    uint32_t name;
    uint8_t type, section; // counted from 1
    uint16_t description;
    uint64_t value;
} Symbol;

enum { FROM_DEBUGGER = 0xe0, WHERE = 0x0e, ELSEWHERE = 0x0, IN_SECTION = 0xe, IS_SEEN = 1, IS_RESOLVER = 0x100 };

typedef struct {
    Section sections[MOST_SECTIONS];
    size_t count;
} Sections;

static bool is_run_at_load(const Section *section)
{
    uint32_t type = section->flags & 0xff; // pointers to constructors, to destructors, and offsets of constructors
    return type == 0x9 || type == 0xa || type == 0x16;
}

// Every segment but some. In __DATA a section __const is written once, by the loader: constants that hold addresses.
static bool is_writable(const Section *section)
{
    static const char *const constant[] = {"__TEXT", "__DWARF", "__LD", "__LLVM"};
    for (size_t i = 0; i < sizeof constant / sizeof *constant; i++)
        if (strncmp(section->segment, constant[i], sizeof section->segment) == 0)
            return false;
    return !is_run_at_load(section) && strncmp(section->name, "__const", sizeof section->name) != 0;
}

static bool holds_code(const Section *section)
{
    return section->flags & 0x80000400; // instructions alone, or some
}

static SymbolKind kind_of(const Sections *there, const Symbol *symbol)
{
    bool seen = symbol->type & IS_SEEN;
    if (symbol->type & FROM_DEBUGGER)
        return SYMBOL_OTHER;
    if ((symbol->type & WHERE) == ELSEWHERE && seen)
        return symbol->value ? SYMBOL_VARIABLE : SYMBOL_WANTED; // with a size: the linker makes room for it
    if ((symbol->type & WHERE) != IN_SECTION || symbol->section < 1 || symbol->section > there->count)
        return SYMBOL_OTHER;
    const Section *section = &there->sections[symbol->section - 1];
    if (symbol->description & IS_RESOLVER)
        return SYMBOL_AT_LOAD;
    if (is_writable(section))
        return SYMBOL_VARIABLE;
    return !holds_code(section) ? SYMBOL_OTHER : seen ? SYMBOL_FUNCTION : SYMBOL_PRIVATE;
}

static bool read_sections(const ObjectBytes *file, uint64_t at, Sections *there, ObjectFile *object)
{
    Segment segment;
    if (!object_take(file, at, &segment, sizeof segment) || segment.section_count > MOST_SECTIONS - there->count)
        return false;
    at += sizeof segment;
    for (uint32_t i = 0; i < segment.section_count; i++, at += sizeof(Section)) {
        Section *section = &there->sections[there->count++];
        if (!object_take(file, at, section, sizeof *section))
            return false;
        object->runs_at_load = object->runs_at_load || (section->size > 0 && is_run_at_load(section));
        object->keeps_data = object->keeps_data || (section->size > 0 && is_writable(section));
    }
    return true;
}

// A name in C has an underscore before it here; what has none is the assembler's own.
static bool read_symbols(const ObjectBytes *file, uint64_t at, const Sections *there, ObjectFile *object)
{
    SymbolTable table;
    if (!object_take(file, at, &table, sizeof table) || !object_reserve(object, table.count))
        return false;
    for (uint32_t i = 0; i < table.count; i++) {
        Symbol symbol;
        char name[1 + sizeof object->symbols->name];
        if (!object_take(file, table.offset + (uint64_t)i * sizeof symbol, &symbol, sizeof symbol))
            return false;
        object_name(file, table.names, table.names_size, symbol.name, name, sizeof name);
        object_add(object, kind_of(there, &symbol), name[0] == '_' ? name + 1 : "");
    }
    return true;
}

bool object_read_format(const ObjectBytes *file, ObjectFile *object)
{
    Head head;
    Sections there = {.count = 0};
    bool ok = object_take(file, 0, &head, sizeof head) && head.magic == MAGIC && head.file_type == RELOCATABLE;
    uint64_t at = sizeof head;
    // Segments come before the symbols that lie in them.
    for (uint32_t i = 0; ok && i < head.command_count; i++) {
        Command command;
        ok = object_take(file, at, &command, sizeof command) && command.size >= sizeof command;
        if (ok && command.command == SEGMENT)
            ok = read_sections(file, at, &there, object);
        if (ok && command.command == SYMBOLS)
            ok = read_symbols(file, at, &there, object);
        at += ok ? command.size : 0;
    }
    return ok;
}
