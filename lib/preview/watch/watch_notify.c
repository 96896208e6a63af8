// Saves, as inotify tells of them.
#include "preview/watch/watch_internal.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#if defined(__linux__)
#include <sys/inotify.h>

#define CHANGES (IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE | IN_CREATE)

// Folders that are watched already give the same number again.
static void watch_folders(Watch *watch)
{
    for (size_t i = 0; i < STEP_COUNT; i++) {
        char path[4096];
        watch_path(path, watch->source, i, "");
        *strrchr(path, '/') = '\0';
        watch->folders[i] = inotify_add_watch(watch->inotify, path, CHANGES | IN_ONLYDIR);
    }
}

// "1.3_copy.c", but not what editors leave beside a file: ".1.3_x.c.swp", "#1.3_x.c#", "1.3_x.c~".
static bool looks_like_a_step(const char *name)
{
    const char *ending = strrchr(name, '.');
    return name[0] >= '0' && name[0] <= '9' && ending && strcmp(ending, ".c") == 0;
}

static void take_change(Watch *watch, const struct inotify_event *event)
{
    if (event->mask & (IN_ISDIR | IN_IGNORED | IN_Q_OVERFLOW)) { // a stage's folder came or went, or too much happened
        watch_folders(watch);
        watch->looked = 0.0;
        return;
    }
    if (event->len == 0)
        return;
    for (size_t i = 0; i < STEP_COUNT; i++) {
        char path[4096];
        struct stat info;
        watch_path(path, watch->source, i, ".c");
        if (event->wd != watch->folders[i] || strcmp(event->name, strrchr(path, '/') + 1) != 0)
            continue;
        if (!(event->mask & IN_CREATE) || (stat(path, &info) == 0 && info.st_size > 0))
            watch_mark(watch, i);
        return;
    }
    watch->looked = 0.0; // a header of a step's?
    if (event->mask & (IN_CLOSE_WRITE | IN_MOVED_TO) && looks_like_a_step(event->name))
        snprintf(watch->stray, sizeof watch->stray, "%s", event->name);
}

void watch_take_changes(Watch *watch)
{
    union {
        struct inotify_event event; // aligned as one must be
        char bytes[8192];
    } events;
    for (ssize_t size; watch->inotify >= 0 && (size = read(watch->inotify, events.bytes, sizeof events.bytes)) > 0;)
        for (ssize_t at = 0; at < size;) {
            const struct inotify_event *event = (const struct inotify_event *)(const void *)(events.bytes + at);
            take_change(watch, event);
            at += (ssize_t)(sizeof *event + event->len);
        }
}

void watch_start_listening(Watch *watch)
{
    const char *wish = getenv("PHOTONLAB_WATCH");
    if (wish && strcmp(wish, "times") == 0)
        return;
    int opened = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
    if (opened >= 0 && inotify_add_watch(opened, watch->source, CHANGES | IN_ONLYDIR) >= 0) {
        watch->inotify = opened;
        watch_folders(watch);
    } else if (opened >= 0) {
        close(opened);
    }
}
#else
void watch_take_changes(Watch *watch)
{
    (void)watch;
}

void watch_start_listening(Watch *watch)
{
    (void)watch;
}
#endif
