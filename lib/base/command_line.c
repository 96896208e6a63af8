#include "base/command_line.h"
#include "base/text.h"

#include <errno.h>
#include <getopt.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int report_usage(const char *command, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char what[1024];
    Error error = {""};
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    error_set(&error, "%s", what);
    fprintf(stderr, "%s: %s\n%s --help lists the flags\n", command, error.message, command);
    return EXIT_USAGE;
}

static bool in_range(const Flag *flag, double value)
{
    return value >= flag->low && value <= flag->high; // NaN is neither
}

static bool parse_size(const Flag *flag, const char *text, int size[2])
{
    char after;
    return sscanf(text, "%dx%d%c", &size[0], &size[1], &after) == 2 && in_range(flag, size[0]) &&
           in_range(flag, size[1]);
}

static bool parse_choice(const char *text, Choice *choice)
{
    int i = 0;
    while (choice->names[i] && strcmp(text, choice->names[i]) != 0)
        i++;
    choice->chosen = i;
    return choice->names[i];
}

static bool is_whole(FlagKind kind)
{
    return kind == FLAG_INT || kind == FLAG_LONG || kind == FLAG_WHOLE;
}

static bool parse_number(const Flag *flag, const char *text)
{
    char *end;
    errno = 0;
    double number = is_whole(flag->kind) ? (double)strtol(text, &end, 10) : (double)strtof(text, &end);
    if (end == text || *end || (is_whole(flag->kind) && errno == ERANGE) || !in_range(flag, number))
        return false;
    if (flag->kind == FLAG_INT)
        *(int *)flag->value = (int)number;
    else if (flag->kind == FLAG_LONG)
        *(long *)flag->value = (long)number;
    else if (flag->kind == FLAG_FLOAT)
        *(float *)flag->value = (float)number;
    else
        *(double *)flag->value = number;
    return true;
}

static bool take_flag(const Flag *flag, const char *text)
{
    char *end;
    switch (flag->kind) {
    case FLAG_PRESENT:
        *(bool *)flag->value = true;
        return true;
    case FLAG_ON:
        *(double *)flag->value = 1.0;
        return true;
    case FLAG_TEXT:
        *(const char **)flag->value = text;
        return true;
    case FLAG_SIZE:
        return parse_size(flag, text, flag->value);
    case FLAG_CHOICE:
        return parse_choice(text, flag->value);
    case FLAG_SEED:
        errno = 0;
        *(uint64_t *)flag->value = strtoull(text, &end, 10);
        return end != text && !*end && errno == 0 && !strchr(text, '-');
    case FLAG_INT:
    case FLAG_LONG:
    case FLAG_WHOLE:
    case FLAG_FLOAT:
    case FLAG_NUMBER:
        return parse_number(flag, text);
    }
    return false;
}

static int refuse_flag(const char *command, const Flag *flag, const char *text)
{
    if (flag->kind == FLAG_CHOICE) {
        char names[400] = "";
        for (const char *const *name = ((Choice *)flag->value)->names; *name; name++)
            text_append(names, sizeof names, "%s%s", !names[0] ? "" : name[1] ? ", " : " or ", *name);
        return report_usage(command, "--%s %s: expected %s", flag->name, text, names);
    }
    if (flag->kind == FLAG_SIZE)
        return report_usage(command, "--%s %s: expected WIDTHxHEIGHT, each from %.10g to %.10g, e.g. 640x480",
                            flag->name, text, flag->low, flag->high);
    if (flag->kind == FLAG_SEED)
        return report_usage(command, "--%s %s: expected a whole number from 0 to 18446744073709551615", flag->name,
                            text);
    return report_usage(command, "--%s %s: expected a %s from %.10g to %.10g", flag->name, text,
                        is_whole(flag->kind) ? "whole number" : "number", flag->low, flag->high);
}

int command_line_parse(const CommandLine *line, int count, char **arguments, const char **files)
{
    struct option options[MOST_FLAGS + 2] = {{"help", no_argument, NULL, 'h'}};
    int out = -1; // which is -o
    for (int i = 0; i < line->flag_count && i < MOST_FLAGS && line->flags[i].name; i++) {
        const Flag *flag = &line->flags[i];
        out = strcmp(flag->name, "o") == 0 ? i : out;
        options[i + 1] = (struct option){
            flag->name, flag->kind == FLAG_PRESENT || flag->kind == FLAG_ON ? no_argument : required_argument, NULL,
            256 + i};
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
        int i = found == 'o' ? out : found - 256;
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
