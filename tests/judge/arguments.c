#include "arguments.h"

#include <getopt.h>
#include <stdio.h>
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
    "  --compiler CC  --flags \"…\"  --link \"…\"    how a step is compiled and linked\n"
    "  --jobs N          steps graded side by side (0: all cores)\n"
    "  --salt TEXT       other random numbers\n"
    "  --seconds S       processor time for a step's cases (6); slow machines get more\n"
    "  --credit          refuse to grade without a sandbox\n"
    "  --strict          exit 0 only when every step passes\n"
    "  --sanitized       no limit of memory: AddressSanitizer needs more than there is\n"
    "  --first-round     no confirmation of failures by chance (to measure how often they are)\n"
    "  --features        print each step's features, for the table of mistakes\n"
    "  --scatters N      the stages' scatters alone, with N salts: a line \"STAGE STATUS P THRESHOLD MESSAGE\" each\n"
    "  --verbose         show the checks of steps that pass, too\n"
    "\n"
    "Exit: 0 nothing that was started fails; 1 something does; 2 wrong usage; 3 grading was not possible.\n";

// A whole number above 0; −1, which is no stage, for anything else.
static int whole(const char *text)
{
    char *end;
    long value = strtol(text, &end, 10);
    return end != text && !*end && value > 0 && value < 1000 ? (int)value : -1;
}

int arguments_parse(int count, char **arguments, Arguments *a)
{
    static int sanitized, first_round;
    *a = (Arguments){.points = "tests/judge/points.txt",
                     .grade = {.code = "exercises",
                               .root = ".",
                               .build = "build",
                               .work = "build/test",
                               .compiler = "cc",
                               .flags = "-std=c99 -O2 -fPIC",
                               .link_flags = "-shared",
                               .salt = "photonlab",
                               .cpu_seconds = 6.0,
                               .memory_limit = true}};
    GradeOptions *g = &a->grade;
    const struct option options[] = {{"code", required_argument, NULL, 'c'},
                                     {"step", required_argument, NULL, 's'},
                                     {"stage", required_argument, NULL, 'g'},
                                     {"root", required_argument, NULL, 'r'},
                                     {"build", required_argument, NULL, 'b'},
                                     {"work", required_argument, NULL, 'w'},
                                     {"report", required_argument, NULL, 'R'},
                                     {"points", required_argument, NULL, 'p'},
                                     {"compiler", required_argument, NULL, 'C'},
                                     {"flags", required_argument, NULL, 'F'},
                                     {"link", required_argument, NULL, 'L'},
                                     {"jobs", required_argument, NULL, 'j'},
                                     {"salt", required_argument, NULL, 'S'},
                                     {"seconds", required_argument, NULL, 't'},
                                     {"scatters", required_argument, NULL, 'n'},
                                     {"credit", no_argument, &a->credit, 1},
                                     {"strict", no_argument, &a->strict, 1},
                                     {"sanitized", no_argument, &sanitized, 1},
                                     {"first-round", no_argument, &first_round, 1},
                                     {"features", no_argument, &a->features, 1},
                                     {"verbose", no_argument, &a->verbose, 1},
                                     {"help", no_argument, NULL, 'h'},
                                     {NULL, 0, NULL, 0}};
    for (int found; (found = getopt_long(count, arguments, "h", options, NULL)) != -1;) {
        switch (found) {
        case 0:
            break;
        case 'c':
            g->code = optarg;
            break;
        case 's':
            a->step = optarg;
            break;
        case 'g':
            a->stage = whole(optarg);
            break;
        case 'r':
            g->root = optarg;
            break;
        case 'b':
            g->build = optarg;
            break;
        case 'w':
            g->work = optarg;
            break;
        case 'R':
            a->report = optarg;
            break;
        case 'p':
            a->points = optarg;
            break;
        case 'C':
            g->compiler = optarg;
            break;
        case 'F':
            g->flags = optarg;
            break;
        case 'L':
            g->link_flags = optarg;
            break;
        case 'j':
            a->jobs = atoi(optarg);
            break;
        case 'n':
            a->scatters = whole(optarg);
            break;
        case 'S':
            g->salt = optarg;
            break;
        case 't':
            g->cpu_seconds = atof(optarg);
            break;
        case 'h':
            fputs(help, stdout);
            exit(0);
        default:
            return EXIT_USAGE;
        }
    }
    g->memory_limit = !sanitized;
    g->compile_only = a->scatters > 0;
    g->first_round_only = first_round;
    if (optind < count) {
        fprintf(stderr, "judge: what is `%s`? judge --help lists the flags\n", arguments[optind]);
        return EXIT_USAGE;
    }
    return 0;
}
