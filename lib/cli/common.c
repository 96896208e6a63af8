#include "cli/cli.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int report_error(const Error *error)
{
    fprintf(stderr, "%s\n", error->message[0] ? error->message : "failed for a reason that was not given");
    return EXIT_INPUT;
}

int report_usage(const char *command, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fprintf(stderr, "photonlab %s: ", command);
    vfprintf(stderr, format, arguments);
    fprintf(stderr, "\nphotonlab %s --help lists the flags\n", command);
    va_end(arguments);
    return EXIT_USAGE;
}

bool parse_long(const char *command, const char *flag, const char *text, long low, long high, long *value)
{
    char *end;
    errno = 0;
    long parsed = strtol(text, &end, 10);
    if (end == text || *end || errno == ERANGE || parsed < low || parsed > high) {
        report_usage(command, "%s %s: expected a whole number from %ld to %ld", flag, text, low, high);
        return false;
    }
    *value = parsed;
    return true;
}

bool parse_int(const char *command, const char *flag, const char *text, int low, int high, int *value)
{
    long parsed;
    if (!parse_long(command, flag, text, low, high, &parsed))
        return false;
    *value = (int)parsed;
    return true;
}

bool parse_float(const char *command, const char *flag, const char *text, float low, float high, float *value)
{
    char *end;
    float parsed = strtof(text, &end);
    if (end == text || *end || !(parsed >= low && parsed <= high)) {
        report_usage(command, "%s %s: expected a number from %g to %g", flag, text, (double)low, (double)high);
        return false;
    }
    *value = parsed;
    return true;
}

bool parse_seed(const char *command, const char *flag, const char *text, uint64_t *value)
{
    char *end;
    errno = 0;
    unsigned long long parsed = strtoull(text, &end, 10);
    if (end == text || *end || errno == ERANGE || text[0] == '-') {
        report_usage(command, "%s %s: expected a whole number from 0 to 18446744073709551615", flag, text);
        return false;
    }
    *value = parsed;
    return true;
}

static void draw_bar(void *user, const char *phase, double fraction)
{
    ProgressBar *bar = user;
    double now = clock_seconds();
    if (strcmp(bar->phase, phase) != 0) {
        snprintf(bar->phase, sizeof bar->phase, "%s", phase);
        bar->started = now;
        bar->drawn = 0.0;
    }
    if (now - bar->drawn < 0.1 && fraction < 1.0)
        return;
    bar->drawn = now;
    bar->shown = true;
    char cells[31];
    int full = (int)(30.0 * fraction);
    for (int i = 0; i < 30; i++)
        cells[i] = i < full ? '#' : '.';
    cells[30] = '\0';
    double elapsed = now - bar->started;
    double left = fraction > 0.0 ? elapsed * (1.0 - fraction) / fraction : 0.0;
    fprintf(stderr, "\r%-9s [%s] %3.0f %%  %.0f s left   ", phase, cells, 100.0 * fraction, ceil(left));
    fflush(stderr);
}

Progress progress_bar_start(ProgressBar *bar, bool quiet)
{
    *bar = (ProgressBar){0.0, 0.0, "", false};
    if (quiet || !isatty(STDERR_FILENO))
        return (Progress){NULL, NULL};
    return (Progress){draw_bar, bar};
}

void progress_bar_end(ProgressBar *bar)
{
    if (bar->shown)
        fprintf(stderr, "\r%70s\r", "");
}

void report_steps(const char *code_dir)
{
    if (code_dir) {
        fprintf(stderr, "your code plays:");
        bool any = false;
        for (size_t i = 0; i < STEP_COUNT; i++)
            if (step_states[i] == STEP_STUDENT) {
                fprintf(stderr, " %s", step_table[i].id);
                any = true;
            }
        fprintf(stderr, "%s; the reference plays the rest (not started, or not in %s)\n", any ? "" : " nothing yet",
                code_dir);
    }
    if (redraw_cap_count() > 0)
        fprintf(stderr, "step 2.3: %ld photons were dropped after %d redraws of the lobe\n", redraw_cap_count(),
                MAX_LOBE_TRIES);
}

static void print_channels(const char *name, const double value[3])
{
    printf("\"%s\":[%.9g,%.9g,%.9g]", name, value[0], value[1], value[2]);
}

void print_ledger_json(const Ledger *ledger)
{
    printf("\"ledger\":{");
    print_channels("emitted", ledger->emitted);
    printf(",");
    print_channels("absorbed", ledger->absorbed);
    printf(",");
    print_channels("escaped", ledger->escaped);
    printf(",");
    print_channels("cut", ledger->cut);
    printf(",");
    print_channels("chance", ledger->chance);
    printf(",");
    print_channels("chance_error", ledger->chance_error);
    printf("}");
}
