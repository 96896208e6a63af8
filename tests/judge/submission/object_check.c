// What a step's object tells before any of its code runs.
#include "judge/submission/object_file.h"
#include "judge/submission/submission.h"
#include "base/file.h"
#include "base/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Of each, the words with a name in them.
static const struct {
    const char *names, *words;
} forbidden[] = {
    {"rand srand rand_r random srandom random_r drand48 erand48 lrand48 srand48 arc4random arc4random_uniform getrandom "
     "getentropy",
     "use rng_float(rng): %s() gives other numbers on every thread and machine"},
    {"system popen fork vfork clone execl execlp execle execv execvp execve execvpe fexecve posix_spawn posix_spawnp "
     "socket socketpair connect getaddrinfo ptrace kill killpg process_vm_readv process_vm_writev setenv putenv signal "
     "sigaction syscall mount",
     "%s() has no place in a step: it computes, and leaves the rest of the machine alone"},
    {"dlopen dlmopen dlsym dlvsym dladdr dl_iterate_phdr",
     "%s() has no place in a step: other steps are called through the table, as steps.reflect(…)"},
    {"pthread_create thrd_create GOMP_parallel __kmpc_fork_call",
     "%s() has no place in a step: the program runs it on several threads already"},
    {"atexit on_exit longjmp siglongjmp", "%s() has no place in a step: when it is done it returns"},
};

// 0: nowhere.
static int find_line(const char *source, const char *name)
{
    const char *found = text_find_word(source, name);
    return found ? text_line_of(source, found) : 0;
}

static void say_where(const StepInfo *step, int line, StepWords *words)
{
    snprintf(words->where, sizeof words->where, line > 0 ? "%s, line %d" : "%s", step->symbol, line);
}

static bool names(const ObjectFile *object, SymbolKind kind, const char *name)
{
    for (size_t i = 0; i < object->count; i++)
        if (object->symbols[i].kind == kind && strcmp(object->symbols[i].name, name) == 0)
            return true;
    return false;
}

static Status check_forbidden(const ObjectFile *object, const StepInfo *step, const char *source, StepWords *words)
{
    for (size_t i = 0; i < sizeof forbidden / sizeof *forbidden; i++)
        for (const char *rest = forbidden[i].names; *rest; rest += strspn(rest, " ")) {
            char name[32];
            snprintf(name, sizeof name, "%.*s", (int)strcspn(rest, " "), rest);
            rest += strlen(name);
            if (!names(object, SYMBOL_WANTED, name))
                continue;
            say_where(step, find_line(source, name), words);
            return words_say(words, STATUS_ERROR, forbidden[i].words, name);
        }
    return STATUS_PASS;
}

// gcc calls a function's own variable `count.0`, clang `reflect.count`; the student `count`.
static void own_name(const char *symbol, char *name, size_t size)
{
    snprintf(name, size, "%s", symbol);
    for (const char *part = symbol; *part;) {
        size_t length = strcspn(part, ".");
        if (strspn(part, "0123456789") < length)
            snprintf(name, size, "%.*s", (int)length, part);
        part += length + (part[length] == '.');
    }
}

// Compilers order their symbols differently: the one that comes first in the source is named.
static Status check_variables(const ObjectFile *object, const StepInfo *step, const char *source, StepWords *words)
{
    char best[128] = "";
    int best_line = 0;
    bool inside = false; // a function
    for (size_t i = 0; i < object->count; i++) {
        char name[128];
        if (object->symbols[i].kind != SYMBOL_VARIABLE)
            continue;
        own_name(object->symbols[i].name, name, sizeof name);
        int line = find_line(source, name);
        bool earlier = line > 0 && (best_line == 0 || line < best_line);
        if (!best[0] || earlier || (line == best_line && strcmp(name, best) < 0)) {
            snprintf(best, sizeof best, "%s", name);
            best_line = line;
            inside = strcmp(name, object->symbols[i].name) != 0;
        }
    }
    if (!best[0] && !object->keeps_data)
        return STATUS_PASS;
    say_where(step, best_line, words);
    return words_say(
        words, STATUS_ERROR,
        "it has a variable that lives between calls%s%s%s; steps run on several threads, which would share it. If it "
        "never changes, write `const` before it; otherwise %s",
        best[0] ? ", `" : "", best, best[0] ? "`" : "",
        inside ? "take the word `static` away" : "move it into the function");
}

static Status check_function(const ObjectFile *object, const StepInfo *step, StepWords *words)
{
    if (names(object, SYMBOL_FUNCTION, step->symbol))
        return STATUS_PASS;
    if (names(object, SYMBOL_PRIVATE, step->symbol))
        return words_say(words, STATUS_ERROR, "`%s` is static, so nobody can call it: take that word away",
                         step->symbol);
    for (int i = 0; i < STEP_COUNT; i++)
        if (names(object, SYMBOL_FUNCTION, step_table[i].symbol))
            return words_say(words, STATUS_ERROR, "there is no function `%s` in it; `%s` is there, which is step %s's",
                             step->symbol, step_table[i].symbol, step_table[i].id);
    const char *near = NULL;
    size_t nearest = 4;
    for (size_t i = 0; i < object->count; i++) {
        const ObjectSymbol *symbol = &object->symbols[i];
        bool function = symbol->kind == SYMBOL_FUNCTION || symbol->kind == SYMBOL_PRIVATE;
        if (function && text_distance(symbol->name, step->symbol) < nearest) {
            nearest = text_distance(symbol->name, step->symbol);
            near = symbol->name;
        }
    }
    return words_say(words, STATUS_ERROR, "there is no function `%s` in it%s%s%s", step->symbol, near ? "; is `" : "",
                     near ? near : "", near ? "` meant?" : "");
}

static Status check_all(const GradeOptions *options, const StepInfo *step, const ObjectFile *object, const char *source,
                        StepWords *words)
{
    if (names(object, SYMBOL_WANTED, "photonlab_step_not_started"))
        return STATUS_TODO;
    say_where(step, 0, words);
    Status status = check_function(object, step, words);
    if (status == STATUS_PASS)
        status = check_forbidden(object, step, source, words);
    // Sanitizers bring variables and constructors of their own.
    if (status == STATUS_PASS && !strstr(options->flags, "-fsanitize"))
        status = object->runs_at_load
                     ? words_say(words, STATUS_ERROR, "it has code that runs before anyone calls it (a constructor)")
                     : check_variables(object, step, source, words);
    if (status == STATUS_PASS)
        words->where[0] = '\0';
    return status;
}

Status object_check(const GradeOptions *options, const StepInfo *step, const char *source, const char *object,
                    StepWords *words)
{
    ObjectFile file;
    Error error = {""};
    size_t size;
    if (!object_read(object, &file, &error))
        return words_say(words, STATUS_ERROR, "%s", error.message);
    char *text = file_read(source, 1u << 20, &size, &error);
    Status status = check_all(options, step, &file, text ? text : "", words);
    free(text);
    object_free(&file);
    return status;
}
