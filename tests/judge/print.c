// What the person at the terminal reads: stages, steps, what is wrong and where to go on, and the sums.
#include "judge/judge.h"
#include "base/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const colours[] = {"\033[32m", "\033[31m", "\033[33m", "\033[90m", "\033[90m"};

// Title to the left, points to the right.
static void print_title(const Terminal *terminal, const StepResult *result)
{
    char points[40], most[40], right[90];
    snprintf(right, sizeof right, "%s/%s", text_points(result->points, points, sizeof points),
             text_points(result->points_max, most, sizeof most));
    int used = 4 + terminal_columns(result->step->id, strlen(result->step->id)) + 1 +
               terminal_columns(result->step->title, strlen(result->step->title)) + (int)strlen(right);
    int gap = (terminal->width < 70 ? terminal->width : 70) - used;
    terminal_paint(terminal, colours[result->status]);
    printf("  %s ", status_table[result->status].mark);
    terminal_paint(terminal, "\033[0m");
    printf("%s %s%*s%s\n", result->step->id, result->step->title, gap > 2 ? gap : 2, "", right);
}

static void print_check(const Terminal *terminal, const CheckResult *check)
{
    char line[2048] = "";
    const Finding *finding = &check->finding;
    text_append(line, sizeof line, "%s %s", status_table[check->status].mark, check->check->title);
    if (check->check->kind == CHECK_PICTURE && finding->T_threshold > 0.0)
        text_append(line, sizeof line,
                    ": brightness off by %.2f (T; right code up to %.2f), noise by %.2f (V; up to %.2f)", finding->T,
                    finding->T_threshold, finding->V, finding->V_threshold);
    else if (finding->failed)
        text_append(line, sizeof line, ": right code never does this");
    else if (finding->tests > 0)
        text_append(line, sizeof line, ": p = %.2g, wrong below %.2g", finding->p, check->threshold);
    print_wrapped(terminal, DIM, "%s", line);
}

// Nothing ran: then the output is the compiler's, and its first lines matter.
static bool nothing_ran(const StepResult *result)
{
    for (int i = 0; i < result->check_count; i++)
        if (result->checks[i].status != STATUS_SKIP)
            return false;
    return true;
}

// The compiler's lines (warnings often say what is wrong), then what the code printed.
static void print_output(const Terminal *terminal, const StepResult *result)
{
    char compiled[sizeof result->words.output];
    snprintf(compiled, sizeof compiled, "%.*s", (int)result->words.compiled, result->words.output);
    if (*compiled)
        print_lines(compiled, MOST_LINES);
    const char *printed = result->words.output + strlen(compiled);
    if (*printed) {
        if (!nothing_ran(result))
            print_wrapped(terminal, DIM, "printed:");
        print_lines(printed, strstr(printed, "Sanitizer: ") || nothing_ran(result) ? MOST_LINES : MOST_LINES / 2);
    }
}

// Which check the words are of, where there are several.
static void print_deciding_check(const Terminal *terminal, const StepResult *result)
{
    for (int i = 0; i < result->check_count && result->status == STATUS_FAIL; i++)
        if (result->checks[i].status == STATUS_FAIL) {
            print_wrapped(terminal, DIM, "check: %s", result->checks[i].check->title);
            return;
        }
}

static void print_details(const Terminal *terminal, const StepResult *result)
{
    print_wrapped(terminal, PLAIN, "%s", *result->words.message ? result->words.message : "no reason is known");
    print_deciding_check(terminal, result);
    if (*result->words.where)
        print_wrapped(terminal, DIM, "in %s", result->words.where);
    if (*result->looks_like)
        print_wrapped(terminal, BOLD, "looks like: %s", result->looks_like);
    print_output(terminal, result);
    if (result->status == STATUS_SKIP)
        return;
    int length = (int)strcspn(result->step->file, "/");
    print_wrapped(terminal, DIM, "make hint STEP=%s · contract: lib/steps/%.*s.h · chapter %s%s%s", result->step->id,
                  length, result->step->file, result->step->chapter,
                  *result->tile ? " · its picture: gallery.html#" : "", result->tile);
}

static void print_step(const Terminal *terminal, const StepResult *result, bool verbose)
{
    print_title(terminal, result);
    if (result->status != STATUS_PASS && result->status != STATUS_TODO)
        print_details(terminal, result);
    else if (result->status == STATUS_TODO && *result->words.message)
        print_wrapped(terminal, PLAIN, "%s", result->words.message);
    else if (verbose && result->status == STATUS_PASS && *result->words.output)
        print_lines(result->words.output, MOST_LINES / 2);
    for (int i = 0; verbose && result->status != STATUS_TODO && i < result->check_count; i++)
        print_check(terminal, &result->checks[i]);
}

