#include "cli/render.h"
#include "base/file.h"
#include "image/difference.h"

#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

bool passes_wanted(const RenderJob *job)
{
    return job->passes || job->seconds > 0.0f || job->resume;
}

// "3/8"; false: it is none.
static bool parse_part(const char *text, PassOrigin *origin)
{
    char after;
    return sscanf(text, "%d/%d%c", &origin->part, &origin->parts, &after) == 2 && origin->part >= 1 &&
           origin->part <= origin->parts;
}

bool pass_flags_check(const RenderJob *job, Error *error)
{
    PassOrigin origin;
    bool is_part_file = file_ends_in(job->out, PASS_FILE_ENDING);
    if (!passes_wanted(job) && (is_part_file || job->part || job->alpha > 0.0f || job->radii.chosen >= 0))
        return error_set(error, "--alpha, --radii, --part and files of passes (" PASS_FILE_ENDING
                                ") belong to --passes or --seconds");
    if (!job->part)
        return true;
    if (!parse_part(job->part, &origin))
        return error_set(error, "--part %s: expected a part and how many there are, 3/8 say", job->part);
    if (!job->passes || job->seconds > 0.0f)
        return error_set(error, "--part %s: expected --passes, which it is a part of, and no --seconds", job->part);
    if (origin.parts > job->passes)
        return error_set(error, "--part %s: %d passes cannot be parted into %d", job->part, job->passes, origin.parts);
    if (!is_part_file)
        return error_set(error,
                         "--part %s: gives no picture but a file for `photonlab merge`: -o part%d" PASS_FILE_ENDING,
                         job->part, origin.part);
    return job->radii.chosen != 1 ||
           error_set(error, "--part %s: with --radii pixel each pass needs the one before", job->part);
}

// ---- somebody wants it to stop ----

static volatile sig_atomic_t stop_asked;
static const int stops[] = {SIGINT, SIGTERM};
static void (*before[2])(int); // what was to be done otherwise

static void ask_to_stop(int number)
{
    static const char words[] = "\nthis pass is the last; once more: at once\n";
    stop_asked = 1;
    signal(number, before[number == SIGTERM]);
    ssize_t ignored = write(STDERR_FILENO, words, sizeof words - 1);
    (void)ignored;
}

static void watch_for_stop(void)
{
    for (int i = 0; i < 2; i++) {
        before[i] = signal(stops[i], ask_to_stop);
        if (before[i] == SIG_IGN) // as the shell wants it of what runs in the background
            signal(stops[i], SIG_IGN);
    }
}

// ---- while it runs ----

typedef struct {
    RenderJob *job;
    PassOrigin origin;
    const Passes *passes;
    Progress drawn;
    double started;
    Image before;   // the picture when there were half as many passes; no pixels: it is not known
    double error;   // expected, at `measured` passes; 0: not known
    int measured;   // passes
    bool failed;    // to write
    Error *problem; // why
} Talk;

static int wanted(const Talk *talk)
{
    return talk->passes->last - talk->passes->first;
}

// Progress of a pass into that of all.
static void show_progress(void *user, const char *phase, double fraction)
{
    Talk *talk = user;
    double in_pass = strcmp(phase, "eye rays") == 0 ? 0.5 + 0.5 * fraction : 0.5 * fraction;
    double all = (talk->passes->done + in_pass) / wanted(talk);
    if (talk->job->seconds > 0.0f)
        all = fmax(all, fmin(1.0, (clock_seconds() - talk->started) / (double)talk->job->seconds));
    progress_report(&talk->drawn, "passes", all);
}

// The file that was asked for, as far as the passes are.
static bool write_out(Talk *talk, Image *image)
{
    RenderJob *job = talk->job;
    bool ok = file_ends_in(job->out, PASS_FILE_ENDING)
                  ? pass_file_write(job->out, &talk->origin, talk->passes, talk->problem)
                  : write_picture(image, job->out, job->bits, &job->sound, talk->problem);
    if (job->tev)
        tev_show_all(image);
    return ok;
}

// Half of the passes and all of them: how far they are apart tells how far all are from the mean of infinitely many.
static void measure(Talk *talk, Image *image)
{
    ImageDifference difference;
    bool known =
        talk->before.pixels && image_difference(&talk->before, image, (ImageMask){0, 0, 0, 0}, &difference, NULL);
    talk->error = known ? difference.relative_mse_trimmed : 0.0;
    talk->measured = talk->passes->done;
    image_free(&talk->before);
    talk->before = *image;
    *image = (Image){0, 0, NULL};
}

static double expected_error(const Talk *talk, int passes)
{
    return talk->error * pow((double)talk->measured / passes, (double)talk->passes->alpha);
}

