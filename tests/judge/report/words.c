// Sums and numbers in words, the same in every format.
#include "report.h"
#include "base/text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

char *report_path(const Report *report, const char *name, char path[MOST_PATH])
{
    snprintf(path, MOST_PATH, "%s/%s", report->directory, name);
    return path;
}

const ReportScatter *report_scatter(const Report *report, int stage)
{
    for (size_t i = 0; i < report->scatter_count; i++)
        if (report->scatters[i].stage == stage)
            return &report->scatters[i];
    return NULL;
}

ReportStep report_scatter_step(const ReportScatter *scatter, char title[32])
{
    snprintf(title, 32, "of stage %d", scatter->stage);
    return (ReportStep){.id = "scatter",
                        .title = title,
                        .stage = scatter->stage,
                        .status = scatter->status == STATUS_TODO ? STATUS_SKIP : scatter->status,
                        .message = scatter->message,
                        .mistake = "scatter",
                        .output = "",
                        .seconds = scatter->seconds};
}

const ReportStep *report_next(const Report *report, const ReportStep *step)
{
    for (step = step ? step + 1 : report->steps; step < report->steps + report->step_count; step++)
        if (report->teacher || !step->hidden)
            return step;
    return NULL;
}

ReportSums report_sums(const Report *report, bool teacher, int stage)
{
    ReportSums sums = {.hidden = 0};
    for (size_t i = 0; i < report->step_count; i++) {
        const ReportStep *step = &report->steps[i];
        if (stage && step->stage != stage)
            continue;
        if (step->hidden && !teacher) {
            sums.hidden++;
            sums.hidden_points += step->points;
            sums.hidden_points_max += step->points_max;
            continue;
        }
        sums.steps++;
        sums.of[step->status]++;
        sums.points += step->points;
        sums.points_max += step->points_max;
        sums.seconds += step->seconds;
    }
    return sums;
}

// "in 30 % of runs", "once in 3000 runs", "once in 4 million runs".
static void words_of_odds(double p, char *words, size_t size)
{
    double runs = 1.0 / p;
    if (p > 0.999)
        snprintf(words, size, "in every run");
    else if (p > 0.01)
        snprintf(words, size, "in %.0f %% of runs", 100.0 * p);
    else if (runs < 1e4)
        snprintf(words, size, "once in %.0f runs", runs < 1000 ? floor(runs + 0.5) : 100 * floor(runs / 100 + 0.5));
    else if (runs < 1e6)
        snprintf(words, size, "once in %.0f thousand runs", runs / 1e3);
    else if (runs < 1e9)
        snprintf(words, size, "once in %.0f million runs", runs / 1e6);
    else
        snprintf(words, size, "less than once in a thousand million runs");
}

static void words_of_picture(const ReportPicture *picture, char *words, size_t size)
{
    words[0] = '\0';
    if (!isnan(picture->T) && !isnan(picture->T_threshold))
        text_append(words, size,
                    "Brightness: the worst patch is %.1f standard deviations off; up to %.1f is chance%s. ", picture->T,
                    picture->T_threshold, picture->T > picture->T_threshold ? ", so this is a wrong picture" : "");
    if (!isnan(picture->V) && !isnan(picture->V_threshold))
        text_append(words, size, "Noise: %.2f from the reference's (in logarithms); up to %.2f is chance%s.",
                    picture->V, picture->V_threshold,
                    picture->V > picture->V_threshold ? ", so this estimates otherwise" : "");
}

static void words_of_chance(double p, double threshold, char *words, size_t size)
{
    char found[80], limit[80];
    words_of_odds(p, found, sizeof found);
    words_of_odds(threshold, limit, sizeof limit);
    snprintf(words, size, "Right code is this far off %s; rarer than %s is taken for a mistake.", found, limit);
}

void words_of_check(const ReportCheck *check, char *words, size_t size)
{
    words[0] = '\0';
    bool judged = check->status == STATUS_PASS || check->status == STATUS_FAIL;
    bool certain = check->status == STATUS_FAIL && !(check->p < check->threshold);
    if (certain && !check->picture.yours)
        snprintf(words, size, "Right code never does this, whatever its random numbers: that decided.");
    else if (judged && check->picture.yours)
        words_of_picture(&check->picture, words, size);
    else if (judged && !isnan(check->p) && !isnan(check->threshold))
        words_of_chance(check->p, check->threshold, words, size);
}

void words_of_scatter(const ReportScatter *scatter, char *words, size_t size)
{
    snprintf(words, size, "Your %s together, the reference's for the rest.%s%.4000s", scatter->steps,
             *scatter->message ? "\n" : "", scatter->message);
    size_t used = strlen(words);
    if (isnan(scatter->p) || isnan(scatter->threshold) || used + 2 >= size)
        return;
    words[used] = '\n';
    words_of_chance(scatter->p, scatter->threshold, words + used + 1, size - used - 1);
}

static void checks_as_text(const ReportStep *step, FILE *stream)
{
    for (size_t i = 0; i < step->check_count; i++) {
        const ReportCheck *check = &step->checks[i];
        char words[400];
        words_of_check(check, words, sizeof words);
        fprintf(stream, "  %s %s%s%s\n", status_table[check->status].mark, check->title, *words ? ": " : "", words);
        if (check->status != STATUS_PASS && *check->message && strcmp(check->message, step->message) != 0)
            fprintf(stream, "      %s\n", check->message);
    }
}

char *words_of_step(const ReportStep *step, size_t most_output)
{
    char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);
    if (!stream)
        return NULL;
    if (*step->message || step->status != STATUS_PASS)
        fprintf(stream, "%s\n", *step->message ? step->message : status_table[step->status].words);
    if (*step->where)
        fprintf(stream, "where: %s\n", step->where);
    if (*step->looks_like)
        fprintf(stream, "looks like: %s\n", step->looks_like);
    if (step->status != STATUS_PASS)
        fprintf(stream, "make hint STEP=%s · chapter %s\n", step->id, step->chapter);
    if (step->status != STATUS_TODO)
        checks_as_text(step, stream);
    if (*step->output && step->status != STATUS_TODO && most_output > 0) {
        char *cut = text_clean(step->output, strlen(step->output), most_output);
        fprintf(stream, "printed:\n%s\n", cut ? cut : "");
        free(cut);
    }
    if (fclose(stream) == 0)
        return text;
    free(text);
    return NULL;
}
