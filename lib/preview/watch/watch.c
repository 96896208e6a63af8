#define _GNU_SOURCE // st_mtim
#include "preview/watch/watch_internal.h"
#include "base/parallel.h"
#include "math/rng.h"

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

#if defined(__APPLE__)
#define CHANGED_AT(info) (info).st_mtimespec
#else
#define CHANGED_AT(info) (info).st_mtim
#endif

void watch_path(char path[4096], const char *folder, size_t i, const char *ending)
{
    snprintf(path, 4096, "%s/%s%s", folder, step_table[i].file, ending);
}

uint64_t watch_fingerprint(uint64_t sum, const char *path)
{
    struct stat info;
    if (stat(path, &info) != 0)
        return sum;
    sum = hash_u64(sum ^ (uint64_t)CHANGED_AT(info).tv_sec);
    sum = hash_u64(sum ^ (uint64_t)CHANGED_AT(info).tv_nsec);
    return hash_u64(sum ^ (uint64_t)info.st_size ^ (uint64_t)info.st_ino << 20);
}

bool watch_look_at(Watch *watch, size_t i)
{
    char path[4096];
    Source *file = &watch->files[i], before = *file;
    watch_path(path, watch->source, i, ".c");
    file->fingerprint = watch_fingerprint(0, path);
    file->headers = file->fingerprint ? watch_headers(watch, i) : 0;
    return file->fingerprint != before.fingerprint || file->headers != before.headers;
}

void watch_mark(Watch *watch, size_t i)
{
    watch_look_at(watch, i);
    watch->files[i].dirty = true;
    watch->files[i].since = clock_seconds();
}

// What the last build could not make, a day ago perhaps: it is tried again, and its error told.
static bool is_behind(const Watch *watch, size_t i)
{
    char source[4096], object[4096];
    struct stat from, made;
    watch_path(source, watch->source, i, ".c");
    watch_path(object, watch->objects, i, ".so");
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
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (watch_look_at(watch, i))
            watch_mark(watch, i);
}

Watch *watch_start(const char *source, const char *objects, const char *command, Error *error)
{
    struct stat info;
    if (stat(source, &info) != 0 || !S_ISDIR(info.st_mode)) {
        error_set(error, "%s: no such folder to watch", source);
        return NULL;
    }
    Watch *watch = calloc(1, sizeof *watch);
    if (!watch || strlen(source) >= sizeof watch->source || strlen(objects) >= sizeof watch->objects) {
        error_set(error, "%s: cannot be watched: no memory, or too long a name", source);
        free(watch);
        return NULL;
    }
    watch->command = command;
    strcpy(watch->source, source);
    strcpy(watch->objects, objects);
    watch->inotify = watch->compiler.process.output = -1;
    watch_start_listening(watch);
    for (size_t i = 0; i < STEP_COUNT; i++) {
        watch_look_at(watch, i);
        if (is_behind(watch, i))
            watch_mark(watch, i);
    }
    return watch;
}

void watch_stop(Watch *watch)
{
    if (!watch)
        return;
    process_kill(&watch->compiler.process);
    if (watch->inotify >= 0)
        close(watch->inotify);
    free(watch);
}

// Seconds until this file may be built; a deleted one may come back at once under the same name.
static double time_left(const Source *file)
{
    return file->since + (file->fingerprint ? QUIET : QUIET_DELETE) - clock_seconds();
}

// The one that waits longest.
static WatchEvent begin_next(Watch *watch)
{
    size_t next = STEP_COUNT;
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (watch->files[i].dirty && time_left(&watch->files[i]) <= 0.0 &&
            (next == STEP_COUNT || watch->files[i].since < watch->files[next].since))
            next = i;
    return next < STEP_COUNT ? watch_begin_build(watch, next) : WATCH_NOTHING;
}

WatchEvent watch_poll(Watch *watch)
{
    watch_take_changes(watch);
    look_at_times(watch);
    if (watch->compiler.process.pid > 0 && watch->files[watch->building].dirty)
        process_kill(&watch->compiler.process); // what it would make is out of date
    if (watch->compiler.process.pid > 0)
        return watch_end_build(watch);
    if (!watch->stray[0])
        return begin_next(watch);
    snprintf(watch->message, sizeof watch->message,
             "%s: no step has this name, so nothing plays it; `build/photonlab steps` lists them", watch->stray);
    watch->stray[0] = '\0';
    return WATCH_FAILED;
}

void watch_wait(Watch *watch, double seconds)
{
    double left = watch->looked + (watch->inotify >= 0 ? LOOK_BESIDE : LOOK_ALONE) - clock_seconds();
    seconds = left < seconds ? left : seconds;
    for (size_t i = 0; i < STEP_COUNT && watch->compiler.process.pid <= 0; i++)
        if (watch->files[i].dirty && time_left(&watch->files[i]) < seconds)
            seconds = time_left(&watch->files[i]);
    if (watch->compiler.process.pid > 0 && watch->compiler.process.output < 0)
        seconds = seconds < 0.005 ? seconds : 0.005; // it has nothing more to say, and is about to end
    struct pollfd watched[2] = {{watch->inotify, POLLIN, 0},
                                {watch->compiler.process.pid > 0 ? watch->compiler.process.output : -1, POLLIN, 0}};
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
