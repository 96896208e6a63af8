// A run that failed in the browser: what the page tells becomes a fault, with function and line.
#include "web/serve/serve.h"
#include "base/parallel.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>

#define LONGEST_LOOK_UP 3.0 // s
#define MOST_PLACES     32

// The module's own words for it; see worker.js.
static bool set_kind(Fault *fault, const char *why)
{
    static const struct {
        const char *why;
        FaultKind kind;
        int signal;
        unsigned long long address;
    } KINDS[] = {{"null", FAULT_SIGNAL, SIGSEGV, 0},  {"bounds", FAULT_SIGNAL, SIGSEGV, 1 << 20},
                 {"divide", FAULT_SIGNAL, SIGFPE, 0}, {"trap", FAULT_SIGNAL, SIGILL, 0},
                 {"abort", FAULT_ABORT, SIGABRT, 0},  {"exit", FAULT_EXIT, 0, 0},
                 {"stack", FAULT_STACK, SIGSEGV, 0},  {"memory", FAULT_MEMORY, 0, 0},
                 {"loop", FAULT_LOOP, SIGUSR1, 0}};
    for (size_t i = 0; i < sizeof KINDS / sizeof *KINDS; i++)
        if (strcmp(KINDS[i].why, why) == 0) {
            fault->kind = KINDS[i].kind;
            fault->signal = KINDS[i].signal;
            fault->address = KINDS[i].address;
            return true;
        }
    return false;
}

static bool set_run(Fault *fault, const char *name)
{
    static const char *const RUNS[] = {"photons", "lobe", "estimates", "disks", "render"};
    for (int i = RUN_PHOTONS; i <= RUN_RENDER; i++)
        if (strcmp(RUNS[i], name) == 0) {
            fault->run = (RunKind)i;
            fault->patience = i <= RUN_LOBE ? 2.0 : 10.0;
            return true;
        }
    return false;
}

// Is it one of the student's files? Headers are the library's, built into the step.
static bool is_students(const SourcePlace *place)
{
    for (size_t i = 0; i < STEP_COUNT; i++) {
        char name[256];
        fault_source_name(step_table[i].file, name, sizeof name);
        if (strcmp(name, place->file) == 0)
            return true;
    }
    return false;
}

static void finish_failure(Tab *tab)
{
    SourcePlace places[MOST_PLACES];
    Fault *fault = &tab->fault;
    int count = crash_places(tab->looked, places, MOST_PLACES);
    for (int i = 0; i < count; i++) {
        if (!is_students(&places[i]))
            continue;
        fault->calls_itself = fault->calls_itself || strcmp(fault->place.function, places[i].function) == 0;
        if (fault->place.line == 0) // what the compiler put in belongs to no line
            fault->place = places[i];
    }
    if (fault->kind == FAULT_LOOP && !fault->place.file[0]) // it was ended from outside
        fault_describe_what(fault, tab->failure, sizeof tab->failure);
    else
        fault_describe(fault, tab->failure, sizeof tab->failure);
    puts(tab->failure);
}

bool tab_poll_failure(Tab *tab)
{
    int status;
    if (tab->looker.pid <= 0)
        return false;
    process_read(&tab->looker, tab->looked, sizeof tab->looked, &tab->looked_size);
    if (!process_has_ended(&tab->looker, &status) && clock_seconds() < tab->look_until)
        return false;
    process_read(&tab->looker, tab->looked, sizeof tab->looked, &tab->looked_size);
    process_kill(&tab->looker);
    finish_failure(tab);
    return true;
}

// Where the module's code begins in its file: what the browser counts from the file's begin, debuggers count from there. 0: it is none.
static unsigned long code_begins(const unsigned char *bytes, size_t size)
{
    size_t at = 8;
    while (at < size) {
        unsigned char section = bytes[at++];
        unsigned long length = 0;
        for (int shift = 0; at < size && shift < 35; shift += 7) {
            length |= (unsigned long)(bytes[at] & 127) << shift;
            if (bytes[at++] < 128)
                break;
        }
        if (section == 10)
            return (unsigned long)at;
        at += length;
    }
    return 0;
}

bool tab_take_failure(Tab *tab, const char *text)
{
    enum { MOST_OFFSETS = 20 };
    static char offsets[MOST_OFFSETS][24];
    const char *arguments[MOST_OFFSETS + 6] = {"llvm-symbolizer", "--output-style=GNU", "-f", "-i", "-e", tab->module};
    Fault fault = {.kind = FAULT_SIGNAL};
    char why[16], run[16];
    int module, megabytes, used;
    unsigned long begin = tab->bytes ? code_begins((const unsigned char *)tab->bytes, tab->size) : 0, offset;
    if (sscanf(text, "%d %15s %15s %d %n", &module, why, run, &megabytes, &used) != 4 || !set_kind(&fault, why) ||
        !set_run(&fault, run))
        return false;
    if (module != tab->module_number || tab->looker.pid > 0 || tab->failure[0])
        return true; // another has taken its place, or it is known
    int count = 0;
    for (text += used; count < MOST_OFFSETS - 1 && sscanf(text, "%lx %n", &offset, &used) == 1; text += used)
        if (offset > begin) {
            snprintf(offsets[count], sizeof offsets[count], "0x%lx", offset - begin);
            arguments[6 + count] = offsets[count];
            count++;
        }
    if (fault.kind == FAULT_LOOP && fault.run != RUN_RENDER &&
        megabytes > WORKER_MEMORY_GB * 64) { // filling it takes time
        fault.kind = FAULT_MEMORY;
        fault.memory_gb = megabytes / 1024.0;
    }
    tab->fault = fault;
    tab->looked_size = 0;
    tab->looked[0] = '\0';
    tab->look_until = clock_seconds() + LONGEST_LOOK_UP;
    if (count == 0 || !process_start(&tab->looker, arguments, PRINTS_OUTPUT)) {
        finish_failure(tab);
        tab->number++;
    }
    return true;
}
