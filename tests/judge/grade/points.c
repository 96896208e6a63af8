#include "judge/grade/points.h"
#include "base/file.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

#define MOST_STAGES 16
#define FAR_OFF     2.0 // times the threshold of T

// The table as its lines say it, before weights become points.
typedef struct {
    double total, picture, stages, late_per_day, late_most, weight[STEP_COUNT], stage_weight[MOST_STAGES];
    bool given[STEP_COUNT];
    char due[MOST_STAGES][16];
} Lines;

static bool number(char **rest, double low, double high, double *value)
{
    char *word = strtok_r(NULL, " \t", rest);
    char *end;
    if (!word)
        return false;
    *value = strtod(word, &end);
    return end != word && !*end && *value >= low && *value <= high;
}

static bool is_date(const char *text)
{
    struct tm day = {.tm_hour = 12};
    char again[16];
    const char *end = text ? strptime(text, "%Y-%m-%d", &day) : NULL;
    if (!end)
        return false;
    timegm(&day); // makes 2 March of 30 February
    return strftime(again, sizeof again, "%Y-%m-%d", &day) > 0 && strcmp(text, again) == 0;
}

// step ID WEIGHT [hidden]
static bool step_line(char **rest, Lines *lines, PointsTable *table, const char **expected)
{
    *expected = "step ID WEIGHT [hidden], with a step that there is, e.g. `step 2.1 6`";
    const char *id = strtok_r(NULL, " \t", rest);
    for (int i = 0; id && i < STEP_COUNT; i++) {
        if (strcmp(step_table[i].id, id) != 0)
            continue;
        *expected = lines->given[i] ? "each step once; this one has a line already"
                                    : "step ID WEIGHT [hidden], the weight a number from 0";
        bool ok = !lines->given[i] && number(rest, 0.0, 1e6, &lines->weight[i]);
        lines->given[i] = true;
        const char *word = strtok_r(NULL, " \t", rest);
        table->hidden[i] = word && strcmp(word, "hidden") == 0;
        return ok && (!word || table->hidden[i]);
    }
    return false;
}

// stage NUMBER [weight W] [due YYYY-MM-DD]
static bool stage_line(char **rest, Lines *lines, const char **expected)
{
    *expected =
        "stage NUMBER [weight W] [due YYYY-MM-DD], of a stage and a date that there are, e.g. `stage 2 due 2026-12-01`";
    double stage;
    if (!number(rest, 1, step_table[STEP_COUNT - 1].stage, &stage) || stage != (int)stage)
        return false;
    int s = (int)stage;
    for (char *word; (word = strtok_r(NULL, " \t", rest));) {
        if (strcmp(word, "weight") == 0) {
            if (!number(rest, 0.0, 1e6, &lines->stage_weight[s]))
                return false;
        } else if (strcmp(word, "due") == 0) {
            const char *date = strtok_r(NULL, " \t", rest);
            if (!is_date(date))
                return false;
            snprintf(lines->due[s], sizeof lines->due[s], "%s", date);
        } else {
            return false;
        }
    }
    return true;
}

// late PERCENT [most PERCENT]
static bool late_line(char **rest, Lines *lines)
{
    lines->late_most = 100.0;
    if (!number(rest, 0.0, 100.0, &lines->late_per_day))
        return false;
    const char *word = strtok_r(NULL, " \t", rest);
    return !word || (strcmp(word, "most") == 0 && number(rest, 0.0, 100.0, &lines->late_most));
}

