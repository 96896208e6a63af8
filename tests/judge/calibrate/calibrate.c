// calibrate: what right code's pictures are like, for the image verdict (tests/judge/checks/pictures.h). Started in the checkout's
// root; writes tests/reference/pictures/. The same seed gives the same files, whatever the number of jobs.
//
// With --measure it writes nothing, but counts how often fresh groups of pictures fail: of right code, the false verdicts;
// with --object, of a mistake.
#include "base/command_line.h"
#include "calibrate.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char help[] =
    "usage: calibrate [flags] [SET …]      sets: 1 2_source 2_phong 3 4 5_pass 5_pixel 6; none: all\n"
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

// 0 when the arguments are right, otherwise the exit code or HELP_SHOWN. Names of sets go to `sets`.
static int parse(int count, char **arguments, Arguments *a, const char **sets)
{
    *a = (Arguments){.build = "build", .out = "tests/reference/pictures", .renders = 2000, .groups = 2000, .seed = 1};
    const Flag flags[] = {
        {"build", FLAG_TEXT, &a->build, 0, 0},       {"renders", FLAG_LONG, &a->renders, 100, 1e9},
        {"groups", FLAG_LONG, &a->groups, 499, 1e9}, {"out", FLAG_TEXT, &a->out, 0, 0},
        {"jobs", FLAG_INT, &a->jobs, 0, 1024},       {"seed", FLAG_LONG, &a->seed, -1e15, 1e15},
        {"measure", FLAG_LONG, &a->measure, 0, 1e9}, {"step", FLAG_TEXT, &a->step, 0, 0},
        {"object", FLAG_TEXT, &a->object, 0, 0},     {"name", FLAG_TEXT, &a->name, 0, 0},
    };
    int wrong = command_line_parse(
        &(CommandLine){"calibrate", help, "names of sets alone", flags, FLAG_COUNT(flags), 0, PICTURE_SETS}, count,
        arguments, sets);
    if (!wrong && ((!a->step && a->object) || (a->step && !step_find(a->step))))
        return report_usage("calibrate", "--object with a --step that there is");
    return wrong;
}

static bool is_wanted(const PictureSet *set, const char *const *names)
{
    for (int i = 0; i < PICTURE_SETS && names[i]; i++)
        if (strcmp(names[i], set->name) == 0)
            return true;
    return !names[0];
}

int main(int count, char **arguments)
{
    Arguments a;
    const char *sets[PICTURE_SETS] = {NULL};
    int wrong = parse(count, arguments, &a, sets);
    if (wrong)
        return wrong == HELP_SHOWN ? 0 : wrong;
    bool ok = true;
    int done = 0;
    for (int i = 0; i < PICTURE_SETS; i++) {
        if (!is_wanted(&picture_sets[i], sets))
            continue;
        ok = (a.measure > 0 ? measure_set(&a, &picture_sets[i]) : calibrate_set(&a, &picture_sets[i])) && ok;
        done++;
    }
    if (done == 0)
        fprintf(stderr, "calibrate: no such set; tests/judge/checks/pictures.def lists them\n");
    return done == 0 ? 2 : ok ? 0 : 1;
}
