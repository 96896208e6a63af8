// From a step's source to its shared object, in the sandbox.
#include "base/file.h"
#include "judge/submission/submission.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define MOST_SOURCE (1u << 20)
#define MOST_WORDS  64

void step_directory(const GradeOptions *options, const StepInfo *step, char *path, size_t size)
{
    snprintf(path, size, "%s/%s", options->work, step->id);
    mkdir(path, 0755);
}

// Words of a command, parted by blanks: the compiler may be several, too. `line` takes them; returns how many there are.
static int split_words(const char *compiler, const char *flags, char *line, size_t size, const char **words)
{
    int count = 0;
    char *rest;
    snprintf(line, size, "%s %s", compiler, flags);
    for (char *word = strtok_r(line, " ", &rest); word && count < MOST_WORDS - 8; word = strtok_r(NULL, " ", &rest))
        words[count++] = word;
    return count;
}

// Shows paths as the student knows them.
static void shorten_paths(const char *from, const char *long_name, const char *short_name, char *to, size_t size)
{
    size_t used = 0, length = strlen(long_name);
    while (*from && used + 1 < size) {
        if (length > 0 && strncmp(from, long_name, length) == 0) {
            used += (size_t)snprintf(to + used, size - used, "%s", short_name);
            used = used < size ? used : size - 1;
            from += length;
        } else {
            to[used++] = *from++;
        }
    }
    to[used] = '\0';
}

typedef struct {
    char source[4096], object[4096], shared[4096], directory[4000], include[4096], code[PATH_MAX];
} Paths;

static bool run_tool(const GradeOptions *options, const Paths *p, const char *const *words, SandboxResult *ran,
                     Error *error)
{
    SandboxRun run = {.arguments = words,
                      .visible = {p->code, p->include, NULL},
                      .writable = p->directory,
                      .result_fd = -1,
                      .compiler = true,
                      .cpu_seconds = 10.0 * options->speed,
                      .wall_seconds = 20.0 * options->speed,
                      .memory_mb = 1024,
                      .file_mb = 64};
    memcpy(run.hidden, options->hidden, sizeof run.hidden);
    return sandbox_run(options->sandbox, &run, ran, error);
}

static Status compile(const GradeOptions *options, const Paths *p, StepWords *told)
{
    SandboxResult ran;
    char line[4096], include[4200];
    const char *words[MOST_WORDS];
    Error error = {""};
    snprintf(include, sizeof include, "-I%s", p->include);
    int count = split_words(options->compiler, options->flags, line, sizeof line, words);
    const char *const compile_words[] = {include, "-fmax-errors=20", "-MMD", "-c", p->source, "-o", p->object, NULL};
    memcpy(words + count, compile_words, sizeof compile_words);
    if (!run_tool(options, p, words, &ran, &error))
        return words_say(told, STATUS_SKIP, "the compiler could not be run: %s", error.message);
    shorten_paths(ran.text, p->code, options->code, told->output, sizeof told->output);
    told->compiled = strlen(told->output);
    if (ran.exit_code != 0)
        return words_say(told, STATUS_ERROR,
                         ran.exit_code > 0 ? "it does not compile" : "the compiler did not come to an end");
    count = split_words(options->compiler, options->link_flags, line, sizeof line, words);
    const char *const link_words[] = {p->object, "-o", p->shared, NULL};
    memcpy(words + count, link_words, sizeof link_words);
    if (run_tool(options, p, words, &ran, &error) && ran.exit_code == 0)
        return STATUS_PASS;
    snprintf(told->output, sizeof told->output, "%.16000s", ran.text);
    return words_say(told, STATUS_ERROR, "it compiles, but cannot be linked");
}

// The next name of the compiler's list, as for make, where `\ ` is a blank in a name; it is cut up. NULL: no more.
static char *next_name(char **rest)
{
    char *from = *rest + strspn(*rest, " \n"), *name = from, *to = from;
    for (; *from && *from != ' ' && *from != '\n'; *to++ = *from++)
        from += from[0] == '\\' && from[1] == ' ';
    *rest = from + (*from != '\0');
    *to = '\0';
    return *name ? name : NULL;
}

