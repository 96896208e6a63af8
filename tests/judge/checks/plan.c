#define _GNU_SOURCE // vasprintf
#include "judge/checks/check.h"
#include "base/array.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *const check_kind_names[CHECK_KINDS] = {"values", "samples", "energy", "invariant", "picture"};

// Running out of memory while planning a few hundred lines: there is nothing to save.
void *must(void *memory)
{
    if (!memory) {
        fprintf(stderr, "judge: not enough memory\n");
        exit(3);
    }
    return memory;
}

uint64_t hash_text(uint64_t hash, const char *text)
{
    for (; *text; text++)
        hash = hash_u64(hash ^ (uint64_t)(unsigned char)*text);
    return hash;
}

static unsigned long long next_seed(const Plan *plan)
{
    return hash_u64(plan->seed + plan->count - plan->first);
}

static PRINTF_LIKE(2, 3) size_t plan_line(Plan *plan, const char *format, ...)
{
    va_list arguments;
    if (!array_reserve(&plan->lines, plan->count + 1, &plan->capacity, sizeof *plan->lines))
        must(NULL);
    va_start(arguments, format);
    if (vasprintf(&plan->lines[plan->count], format, arguments) < 0)
        must(NULL);
    va_end(arguments);
    return plan->count++ - plan->first;
}

void plan_free(Plan *plan)
{
    for (size_t i = 0; i < plan->count; i++)
        free(plan->lines[i]);
    free(plan->lines);
}

size_t plan_call(Plan *plan, long count, const double *arguments, size_t argument_count)
{
    return plan_call_in(plan, "", count, arguments, argument_count);
}

size_t plan_call_in(Plan *plan, const char *scene, long count, const double *arguments, size_t argument_count)
{
    size_t size = 1 + 32 * argument_count, length = 0;
    char *numbers = must(calloc(size, 1));
    for (size_t i = 0; i < argument_count; i++)
        length += (size_t)snprintf(numbers + length, size - length, " %.9g", arguments[i]);
    size_t number = plan_line(plan, "call %ld %llu%s%s%s", count, next_seed(plan), *scene ? " " : "", scene, numbers);
    free(numbers);
    return number;
}

size_t plan_paths(Plan *plan, const char *scene, long photons, long batches, int depth, const char *steps_text)
{
    return plan_line(plan, "paths %s %ld %ld %d %s %llu", scene, photons, batches, depth, steps_text, next_seed(plan));
}

size_t plan_picture(Plan *plan, const char *kind, const char *integrator, const char *scene, int side, long photons,
                    int k, int depth, const char *steps_text)
{
    return plan_line(plan, "%s %s %s %d %d %ld %d %d %s %llu", kind, integrator, scene, side, side, photons, k, depth,
                     steps_text, next_seed(plan));
}

double drawn_input(uint64_t seed, int use, double low, double high)
{
    double share = (double)(hash_u64(seed ^ hash_u64((uint64_t)use)) >> 11) / 9007199254740992.0;
    return (double)(float)(low + (high - low) * share);
}

double drawn_magnitude(uint64_t seed, int use, double low, double high)
{
    return (double)(float)exp(drawn_input(seed, use, log(low), log(high)));
}

const char *words(const char *format, ...)
{
    static __thread char texts[8][300]; // steps are graded side by side
    static __thread int next;
    char *text = texts[next++ % 8];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof texts[0], format, arguments);
    va_end(arguments);
    return text;
}

void finding_fail(Finding *finding, long failing_case, const char *format, ...)
{
    if (finding->failed)
        return;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(finding->message, sizeof finding->message, format, arguments);
    va_end(arguments);
    finding->failed = true;
    finding->failing_case = failing_case;
}

void finding_p(Finding *finding, double p, long failing_case, const char *format, ...)
{
    finding->tests++;
    if (!(p >= 0.0))
        p = 0.0; // a statistic that is no number fits no distribution
    if (p >= finding->p)
        return;
    finding->p = p;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(finding->p_message, sizeof finding->p_message, format, arguments);
    va_end(arguments);
    if (!finding->failed)
        finding->failing_case = failing_case;
}

void finding_feature(Finding *finding, double value, double error)
{
    if (finding->feature_count < MOST_FEATURES)
        finding->features[finding->feature_count++] = (Feature){value, error};
}

void finding_ratio(Finding *finding, double found, double expected)
{
    if (expected == 0.0) {
        finding->not_zero = finding->not_zero || found != 0.0;
        return;
    }
    double ratio = found / expected; // NaN stays, and is no factor
    bool first = finding->ratios++ == 0;
    finding->lowest_ratio = first || !(ratio > finding->lowest_ratio) ? ratio : finding->lowest_ratio;
    finding->highest_ratio = first || !(ratio < finding->highest_ratio) ? ratio : finding->highest_ratio;
}

void finding_ratios(Finding *finding, const float *found, const double *expected, int count)
{
    for (int i = 0; i < count; i++)
        finding_ratio(finding, (double)found[i], expected[i]);
}

void finding_suspect(Finding *finding, const char *name, const char *format, ...)
{
    if (finding->suspected[0])
        return;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(finding->suspicion, sizeof finding->suspicion, format, arguments);
    va_end(arguments);
    snprintf(finding->suspected, sizeof finding->suspected, "%s", name);
}

void finding_histogram(Finding *finding, const char *title, double low, double high, const double *observed,
                       const double *expected, int bins)
{
    snprintf(finding->histogram_title, sizeof finding->histogram_title, "%s", title);
    finding->low = low;
    finding->high = high;
    finding->bins = bins < MOST_BINS ? bins : MOST_BINS;
    for (int i = 0; i < finding->bins; i++) {
        finding->observed[i] = observed[i];
        finding->expected[i] = expected[i];
    }
}
