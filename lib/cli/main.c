#include "cli/cli.h"
#include "base/file.h"

#include <stdio.h>
#include <string.h>

typedef struct {
    const char *name;
    int (*run)(int count, char **arguments);
    const char *help;
} Command;

static const Command commands[] = {
    {"render", command_render, "render a scene to a picture"},
    {"preview", command_preview, "a window on the photons, live; or a snapshot of it"},
    {"merge", command_merge, "one picture of passes that several machines have rendered"},
    {"photons", command_photons, "write the stored photons as a point cloud"},
    {"diff", command_diff, "compare two pictures"},
    {"export", command_export, "write a scene for Mitsuba 3 or pbrt-v4"},
    {"frame", command_frame, "a frame with words about a picture"},
    {"steps", command_steps, "list the steps to write, and hints for them"},
};

#define COMMAND_COUNT (sizeof commands / sizeof commands[0])

static void print_help(FILE *stream)
{
    fprintf(stream, "photonlab: photon mapping to learn from\n\nusage: photonlab COMMAND …\n\n");
    for (size_t i = 0; i < COMMAND_COUNT; i++)
        fprintf(stream, "  %-9s %s\n", commands[i].name, commands[i].help);
    fprintf(stream, "\nphotonlab COMMAND --help tells more. Try: photonlab render scenes/box_glass.yaml -o box.png\n");
}

// A command's exit code, unless a full disk took less than it printed.
static int all_printed(int code)
{
    if (fflush(stdout) == 0 && !ferror(stdout))
        return code;
    perror("photonlab: standard output");
    return code ? code : EXIT_INPUT;
}

int main(int count, char **arguments)
{
    file_clean_up_when_ended();
    if (count < 2) {
        print_help(stderr);
        return EXIT_USAGE;
    }
    if (strcmp(arguments[1], "help") == 0 && count == 3) { // `help COMMAND`
        arguments[1] = arguments[2];
        arguments[2] = "--help";
    }
    if (strcmp(arguments[1], "--help") == 0 || strcmp(arguments[1], "-h") == 0 || strcmp(arguments[1], "help") == 0) {
        print_help(stdout);
        return 0;
    }
    for (size_t i = 0; i < COMMAND_COUNT; i++)
        if (strcmp(arguments[1], commands[i].name) == 0)
            return all_printed(commands[i].run(count - 1, arguments + 1));
    return report_usage("photonlab", "no command `%s`", arguments[1]);
}
