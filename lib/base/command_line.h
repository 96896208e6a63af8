// A program's flags, read by a table. Alone in the library, this prints: it speaks for main.
#pragma once

#include <stdbool.h>

#define EXIT_USAGE 2

// A flag and where its value goes. Numbers must lie in low…high.
typedef enum {
    FLAG_PRESENT, // bool
    FLAG_TEXT,    // const char *
    FLAG_INT,
    FLAG_LONG,
    FLAG_FLOAT,
    FLAG_SEED,   // uint64_t
    FLAG_SIZE,   // int[2]: WIDTHxHEIGHT
    FLAG_CHOICE, // Choice
    FLAG_ON,     // a double of the preview's settings: 1
    FLAG_WHOLE,  // such a double: a whole number
    FLAG_NUMBER  // such a double: any number
} FlagKind;
typedef struct {
    const char *const *names; // one of them is expected; they end with NULL
    int chosen;
} Choice;
typedef struct {
    const char *name; // "photons" for --photons; "o" for -o
    FlagKind kind;
    void *value;
    double low, high;
} Flag;

// What a program takes: flags, and from `least` to `most` names of files, called `files` in messages, which begin with
// `command`: "photonlab render", say.
typedef struct {
    const char *command, *help, *files;
    const Flag *flags;
    int flag_count, least, most;
} CommandLine;

#define FLAG_COUNT(flags) (int)(sizeof(flags) / sizeof *(flags))
#define MOST_FLAGS        64 // flag_count may be more than there are: a flag without a name ends them

// 0: all values are filled in, file[0 …] point to the files' names (those not given stay). Otherwise the message is
// printed and this is the exit code, or HELP_SHOWN.
int command_line_parse(const CommandLine *line, int count, char **arguments, const char **files);
#define HELP_SHOWN (-1)

// Prints "COMMAND: message" and how to get help; returns EXIT_USAGE.
int report_usage(const char *command, const char *format, ...);