// What stands behind the last `/../`, or all.
static const char *last_up(const char *path)
{
    for (const char *up; (up = strstr(path, "/../"));)
        path = up + 4;
    return path;
}

// A file of the student's own that is included and would not be handed in: its path in the submission, or NULL. A sandbox may have
// compiled a copy of it all in some folder: what stands before the source's path, the first of the list, stands before all.
static const char *left_behind(const Paths *p, char *list)
{
    size_t length = strlen(p->code), copied_to = 0;
    for (char *name = next_name(&list); name; name = next_name(&list)) {
        size_t above = strlen(name) - strlen(p->source);
        if (strlen(name) > strlen(p->source) && strcmp(name + above, p->source) == 0)
            copied_to = above;
        const char *ending = strrchr(name, '.'), *path = name + (copied_to < strlen(name) ? copied_to : 0);
        if (strncmp(path, p->code, length) != 0 || path[length] != '/' || !ending)
            continue;
        bool hidden = false;
        for (const char *part = path + length; (part = strstr(part, "/.")); part++)
            hidden = hidden || part[2] != '.';
        if (hidden || (strcmp(ending, ".c") && strcmp(ending, ".h") && strcmp(ending, ".inl")))
            return last_up(path + length + 1);
    }
    return NULL;
}

static Status check_includes(const Paths *p, StepWords *words)
{
    char path[4096];
    size_t size;
    Error ignored = {""};
    snprintf(path, sizeof path, "%.*s.d", (int)(strrchr(p->object, '.') - p->object), p->object);
    char *made = file_read(path, 1u << 20, &size, &ignored);
    const char *left = made ? left_behind(p, made) : NULL;
    Status status = STATUS_PASS;
    if (left)
        status = words_say(words, STATUS_ERROR,
                           "it includes `%.300s`, which would not be handed in: call files of your own .c, .h or .inl",
                           left);
    free(made);
    return status;
}

// A source must be a file of its own: a link could name anything on the machine.
static Status find_source(const Paths *p, StepWords *words)
{
    struct stat state, above;
    char folder[4096];
    if (lstat(p->source, &state) != 0 && errno == ENOENT)
        return STATUS_TODO;
    snprintf(folder, sizeof folder, "%.*s", (int)(strrchr(p->source, '/') - p->source), p->source);
    if (lstat(folder, &above) != 0 || !S_ISDIR(above.st_mode))
        return words_say(words, STATUS_ERROR, "the source's folder is a link");
    if (!S_ISREG(state.st_mode) || state.st_size > (off_t)MOST_SOURCE)
        return words_say(words, STATUS_ERROR, "the source is no plain file of a sensible size");
    return STATUS_PASS;
}

Status compile_step(const GradeOptions *options, const StepInfo *step, StepWords *words)
{
    Paths p;
    if (!realpath(options->code, p.code))
        return words_say(words, STATUS_TODO, "no directory %s", options->code);
    snprintf(p.source, sizeof p.source, "%.3000s/%s.c", p.code, step->file);
    snprintf(p.include, sizeof p.include, "%s/lib", options->root);
    step_directory(options, step, p.directory, sizeof p.directory);
    snprintf(p.object, sizeof p.object, "%s/step.o", p.directory);
    snprintf(p.shared, sizeof p.shared, "%s/step.so", p.directory);
    unlink(p.object);
    unlink(p.shared);
    Status status = find_source(&p, words);
    if (status == STATUS_PASS)
        status = compile(options, &p, words);
    if (status == STATUS_PASS)
        status = check_includes(&p, words);
    if (status == STATUS_PASS)
        status = object_check(options, step, p.source, p.object, words);
    if (status == STATUS_TODO)
        submission_note_todo(options, step, p.source, words);
    return status;
}
