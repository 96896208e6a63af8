#define _GNU_SOURCE // st_mtim
#include "preview/watch/watch_internal.h"
#include "base/parallel.h"

#include <errno.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define QUIET        0.03 // s after the last write: editors write several times
#define QUIET_DELETE 0.3  // s: editors that rename leave a gap
#define LOOK_ALONE   0.1  // s between looks at the files' times, without inotify
#define LOOK_BESIDE  1.0  // … and with it, for folders whose changes come from another machine

static void path_of(char *path, size_t size, const char *folder, const StepInfo *step, const char *ending)
{
    snprintf(path, size, "%s/%s%s", folder, step->file, ending);
}

const char *watch_step_name(const StepInfo *step)
{
    return strrchr(step->file, '/') + 1;
}

Fingerprint watch_fingerprint(const Watch *watch, size_t i)
{
    char path[4096];
    struct stat info;
    path_of(path, sizeof path, watch->source, &step_table[i], ".c");
    if (stat(path, &info) != 0)
        return (Fingerprint){.there = false};
    return (Fingerprint){true,
                         (long long)CHANGED_AT(info).tv_sec,
                         (long long)CHANGED_AT(info).tv_nsec,
                         (long long)info.st_size,
                         (unsigned long long)info.st_ino,
                         watch_headers_fingerprint(watch, i)};
}

static bool same_fingerprint(const Fingerprint *a, const Fingerprint *b)
{
    return a->there == b->there && a->seconds == b->seconds && a->nanoseconds == b->nanoseconds && a->size == b->size &&
           a->number == b->number && a->headers == b->headers;
}

void watch_mark(Watch *watch, size_t i)
{
    watch->files[i].fingerprint = watch_fingerprint(watch, i);
    watch->files[i].dirty = true;
    watch->files[i].since = clock_seconds();
}

// What the last build could not make, a day ago perhaps: it is tried again, and its error told.
static bool is_behind(const Watch *watch, size_t i)
{
    char source[4096], object[4096];
    struct stat from, made;
    path_of(source, sizeof source, watch->source, &step_table[i], ".c");
    path_of(object, sizeof object, watch->objects, &step_table[i], ".so");
    if (stat(source, &from) != 0)
        return false;
    if (stat(object, &made) != 0)
        return true;
    long long seconds = (long long)CHANGED_AT(from).tv_sec - (long long)CHANGED_AT(made).tv_sec;
    return seconds > 0 || (seconds == 0 && CHANGED_AT(from).tv_nsec > CHANGED_AT(made).tv_nsec);
}

static void look_at_times(Watch *watch)
{
    double now = clock_seconds();
    if (now - watch->looked < (watch->inotify >= 0 ? LOOK_BESIDE : LOOK_ALONE))
        return;
    watch->looked = now;
    for (size_t i = 0; i < STEP_COUNT; i++) {
        Fingerprint found = watch_fingerprint(watch, i);
        if (!same_fingerprint(&found, &watch->files[i].fingerprint))
            watch_mark(watch, i);
    }
}

Watch *watch_start(const char *source, const char *objects, const char *command, Error *error)
{
    struct stat info;
    if (stat(source, &info) != 0 || !S_ISDIR(info.st_mode)) {
        error_set(error, "%s: no such folder to watch", source);
        return NULL;
    }
    Watch *watch = calloc(1, sizeof *watch);
    char *copy = malloc(strlen(command) + 1);
    if (!watch || !copy || strlen(source) >= sizeof watch->source || strlen(objects) >= sizeof watch->objects) {
        error_set(error, "%s: cannot be watched: no memory, or too long a name", source);
        free(copy);
        free(watch);
        return NULL;
    }
    watch->command = strcpy(copy, command);
    strcpy(watch->source, source);
    strcpy(watch->objects, objects);
    watch->inotify = watch->build.compiler.output = -1;
    watch_start_listening(watch);
    for (size_t i = 0; i < STEP_COUNT; i++) {
        watch->files[i].fingerprint = watch_fingerprint(watch, i);
        if (is_behind(watch, i))
            watch_mark(watch, i);
    }
    return watch;
}

void watch_stop(Watch *watch)
{
    if (!watch)
        return;
    build_stop(&watch->build);
    if (watch->inotify >= 0)
        close(watch->inotify);
    free(watch->command);
    free(watch);
}

static WatchEvent remove_object(Watch *watch, size_t i, const char *object)
{
    if (unlink(object) != 0 && errno == ENOENT)
        return WATCH_NOTHING;
    snprintf(watch->message, sizeof watch->message, "%s.c: deleted; the reference plays in its place",
             watch_step_name(&step_table[i]));
    return WATCH_BUILT;
}

