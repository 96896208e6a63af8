#include "cli/cli.h"
#include "photons/pass/oddities.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

int report_error(const Error *error)
{
    fprintf(stderr, "%s\n", error->message[0] ? error->message : "failed for a reason that was not given");
    return EXIT_INPUT;
}

static struct {
    double started, drawn;
    char phase[32];
    bool wanted, shown;
} bar;

static void draw_bar(void *user, const char *phase, double fraction)
{
    (void)user;
    guard_alive();
    if (!bar.wanted)
        return;
    double now = clock_seconds();
    if (strcmp(bar.phase, phase) != 0) {
        snprintf(bar.phase, sizeof bar.phase, "%s", phase);
        bar.started = now;
        bar.drawn = 0.0;
    }
    if (now - bar.drawn < 0.1 && fraction < 1.0)
        return;
    bar.drawn = now;
    bar.shown = true;
    int full = (int)(30.0 * fraction);
    double elapsed = now - bar.started;
    double left = fraction > 0.0 ? elapsed * (1.0 - fraction) / fraction : 0.0;
    fprintf(stderr, "\r%-9s [%.*s%.*s] %3.0f %%  %.0f s left   ", phase, full, "##############################",
            30 - full, "..............................", 100.0 * fraction, ceil(left));
    fflush(stderr);
}

Progress progress_bar_start(bool quiet)
{
    bar.wanted = !quiet && isatty(STDERR_FILENO);
    return (Progress){draw_bar, NULL};
}

void progress_bar_end(void)
{
    if (bar.shown)
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

void choose_steps(const char *code, const char *steps_text, bool spectral, const Scene *scene, StepChoice *play)
{
    if (code && !steps_text)
        *play = step_choice_for_student();
    if (spectral || (!steps_text && scene->settings.spectral))
        play->loop = LOOP_WAVELENGTH;
}

bool write_picture(Image *image, const char *path, int bits, bool *sound, Error *error)
{
    *sound = image_mark_unsound(image, path, error);
    return image_write_bits(image, path, bits, error) && *sound;
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

void print_ledger_json(const Ledger *ledger, const UnsoundPaths *unsound)
{
    static const char *const NAMES[] = {"emitted", "absorbed", "escaped", "cut", "chance", "chance_error"};
    const double *const values[] = {ledger->emitted, ledger->absorbed, ledger->escaped,
                                    ledger->cut,     ledger->chance,   ledger->chance_error};
    printf("\"redraw_caps\":%ld,\"unsound\":%ld,", redraw_cap_count(), unsound->total);
    for (int i = 0; i < 6; i++)
        printf("%s\"%s\":[%.9g,%.9g,%.9g]", i == 0 ? "\"ledger\":{" : ",", NAMES[i], values[i][0], values[i][1],
               values[i][2]);
    printf("}}\n");
}
