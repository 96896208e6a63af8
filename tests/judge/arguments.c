#include "judge/judge.h"

#include <stdlib.h>

static const char help[] =
    "usage: judge [flags]\n"
    "\n"
    "  --code DIR        the submission, laid out like exercises/ (exercises)\n"
    "  --step ID         grade this step alone;  --stage N: this stage\n"
    "  --root DIR        the checkout (.)\n"
    "  --build DIR       where photonlab and the solutions' objects are (build)\n"
    "  --work DIR        for objects and cases (build/test)\n"
    "  --report DIR      write report.json and pictures there\n"
    "  --points FILE     the points table (tests/judge/points.txt)\n"
    "  --compiler CC  --flags \"…\"  --link \"…\"    how a step is compiled and linked (as PHOTONLAB_CC, PHOTONLAB_FLAGS and\n"
    "                    PHOTONLAB_LINK in the environment say)\n"
    "  --jobs N          steps graded side by side (0: all cores)\n"
    "  --seconds S       processor time for a step's cases (6); slow machines get more\n"
    "  --credit          refuse to grade without a sandbox\n"
    "  --strict          exit 0 only when every step passes\n"
    "  --sanitized       no limit of memory: AddressSanitizer needs more than there is\n"
    "  --first-round     no confirmation of failures by chance (to measure how often they are)\n"
    "  --features        print each step's features, for the table of mistakes\n"
    "  --scatters N      the stages' scatters alone, with N salts: a line \"STAGE STATUS P THRESHOLD MESSAGE\" each\n"
    "  --lines           for programs: a line a step: id, status, sentence, where, what it looks like, parted by tabs\n"
    "  --verbose         show the checks of steps that pass, too\n"
    "\n"
    "PHOTONLAB_SALT in the environment, which no other user can read, gives other random numbers;\n"
    "PHOTONLAB_HIDDEN=DIR:DIR names folders that the code must not read, beside the solutions.\n"
    "Exit: 0 nothing that was started fails; 1 something does; 2 wrong usage; 3 grading was not possible.\n";

// A stage's number; −1, which is no stage, for anything else.
static int stage_number(const char *text)
{
    char *end;
    long value = strtol(text, &end, 10);
    return end != text && !*end && value > 0 && value < 1000 ? (int)value : -1;
}

static const char *from_environment(const char *name, const char *otherwise)
{
    const char *value = getenv(name);
    return value && *value ? value : otherwise;
}

int arguments_parse(int count, char **arguments, Arguments *a)
{
    *a = (Arguments){.points = "tests/judge/points.txt",
                     .grade = {.code = "exercises",
                               .root = ".",
                               .build = "build",
                               .work = "build/test",
                               .compiler = from_environment("PHOTONLAB_CC", "cc"),
                               .flags = from_environment("PHOTONLAB_FLAGS", "-std=c99 -O2 -fPIC"),
                               .link_flags = from_environment("PHOTONLAB_LINK", "-shared"),
                               .salt = from_environment("PHOTONLAB_SALT", "photonlab")}};
    GradeOptions *g = &a->grade;
    const char *stage = NULL, *odd = NULL;
    float seconds = 6.0f;
    bool sanitized = false;
    const Flag flags[] = {
        {"code", FLAG_TEXT, &g->code, 0, 0},
        {"step", FLAG_TEXT, &a->step, 0, 0},
        {"stage", FLAG_TEXT, &stage, 0, 0},
        {"root", FLAG_TEXT, &g->root, 0, 0},
        {"build", FLAG_TEXT, &g->build, 0, 0},
        {"work", FLAG_TEXT, &g->work, 0, 0},
        {"report", FLAG_TEXT, &a->report, 0, 0},
        {"points", FLAG_TEXT, &a->points, 0, 0},
        {"compiler", FLAG_TEXT, &g->compiler, 0, 0},
        {"flags", FLAG_TEXT, &g->flags, 0, 0},
        {"link", FLAG_TEXT, &g->link_flags, 0, 0},
        {"jobs", FLAG_INT, &a->jobs, 0, 1024},
        {"seconds", FLAG_FLOAT, &seconds, 0.1, 1e6},
        {"scatters", FLAG_INT, &a->scatters, 1, 999},
        {"credit", FLAG_PRESENT, &a->credit, 0, 0},
        {"strict", FLAG_PRESENT, &a->strict, 0, 0},
        {"sanitized", FLAG_PRESENT, &sanitized, 0, 0},
        {"first-round", FLAG_PRESENT, &g->first_round_only, 0, 0},
        {"features", FLAG_PRESENT, &a->features, 0, 0},
        {"lines", FLAG_PRESENT, &a->lines, 0, 0},
        {"verbose", FLAG_PRESENT, &a->verbose, 0, 0},
    };
    int wrong = command_line_parse(&(CommandLine){"judge", help, "flags alone", flags, FLAG_COUNT(flags), 0, 1}, count,
                                   arguments, &odd);
    if (wrong || odd)
        return wrong ? wrong : report_usage("judge", "what is `%s`?", odd);
    a->stage = stage ? stage_number(stage) : 0;
    g->cpu_seconds = (double)seconds;
    g->memory_limit = !sanitized;
    g->compile_only = a->scatters > 0;
    g->no_pictures = a->features;
    return 0;
}
