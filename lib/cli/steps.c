#include "cli/cli.h"
#include "base/text.h"

#include <stdio.h>
#include <stdlib.h>

static const char help[] =
    "usage: photonlab steps [flags]\n"
    "\n"
    "Lists the steps that students write, one a line, parted by tabs: id, function, stage, file (below exercises/, without\n"
    "its ending), title, place in the course notes.\n"
    "\n"
    "  --hint ID      a hint for this step instead, e.g. --hint 2.1\n"
    "  --level N      1: where to look; 2: the formula; 3: nearly the code. Unset: 1\n";

static const char *hint;
static int level;
static const Flag flags[] = {
    {"hint", FLAG_TEXT, &hint, 0, 0},
    {"level", FLAG_INT, &level, 1, HINT_COUNT},
};

static void print_table(void)
{
    for (size_t i = 0; i < STEP_COUNT; i++) {
        const StepInfo *step = &step_table[i];
        printf("%s\t%s\t%d\t%s\t%s\t%s\n", step->id, step->symbol, step->stage, step->file, step->title, step->chapter);
    }
}

static int refuse_hint(void)
{
    char ids[16 * STEP_COUNT] = "";
    for (size_t i = 0; i < STEP_COUNT; i++)
        text_append(ids, sizeof ids, " %s", step_table[i].id);
    return report_usage("photonlab steps", "--hint %s: no such step; there are%s", hint, ids);
}

static int run(void)
{
    if (level && !hint)
        return report_usage("photonlab steps", "--level %d: of which step? Add --hint ID", level);
    if (!hint) {
        print_table();
        return 0;
    }
    const StepInfo *step = step_find(hint);
    if (!step)
        return refuse_hint();
    Error error = {""};
    char *text = step_hint(step, level ? level : 1, &error);
    if (!text)
        return report_error(&error);
    printf("%s", text);
    free(text);
    return 0;
}

const Command command_steps = {
    .words = "list the steps to write, and hints for them",
    .line = {"photonlab steps", help, "no file", flags, FLAG_COUNT(flags), 0, 0},
    .run = run,
};
