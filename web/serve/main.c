// serve: what `make preview WEB=1` runs, with make's commands to build and to link.
#include "web/serve/serve.h"
#include "base/command_line.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define BUSY_WAIT 5  // ms, while something is built
#define IDLE_WAIT 25 // ms: as late as this a save is noticed

static const char help[] =
    "usage: serve [flags] PAGE\n"
    "\n"
    "Serves the lab with a student's steps in it on 127.0.0.1; PAGE is the folder of tab.html, tab.js and photonlab.wasm.\n"
    "\n"
    "  --watch DIR         the student's .c files\n"
    "  --code DIR          what they become\n"
    "  --build COMMAND     after each save below the first: sh -c COMMAND sh SOURCE.c OBJECT.so\n"
    "  --link COMMAND      then sh -c COMMAND sh MODULE.wasm OBJECT.so…\n"
    "  --judge COMMAND     and sh -c COMMAND sh ID, whose verdict of the step stands beside\n"
    "  --scene NAME        of the page's scenes, to begin with\n"
    "  --steps LIST        which play where several do the same work, as photonlab preview has it\n"
    "  --stage N           begin with a step of this stage\n"
    "  --stages N          the course has the first N stages; the panel leaves out the others\n"
    "  --port N            (any that is free)\n";

static volatile sig_atomic_t ended;

static void on_signal(int number)
{
    (void)number;
    ended = true;
}

int main(int count, char **arguments)
{
    TabOptions options = {.scene = "box_diffuse.yaml"};
    const Flag flags[] = {
        {"watch", FLAG_TEXT, &options.source, 0, 0},
        {"code", FLAG_TEXT, &options.objects, 0, 0},
        {"build", FLAG_TEXT, &options.build, 0, 0},
        {"link", FLAG_TEXT, &options.link, 0, 0},
        {"judge", FLAG_TEXT, &options.judge, 0, 0},
        {"scene", FLAG_TEXT, &options.scene, 0, 0},
        {"steps", FLAG_TEXT, &options.steps, 0, 0},
        {"stage", FLAG_INT, &options.stage, 0, STAGE_COUNT},
        {"stages", FLAG_INT, &options.stages, 0, STAGE_COUNT},
        {"port", FLAG_INT, &options.port, 0, 65535},
    };
    CommandLine line = {"serve", help, "one folder", flags, FLAG_COUNT(flags), 1, 1};
    int wrong = command_line_parse(&line, count, arguments, &options.page);
    if (wrong)
        return wrong == HELP_SHOWN ? 0 : wrong;
    if (!options.source || !options.objects || !options.build || !options.link)
        return report_usage("serve", "--watch, --code, --build and --link are needed");
    static Tab tab;
    Error error = {""};
    Server *server = NULL;
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ);
    signal(SIGINT, on_signal);
    signal(SIGTERM, on_signal);
    signal(SIGPIPE, SIG_IGN);
    if (tab_start(&tab, &options, &error) && (server = server_start(&tab, &options, &error)))
        server_greet(server);
    while (server && !ended)
        server_run(server, tab_is_busy(&tab) ? BUSY_WAIT : IDLE_WAIT, tab_poll(&tab));
    server_stop(server);
    tab_stop(&tab);
    if (error.message[0])
        fprintf(stderr, "%s\n", error.message);
    return error.message[0] ? 1 : 0;
}