// "1_diffuse_photon_map/1.1_reflect" names its stage.
static void print_stage(const Terminal *terminal, const StepInfo *step)
{
    size_t length = strcspn(step->file, "/"), start = strcspn(step->file, "_") + 1;
    terminal_paint(terminal, "\033[1m");
    printf("\nStage %d · ", step->stage);
    for (size_t i = start; i < length; i++)
        putchar(step->file[i] == '_' ? ' ' : step->file[i]);
    terminal_paint(terminal, "\033[0m");
    putchar('\n');
}

// Behind the steps of its stage. A pass says in few words what it is that passed.
static void print_scatter(const Terminal *terminal, const StageResult *stages, int number, bool verbose)
{
    const StageResult *stage = number > 0 && number <= STAGE_COUNT ? &stages[number - 1] : NULL;
    if (!stage || stage->stage == 0 || stage->status == STATUS_TODO)
        return;
    terminal_paint(terminal, colours[stage->status]);
    printf("  %s ", status_table[stage->status].mark);
    terminal_paint(terminal, "\033[0m");
    printf("scatter of stage %d, by your %s\n", stage->stage, stage->steps);
    if (stage->status != STATUS_PASS) {
        print_wrapped(terminal, PLAIN, "stage %d, scatter: %s", stage->stage,
                      *stage->message ? stage->message : "no reason is known");
        print_wrapped(terminal, DIM, "(The scatter is where a scene's photons land by all of these steps together.)");
    }
    if (verbose && stage->tests > 0)
        print_wrapped(terminal, DIM, "%d comparisons: p = %.2g, wrong below %.2g", stage->tests, stage->p,
                      stage->threshold);
}

static void print_sums(const StepResult *results, int count)
{
    int of[5] = {0}, hidden = 0;
    double points = 0.0, points_max = 0.0;
    char got[40], most[40];
    for (int i = 0; i < count; i++) {
        hidden += results[i].hidden;
        if (results[i].hidden)
            continue;
        of[results[i].status]++;
        points += results[i].points;
        points_max += results[i].points_max;
    }
    printf("\n%s of %s points", text_points(points, got, sizeof got), text_points(points_max, most, sizeof most));
    if (hidden > 0)
        printf("; %d hidden step%s graded, too", hidden, hidden == 1 ? " is" : "s are");
    printf("\n%d not started", of[STATUS_TODO]);
    if (of[STATUS_SKIP] > 0)
        printf(", %d not checked", of[STATUS_SKIP]);
    printf("\n%d passed, %d failed\n", of[STATUS_PASS], of[STATUS_FAIL] + of[STATUS_ERROR]);
}

// Hidden steps are in no line and no sum: what a student reads here must not tell how they went.
void print_results(const StepResult *results, int count, const StageResult *stages, bool verbose)
{
    Terminal terminal = terminal_find();
    int stage = 0;
    for (int i = 0; i < count; i++) {
        if (results[i].hidden)
            continue;
        if (results[i].step->stage != stage) {
            print_scatter(&terminal, stages, stage, verbose);
            print_stage(&terminal, results[i].step);
        }
        stage = results[i].step->stage;
        print_step(&terminal, &results[i], verbose);
    }
    print_scatter(&terminal, stages, stage, verbose);
    print_sums(results, count);
    fflush(stdout);
}

// One line's field, behind a tab.
static void print_field(const char *text)
{
    char *copy = terminal_clean(text);
    for (char *at = copy; *at; at++)
        *at = *at == '\t' || *at == '\n' ? ' ' : *at;
    printf("\t%s", copy);
    free(copy);
}

void print_lines_of_steps(const StepResult *results, int count)
{
    for (int i = 0; i < count; i++) {
        if (results[i].hidden)
            continue;
        printf("%s\t%s", results[i].step->id, status_table[results[i].status].name);
        print_field(results[i].words.message);
        print_field(results[i].words.where);
        print_field(results[i].looks_like);
        putchar('\n');
    }
    fflush(stdout);
}

void print_features(const StepResult *results, int count)
{
    for (int i = 0; i < count; i++) {
        if (results[i].status == STATUS_TODO)
            continue;
        printf("%s %s", results[i].step->id, status_table[results[i].status].name);
        for (int c = 0; c < results[i].check_count; c++) {
            const CheckResult *check = &results[i].checks[c];
            for (int f = 0; f < check->finding.feature_count; f++)
                printf(" %s:%.6g:%.3g", check->check->name, check->finding.features[f].value,
                       check->finding.features[f].error);
        }
        putchar('\n');
    }
}