static WatchEvent begin_build(Watch *watch, size_t i)
{
    char source[4096], object[4096];
    Error error = {""};
    path_of(source, sizeof source, watch->source, &step_table[i], ".c");
    path_of(object, sizeof object, watch->objects, &step_table[i], ".so");
    watch->files[i].dirty = false;
    watch->files[i].error[0] = '\0';
    watch->files[i].fingerprint = watch_fingerprint(watch, i); // what is built, even if it was seen half-written before
    if (access(source, F_OK) != 0)
        return remove_object(watch, i, object);
    watch->building = i;
    if (build_start(&watch->build, watch->command, source, object, &error))
        return WATCH_BUILDING;
    snprintf(watch->message, sizeof watch->message, "%s.c: %.900s", watch_step_name(&step_table[i]), error.message);
    return WATCH_FAILED;
}

// Seconds until this file may be built; a deleted one may come back at once under the same name.
static double time_left(const Source *file)
{
    return file->since + (file->fingerprint.there ? QUIET : QUIET_DELETE) - clock_seconds();
}

// The one that waits longest.
static WatchEvent begin_next(Watch *watch)
{
    size_t next = STEP_COUNT;
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (watch->files[i].dirty && time_left(&watch->files[i]) <= 0.0 &&
            (next == STEP_COUNT || watch->files[i].since < watch->files[next].since))
            next = i;
    return next < STEP_COUNT ? begin_build(watch, next) : WATCH_NOTHING;
}

static WatchEvent end_build(Watch *watch, bool ok)
{
    char file[256];
    snprintf(file, sizeof file, "%s.c", watch_step_name(&step_table[watch->building]));
    watch->warning[0] = '\0';
    watch->files[watch->building].fingerprint.headers =
        watch_headers_fingerprint(watch, watch->building); // it may read others now
    if (ok) {
        snprintf(watch->message, sizeof watch->message, "%s: built in %.2f s", file,
                 clock_seconds() - watch->build.started);
        build_warning_line(&watch->build, file, watch->warning, sizeof watch->warning);
    }
    if (!ok) {
        build_error_line(&watch->build, file, watch->message, sizeof watch->message);
        snprintf(watch->files[watch->building].error, sizeof watch->files->error, "%.299s", watch->message);
    }
    return ok ? WATCH_BUILT : WATCH_FAILED;
}

static WatchEvent tell_of_stray(Watch *watch)
{
    snprintf(watch->message, sizeof watch->message,
             "%s: no step has this name, so nothing plays it; `build/photonlab steps` lists them", watch->stray);
    watch->stray[0] = '\0';
    return WATCH_FAILED;
}

WatchEvent watch_poll(Watch *watch)
{
    bool ok;
    watch_take_changes(watch);
    look_at_times(watch);
    if (watch->build.compiler.pid > 0 && watch->files[watch->building].dirty)
        build_stop(&watch->build); // what it would make is out of date
    if (watch->build.compiler.pid > 0)
        return build_poll(&watch->build, &ok) ? end_build(watch, ok) : WATCH_NOTHING;
    if (watch->stray[0])
        return tell_of_stray(watch);
    return begin_next(watch);
}

void watch_wait(Watch *watch, double seconds)
{
    double left = watch->looked + (watch->inotify >= 0 ? LOOK_BESIDE : LOOK_ALONE) - clock_seconds();
    seconds = left < seconds ? left : seconds;
    for (size_t i = 0; i < STEP_COUNT && watch->build.compiler.pid <= 0; i++)
        if (watch->files[i].dirty && time_left(&watch->files[i]) < seconds)
            seconds = time_left(&watch->files[i]);
    if (watch->build.compiler.pid > 0 && watch->build.compiler.output < 0)
        seconds = seconds < 0.005 ? seconds : 0.005; // it has nothing more to say, and is about to end
    struct pollfd watched[2] = {{watch->inotify, POLLIN, 0},
                                {watch->build.compiler.pid > 0 ? watch->build.compiler.output : -1, POLLIN, 0}};
    poll(watched, 2, seconds > 0.0 ? (int)(1e3 * seconds + 0.999) : 0);
}

const char *watch_message(const Watch *watch)
{
    return watch->message;
}

const StepInfo *watch_step(const Watch *watch)
{
    return &step_table[watch->building];
}

const char *watch_broken(const Watch *watch)
{
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (watch->files[i].error[0])
            return watch->files[i].error;
    return "";
}

const char *watch_warning(const Watch *watch)
{
    return watch->warning;
}