static bool read_line(char *line, Lines *lines, PointsTable *table, const char **expected)
{
    char *rest;
    const char *word = strtok_r(line, " \t", &rest);
    if (!word)
        return true;
    if (strcmp(word, "step") == 0)
        return step_line(&rest, lines, table, expected);
    if (strcmp(word, "stage") == 0)
        return stage_line(&rest, lines, expected);
    *expected = "a number of points behind `total`";
    if (strcmp(word, "total") == 0)
        return number(&rest, 1e-3, 1e6, &lines->total);
    *expected = "a percentage from 0 to 100 behind `picture`";
    if (strcmp(word, "picture") == 0)
        return number(&rest, 0.0, 100.0, &lines->picture);
    *expected = "late PERCENT [most PERCENT], each from 0 to 100, e.g. `late 10 most 50`";
    if (strcmp(word, "late") == 0)
        return late_line(&rest, lines);
    *expected = "how many stages there are to be behind `stages`, e.g. `stages 3`";
    if (strcmp(word, "stages") == 0)
        return number(&rest, 1.0, STAGE_COUNT, &lines->stages) && lines->stages == (int)lines->stages;
    *expected = "a line that begins with step, stage, stages, late, total or picture";
    return false;
}

static bool weights_to_points(const char *path, const Lines *lines, PointsTable *table, Error *error)
{
    double sum = 0.0;
    for (int i = 0; i < STEP_COUNT; i++) {
        if (!lines->given[i])
            return error_set(error, "%s: no line for step %s; give it weight 0 when it is not to count", path,
                             step_table[i].id);
        int stage = step_table[i].stage;
        table->points[i] = stage <= lines->stages ? lines->weight[i] * lines->stage_weight[stage] : 0.0;
        memcpy(table->due[i], lines->due[step_table[i].stage], sizeof table->due[i]);
        sum += table->points[i];
    }
    if (sum <= 0.0)
        return error_set(error, "%s: all weights are 0", path);
    for (int i = 0; i < STEP_COUNT; i++)
        table->points[i] *= lines->total / sum;
    table->stages = (int)lines->stages;
    table->picture_share = lines->picture / 100.0;
    table->late_per_day = lines->late_per_day / 100.0;
    table->late_most = lines->late_most / 100.0;
    return true;
}

bool points_read(const char *path, PointsTable *table, Error *error)
{
    memset(table, 0, sizeof *table);
    Lines lines = {.total = 100.0, .picture = 20.0, .stages = STAGE_COUNT};
    for (int i = 0; i < MOST_STAGES; i++)
        lines.stage_weight[i] = 1.0;
    size_t size;
    char *text = file_read(path, 1 << 20, &size, error);
    if (!text)
        return false;
    bool ok = true;
    int number_of_line = 1;
    for (char *line = text, *next; ok && line; line = next, number_of_line++) {
        next = strchr(line, '\n');
        if (next)
            *next++ = '\0';
        line[strcspn(line, "#\r")] = '\0';
        const char *expected = "";
        if (!read_line(line, &lines, table, &expected))
            ok = error_set(error, "%s:%d: expected %s", path, number_of_line, expected);
    }
    free(text);
    return ok && weights_to_points(path, &lines, table, error);
}

// A step's own checks decide; a picture that is merely off costs its share, one that is none or far off costs all: code
// that knows the checks' inputs by heart makes such pictures.
static double share_of(const PointsTable *table, const StepResult *result)
{
    if (result->status != STATUS_PASS && result->status != STATUS_FAIL)
        return 0.0;
    double share = 1.0;
    for (int i = 0; i < result->check_count; i++) {
        const CheckResult *check = &result->checks[i];
        if (check->status == STATUS_PASS)
            continue;
        const Finding *finding = &check->finding;
        if (check->check->kind != CHECK_PICTURE || finding->failed || finding->T > FAR_OFF * finding->T_threshold)
            return 0.0;
        share = 1.0 - table->picture_share;
    }
    return share;
}

// Dates are compared as text, in the machine's own time; the due date is the last day on which a hidden step is hidden.
static bool is_past(const char *due)
{
    char today[16];
    time_t now = time(NULL);
    strftime(today, sizeof today, "%Y-%m-%d", localtime(&now));
    return *due && strcmp(today, due) > 0;
}

void points_give(const PointsTable *table, StepResult *result)
{
    size_t i = (size_t)(result->step - step_table);
    result->points_max = table->points[i];
    result->points = table->points[i] * share_of(table, result);
    result->hidden = table->hidden[i] && !is_past(table->due[i]);
    memcpy(result->due, table->due[i], sizeof result->due);
}
