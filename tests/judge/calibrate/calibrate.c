// calibrate: what right code's pictures are like, for the image verdict (tests/judge/checks/pictures.h). Started in the checkout's
// root; writes tests/reference/pictures/. The same seed gives the same files, whatever the number of jobs.
//
// With --measure it writes nothing, but counts how often fresh groups of pictures fail: of right code, the false verdicts;
// with --object, of a mistake.
#include "calibrate.h"

#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char help[] = "usage: calibrate [flags] [SET …]      sets: 1 2_source 2_phong 3; none: all\n"
                           "\n"
                           "  --build DIR       where photonlab and solutions/ are (build)\n"
                           "  --renders N       pictures for means and spreads (2000)\n"
                           "  --groups N        groups for the thresholds, at least 499 (2000)\n"
                           "  --out DIR         where to write (tests/reference/pictures)\n"
                           "  --jobs N          probes side by side (0: all cores)\n"
                           "  --seed N          other pictures (1)\n"
                           "  --measure N       write nothing: judge N fresh groups and count the failures\n"
                           "  --step ID --object FILE.so    with --measure: play this code for the step\n"
                           "  --name TEXT       with --measure: what to call it\n";

const char *judge_root = ".";

GroupRun group_run(const Arguments *a, const PictureSet *set, uint64_t purpose, long groups)
{
    static char solution[4300];
    uint64_t seed = hash_u64((uint64_t)a->seed);
    for (const char *c = set->name; *c; c++)
        seed = hash_u64(seed ^ (uint64_t)(unsigned char)*c);
    const char *step = a->step ? a->step : set->step;
    snprintf(solution, sizeof solution, "%s/solutions/%s.so", a->build, step_find(step)->file);
    return (GroupRun){.set = set,
                      .build = a->build,
                      .step = step,
                      .object = a->object ? a->object : solution,
                      .seed = hash_u64(seed + purpose),
                      .groups = groups,
                      .jobs = a->jobs};
}

void *must(void *memory)
{
    if (!memory) {
        fprintf(stderr, "calibrate: not enough memory\n");
        exit(1);
    }
    return memory;
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

void sort(double *values, long count)
{
    qsort(values, (size_t)count, sizeof *values, compare);
}

static bool parse(int count, char **arguments, Arguments *a)
{
    *a = (Arguments){.build = "build", .out = "tests/reference/pictures", .renders = 2000, .groups = 2000, .seed = 1};
    const struct option options[] = {
        {"build", required_argument, NULL, 'b'},   {"renders", required_argument, NULL, 'r'},
        {"groups", required_argument, NULL, 'g'},  {"out", required_argument, NULL, 'o'},
        {"jobs", required_argument, NULL, 'j'},    {"seed", required_argument, NULL, 's'},
        {"measure", required_argument, NULL, 'm'}, {"step", required_argument, NULL, 'i'},
        {"object", required_argument, NULL, 'c'},  {"name", required_argument, NULL, 'n'},
        {"help", no_argument, NULL, 'h'},          {NULL, 0, NULL, 0}};
    for (int found; (found = getopt_long(count, arguments, "h", options, NULL)) != -1;) {
        switch (found) {
        case 'b':
            a->build = optarg;
            break;
        case 'r':
            a->renders = atol(optarg);
            break;
        case 'g':
            a->groups = atol(optarg);
            break;
        case 'o':
            a->out = optarg;
            break;
        case 'j':
            a->jobs = atoi(optarg);
            break;
        case 's':
            a->seed = atol(optarg);
            break;
        case 'm':
            a->measure = atol(optarg);
            break;
        case 'i':
            a->step = optarg;
            break;
        case 'c':
            a->object = optarg;
            break;
        case 'n':
            a->name = optarg;
            break;
        case 'h':
            fputs(help, stdout);
            exit(0);
        default:
            return false;
        }
    }
    if (a->renders < 100 || a->groups < 499 || a->measure < 0 || (!a->step && a->object) ||
        (a->step && !step_find(a->step))) {
        fprintf(stderr, "calibrate: --renders from 100, --groups from 499, --object with a --step that there is\n");
        return false;
    }
    return true;
}

static bool is_wanted(const PictureSet *set, char **names, int count)
{
    for (int i = 0; i < count; i++)
        if (strcmp(names[i], set->name) == 0)
            return true;
    return count == 0;
}

int main(int count, char **arguments)
{
    Arguments a;
    if (!parse(count, arguments, &a))
        return 2;
    bool ok = true;
    int done = 0;
    for (int i = 0; i < PICTURE_SETS; i++) {
        if (!is_wanted(&picture_sets[i], arguments + optind, count - optind))
            continue;
        ok = (a.measure > 0 ? measure_set(&a, &picture_sets[i]) : calibrate_set(&a, &picture_sets[i])) && ok;
        done++;
    }
    if (done == 0)
        fprintf(stderr, "calibrate: no such set; they are 1, 2_source, 2_phong, 3\n");
    return done == 0 ? 2 : ok ? 0 : 1;
}
