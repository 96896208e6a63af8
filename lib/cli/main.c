#include "cli/cli.h"
#include "base/file.h"

#include <stdio.h>
#include <string.h>

static const Command *const commands[] = {&command_render,  &command_preview, &command_merge,
                                          &command_photons, &command_diff,    &command_export,
                                          &command_frame,   &command_steps,   NULL};

static const char *name_of(const Command *command)
{
    return command->line.command + strlen("photonlab ");
}

static void print_help(FILE *stream)
{
    fprintf(stream, "photonlab: photon mapping to learn from\n\nusage: photonlab COMMAND …\n\n");
    for (size_t i = 0; commands[i]; i++)
        fprintf(stream, "  %-9s %s\n", name_of(commands[i]), commands[i]->words);
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

static int run(const Command *command, int count, char **arguments)
{
    if (command->prepare && !command->prepare())
        return EXIT_INPUT;
    int wrong = command_line_parse(&command->line, count, arguments, command->files);
    return wrong == 0 ? command->run() : wrong == HELP_SHOWN ? 0 : wrong;
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
    for (size_t i = 0; commands[i]; i++)
        if (strcmp(arguments[1], name_of(commands[i])) == 0)
            return all_printed(run(commands[i], count - 1, arguments + 1));
    return report_usage("photonlab", "no command `%s`", arguments[1]);
}
