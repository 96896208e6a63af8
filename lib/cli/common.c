#include "cli/cli.h"
#include "photons/pass/oddities.h"

#include <errno.h>
#include <getopt.h>
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

static bool parse_whole(const Flag *flag, const char *text, long *value)
{
    char *end;
    errno = 0;
    *value = strtol(text, &end, 10);
    return end != text && !*end && errno == 0 && (double)*value >= flag->low && (double)*value <= flag->high;
}

static bool parse_float(const Flag *flag, const char *text, float *value)
{
    char *end;
    *value = strtof(text, &end);
    return end != text && !*end && (double)*value >= flag->low && (double)*value <= flag->high; // NaN is neither
}

static bool parse_seed(const char *text, uint64_t *value)
{
    char *end;
    errno = 0;
    *value = strtoull(text, &end, 10);
    return end != text && !*end && errno == 0 && !strchr(text, '-');
}

static bool take_flag(const Flag *flag, const char *text)
{
    long whole;
    switch (flag->kind) {
    case FLAG_PRESENT:
        *(bool *)flag->value = true;
        return true;
    case FLAG_TEXT:
        *(const char **)flag->value = text;
        return true;
    case FLAG_INT:
        if (!parse_whole(flag, text, &whole))
            return false;
        *(int *)flag->value = (int)whole;
        return true;
    case FLAG_LONG:
        return parse_whole(flag, text, flag->value);
    case FLAG_FLOAT:
        return parse_float(flag, text, flag->value);
    case FLAG_SEED:
        return parse_seed(text, flag->value);
    }
    return false;
}

static int refuse_flag(const char *command, const Flag *flag, const char *text)
{
    if (flag->kind == FLAG_SEED)
        return report_usage(command, "--%s %s: expected a whole number from 0 to 18446744073709551615", flag->name,
                            text);
    return report_usage(command, "--%s %s: expected a %s from %.10g to %.10g", flag->name, text,
                        flag->kind == FLAG_FLOAT ? "number" : "whole number", flag->low, flag->high);
}

int command_line_parse(const CommandLine *line, int count, char **arguments, const char **files)
{
    struct option options[MOST_FLAGS + 2] = {{"help", no_argument, NULL, 'h'}};
    for (int i = 0; i < line->flag_count && i < MOST_FLAGS; i++) {
        const Flag *flag = &line->flags[i];
        options[i + 1] =
            (struct option){flag->name, flag->kind == FLAG_PRESENT ? no_argument : required_argument, NULL, 256 + i};
    }
    optind = 1;
    opterr = 0; // the messages are ours
    for (int found; (found = getopt_long(count, arguments, "o:h", options, NULL)) != -1;) {
        if (found == 'h') {
            fputs(line->help, stdout);
            return HELP_SHOWN;
        }
        if (found == '?')
            return report_usage(line->command, "%s: no such flag, or its value is missing", arguments[optind - 1]);
        int i = found - 256;
        for (int j = 0; found == 'o' && j < line->flag_count; j++)
            i = strcmp(line->flags[j].name, "o") == 0 ? j : i;
        if (i < 0)
            return report_usage(line->command, "writes no file; -o has no meaning here");
        if (!take_flag(&line->flags[i], optarg))
            return refuse_flag(line->command, &line->flags[i], optarg);
    }
    int given = count - optind;
    if (given < line->least || given > line->most)
        return report_usage(line->command, "expected %s, found %d", line->files, given);
    for (int i = 0; i < given; i++)
        files[i] = arguments[optind + i];
    return 0;
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

// Prints the ids of the steps in this state that play, or do not; how many.
static int print_ids(StepState state, bool played, StepChoice choice, const char *title)
{
    int count = 0;
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (step_states[i] == state && step_is_played(&step_table[i], choice) == played)
            fprintf(stderr, "%s %s", count++ == 0 ? title : "", step_table[i].id);
    if (count > 0)
        fprintf(stderr, "\n");
    return count;
}

void report_steps(StepChoice choice, bool path_tracer)
{
    if (path_tracer) {
        fprintf(stderr, "the path tracer plays no step: --code has no effect\n");
        return;
    }
    if (print_ids(STEP_STUDENT, true, choice, "your code plays:") == 0)
        fprintf(stderr, "your code plays: nothing yet\n");
    print_ids(STEP_STUDENT, false, choice, "built, but not played (see --steps):");
    print_ids(STEP_NOT_STARTED, true, choice, "not started, still calling todo():");
    print_ids(STEP_NOT_STARTED, false, choice, "not started, still calling todo(), and not played:");
    fprintf(stderr, "the reference plays the rest\n");
}

void report_suspects(StepChoice choice)
{
    print_ids(STEP_STUDENT, true, choice,
              "one of your steps may have returned NaN (0/0, or the root of a negative number):");
}

void report_oddities(const Ledger *ledger, long paths, const UnsoundPaths *unsound)
{
    char text[ODDITIES_SIZE];
    Oddities found = {ledger, paths, unsound, redraw_cap_count(), step_states};
    oddities_describe(&found, text, sizeof text);
    fputs(text, stderr);
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
