// The program build/probe: takes the flags, loads the steps, runs case after case.
#include "judge/probe/probe.h"
#include "judge/probe/probe_sizes.h"

#include "base/command_line.h"
#include "base/file.h"
#include "base/process.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char help[] =
    "usage: build/probe --step ID --object STEP.so --references DIR CASES [-o OUT | --fd N]\n"
    "       build/probe --several LIST --objects DIR --references DIR CASES [-o OUT | --fd N]\n"
    "\n"
    "Runs one step on given cases and writes what it gave, as numbers. What `make test` and `make debug` call; tests/judge/probe/probe.h\n"
    "describes both files.\n"
    "\n"
    "  --step ID          which step, e.g. 2.1\n"
    "  --object FILE      the step's shared object\n"
    "  --several LIST     several steps together, parted by commas (none: the references play all); for cases in scenes\n"
    "  --objects DIR      their shared objects: DIR/2.1/step.so\n"
    "  --references DIR   solutions for the other steps, laid out like build/solutions\n"
    "  --root DIR         where the cases' scenes are looked for (the working directory)\n"
    "  -o FILE            where to write; or\n"
    "  --fd N             an open file descriptor to write to\n"
    "  --only N           run case N alone (from 0)\n"
    "  --print            print the numbers as text on standard output as well\n";

#define MOST_CASE_BYTES (16u << 20)

typedef struct {
    const char *step, *object, *several, *objects, *references, *root, *out, *cases;
    int fd, only;
    bool print;
} Arguments;

static const char *scene_root = ".";

Scene *probe_scene(const char *path, Error *error)
{
    char whole[4096];
    snprintf(whole, sizeof whole, "%s/%s", scene_root, path);
    return scene_load(path[0] == '/' ? path : whole, error);
}

static bool run_case(const StepInfo *step, char *text, ProbeOutput *output, Error *error)
{
    static const struct {
        const char *kind;
        bool (*run)(ProbeLine *line, ProbeOutput *output);
    } kinds[] = {
        {"paths", probe_paths}, {"picture", probe_picture}, {"passes", probe_passes}, {"scatter", probe_scatter}};
    ProbeLine line = {text, false, error};
    const char *kind = probe_word(&line);
    if (strcmp(kind, "call") == 0 && step)
        return probe_call(step, &line, output);
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (strcmp(kind, kinds[i].kind) == 0)
            return kinds[i].run(&line, output);
    return error_set(error, "no kind of case `%s`; expected %spaths, picture, passes or scatter", kind,
                     step ? "call, " : "");
}

static bool write_case(int fd, int number, const ProbeOutput *output)
{
    uint32_t head[2] = {(uint32_t)number, (uint32_t)output->count};
    return write_all(fd, head, sizeof head) && write_all(fd, output->values, output->count * sizeof *output->values);
}

static void print_case(int number, const ProbeOutput *output)
{
    printf("case %d:", number);
    for (size_t i = 0; i < output->count; i++)
        printf(" %.9g", (double)output->values[i]);
    printf("\n");
}

// Runs the cases line by line; what is done is out before the next begins, so that a crash loses no finished case.
static bool run_cases(const Arguments *a, const StepInfo *step, char *text, int fd, Error *error)
{
    if (fd >= 0 && !write_all(fd, PROBE_MAGIC, strlen(PROBE_MAGIC)))
        return error_set(error, "cannot write the results: %s", strerror(errno));
    int number = 0;
    for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n"), number++) {
        if (a->only >= 0 && a->only != number)
            continue;
        ProbeOutput output = {NULL, 0, 0, false};
        probe_case = number;
        size_t expected = probe_case_size(step ? step->id : "", line);
        bool ok = run_case(step, line, &output, error);
        if (ok && output.out_of_memory)
            ok = error_set(error, "not enough memory");
        if (ok && output.count != expected)
            ok = error_set(error, "gave %zu numbers where tests/judge/probe/probe_sizes.h says %zu", output.count,
                           expected);
        if (ok && fd >= 0 && !write_case(fd, number, &output))
            ok = error_set(error, "cannot write the results: %s", strerror(errno));
        if (ok && a->print)
            print_case(number, &output);
        free(output.values);
        if (!ok) {
            char reason[sizeof error->message];
            snprintf(reason, sizeof reason, "%s", error->message);
            snprintf(error->message, sizeof error->message, "%.200s: case %d: %.700s", a->cases, number, reason);
            return false;
        }
    }
    return true;
}