static void tell(Talk *talk)
{
    int done = talk->passes->done;
    if (talk->job->quiet)
        return;
    progress_bar_end();
    fprintf(stderr, "%d pass%s, %.1f s", done, done == 1 ? "" : "es", clock_seconds() - talk->started);
    if (talk->error > 0.0)
        fprintf(stderr, ": relMSE about %.1e", expected_error(talk, done));
    if (talk->error > 0.0 && done < wanted(talk) && talk->job->seconds <= 0.0f)
        fprintf(stderr, ", after %d about %.1e", wanted(talk), expected_error(talk, wanted(talk)));
    fprintf(stderr, "\n");
}

// A picture after 1, 2, 4, 8 … passes.
static bool after_pass(void *user, const Passes *passes)
{
    Talk *talk = user;
    if ((passes->done & (passes->done - 1)) == 0) {
        Image image = {0, 0, NULL};
        talk->failed = !passes_picture(passes, &image, talk->problem) || !write_out(talk, &image);
        if (!talk->failed) {
            measure(talk, &image);
            tell(talk);
        }
        image_free(&image);
    }
    double seconds = (double)talk->job->seconds;
    return !talk->failed && !stop_asked && (seconds <= 0.0 || clock_seconds() - talk->started < seconds);
}

// ---- before and after ----

// What there is already, if it belongs to this picture. Its --passes may be others, unless it is a part.
static bool resume(const RenderJob *job, PassOrigin *origin, Passes *passes, Error *error)
{
    char differs[800];
    PassOrigin found;
    float alpha = passes->alpha;
    if (!pass_file_read(job->resume, &found, passes, error))
        return false;
    passes->alpha = alpha;
    if (pass_origin_differs(&found, origin, differs, sizeof differs))
        return error_set(error, "%s: %s", job->resume, differs);
    if (!job->passes && job->seconds <= 0.0f)
        origin->all = found.all;
    if (!job->part) {
        origin->part = found.part;
        origin->parts = found.parts;
    }
    if (found.part != origin->part || found.parts != origin->parts || (found.parts > 1 && found.all != origin->all))
        return error_set(error, "%s: is part %d/%d of %d passes; expected part %d/%d of %d", job->resume, found.part,
                         found.parts, found.all, origin->part, origin->parts, origin->all);
    pass_origin_range(origin, &passes->first, &passes->last);
    return passes->done <= passes->last - passes->first ||
           error_set(error, "%s: holds %d passes already; expected at most %d", job->resume, passes->done,
                     passes->last - passes->first);
}

static bool finish(Talk *talk, bool stopped, Error *error)
{
    const Passes *passes = talk->passes;
    Image image = {0, 0, NULL};
    if (talk->job->seconds > 0.0f && !stopped) // these are all
        talk->origin.all = passes->done;
    bool ok = passes_picture(passes, &image, error) && write_out(talk, &image);
    image_free(&image);
    if (ok && talk->measured != passes->done)
        tell(talk);
    if (!ok || !stopped)
        return ok;
    char path[4096];
    snprintf(path, sizeof path, "%s%s", talk->job->out,
             file_ends_in(talk->job->out, PASS_FILE_ENDING) ? "" : PASS_FILE_ENDING);
    return pass_file_write(path, &talk->origin, passes, error) &&
           error_set(error, "stopped after %d of %d passes; to go on: the same command with --resume %s", passes->done,
                     wanted(talk), path);
}

bool render_by_passes(RenderJob *job, const Scene *scene, RenderStats *stats, Error *error)
{
    RenderOptions options = job->options;
    Passes passes = {.alpha = job->alpha > 0.0f ? job->alpha : PASS_ALPHA, .by_pixel = job->radii.chosen == 1};
    Talk talk = {.job = job,
                 .origin = {.part = 1, .parts = 1, .all = job->passes ? job->passes : MOST_PASSES},
                 .passes = &passes,
                 .problem = error,
                 .started = clock_seconds()};
    if (passes.by_pixel && options.integrator != INTEGRATOR_PHOTONS)
        return error_set(error, "--radii pixel: expected the integrator photons");
    if (job->part)
        parse_part(job->part, &talk.origin);
    if (!pass_origin_scene(job->scene, scene, &talk.origin, error))
        return false;
    pass_origin_settings(&options, &passes, &talk.origin);
    pass_origin_range(&talk.origin, &passes.first, &passes.last);
    bool ok = !job->resume || resume(job, &talk.origin, &passes, error);

    talk.drawn = progress_bar_start(job->quiet);
    options.progress = (Progress){show_progress, &talk};
    passes.heard = after_pass;
    passes.user = &talk;
    watch_for_stop();
    ok = ok && passes_run(scene, &options, &passes, stats, error) && !talk.failed;
    progress_bar_end();
    ok = ok && finish(&talk, stop_asked && passes.done < wanted(&talk), error);
    image_free(&talk.before);
    passes_free(&passes);
    return ok;
}