static int parse(int count, char **arguments, Arguments *a)
{
    *a = (Arguments){.fd = -1, .only = -1};
    const Flag flags[] = {
        {"step", FLAG_TEXT, &a->step, 0, 0},
        {"object", FLAG_TEXT, &a->object, 0, 0},
        {"several", FLAG_TEXT, &a->several, 0, 0},
        {"objects", FLAG_TEXT, &a->objects, 0, 0},
        {"references", FLAG_TEXT, &a->references, 0, 0},
        {"root", FLAG_TEXT, &a->root, 0, 0},
        {"o", FLAG_TEXT, &a->out, 0, 0},
        {"fd", FLAG_INT, &a->fd, 0, 1000},
        {"only", FLAG_INT, &a->only, 0, 1e9},
        {"print", FLAG_PRESENT, &a->print, 0, 0},
    };
    int wrong = command_line_parse(&(CommandLine){"probe", help, "one file of cases", flags, FLAG_COUNT(flags), 1, 1},
                                   count, arguments, &a->cases);
    if (wrong)
        return wrong;
    bool one = a->step && a->object && !a->several && !a->objects;
    bool several = a->several && a->objects && !a->step && !a->object;
    if (!a->references || (!one && !several))
        return report_usage("probe", "needs --step and --object, or --several and --objects; and --references");
    return 0;
}

// Marks the steps of a list like "2.1,2.2", which may be empty.
static bool read_list(const char *list, bool graded[STEP_COUNT])
{
    for (const char *word = list; *word; word += strcspn(word, ",") + (word[strcspn(word, ",")] == ',')) {
        char id[16];
        snprintf(id, sizeof id, "%.*s", (int)strcspn(word, ","), word);
        const StepInfo *step = step_find(id);
        if (!step)
            return false;
        graded[step - step_table] = true;
    }
    return true;
}

static int fail(const Error *error)
{
    fprintf(stderr, "%s\n", error->message);
    return 1;
}

// In the slot of every step that the graded one must not call.
static void step_is_absent(void)
{
    fprintf(stderr, "photonlab: a step was called that is not there while this one is graded\n");
    abort();
}

// Tried by opening it: under Landlock stat and access succeed for files that cannot be opened.
static bool is_in_sight(const char *path)
{
    FILE *file = fopen(path, "rb");
    return file && fclose(file) == 0;
}

// Loads the solutions that lie in the references' directory, but for those of the graded steps.
static bool load(const Arguments *a, const bool graded[STEP_COUNT], Error *error)
{
    void (*absent)(void) = step_is_absent;
    for (size_t i = 0; i < STEP_COUNT; i++) {
        char path[4096];
        snprintf(path, sizeof path, "%s/%s.so", a->references, step_table[i].file);
        memcpy((char *)&steps + step_table[i].slot, &absent, sizeof absent);
        step_states[i] = graded[i] ? STEP_STUDENT : STEP_REFERENCE;
        if (!graded[i] && is_in_sight(path) && !steps_load_slot(&step_table[i], path, error))
            return false;
    }
    bool ok = true;
    for (size_t i = 0; ok && i < STEP_COUNT; i++) {
        char path[4096];
        snprintf(path, sizeof path, "%s/%s/step.so", a->objects ? a->objects : "", step_table[i].id);
        ok = !graded[i] || steps_load_slot(&step_table[i], a->object ? a->object : path, error);
    }
    return ok;
}

int main(int count, char **arguments)
{
    Arguments a;
    int wrong = parse(count, arguments, &a);
    if (wrong)
        return wrong == HELP_SHOWN ? 0 : wrong;
    const StepInfo *step = a.step ? step_find(a.step) : NULL;
    bool graded[STEP_COUNT] = {false};
    if (a.step && !step)
        return report_usage("probe", "--step %s: no such step", a.step);
    if (step)
        graded[step - step_table] = true;
    if (a.several && !read_list(a.several, graded))
        return report_usage("probe", "--several %s: expected steps parted by commas", a.several);
    scene_root = a.root ? a.root : ".";
    parallel_limit(1); // grading runs one probe per core
    Error error = {""};
    size_t size;
    char *text = file_read(a.cases, MOST_CASE_BYTES, &size, &error);
    if (!text)
        return fail(&error);
    probe_watch(a.object, a.objects);
    FileWriter writer = {0};
    bool ok = load(&a, graded, &error) && (!a.out || file_write_begin(&writer, a.out, &error));
    ok = ok && run_cases(&a, step, text, a.out ? fileno(writer.stream) : a.fd, &error);
    if (writer.stream)
        ok = file_write_end(&writer, ok, &error) && ok;
    free(text);
    return ok ? 0 : fail(&error);
}
