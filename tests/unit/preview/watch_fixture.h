// A student's folder that is watched, for the tests of saving and of building.
#ifndef PHOTONLAB_TEST_WATCH_FIXTURE_H
#define PHOTONLAB_TEST_WATCH_FIXTURE_H

#include "unit/test_common.h"
#include "preview/watch/watch.h"

#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#define STEP "1_diffuse_photon_map/1.3_scatter_diffuse"
#define NEXT "1_diffuse_photon_map/1.4_russian_roulette"

static char folder[64];
static Watch *watch;

static inline void path_to(char *path, size_t size, const char *part, const char *file)
{
    snprintf(path, size, "%s/%s/%s", folder, part, file);
}

static inline void write_file(const char *part, const char *file, const char *text)
{
    char path[512];
    path_to(path, sizeof path, part, file);
    FILE *stream = fopen(path, "w");
    assert_non_null(stream);
    fputs(text, stream);
    fclose(stream);
}

static inline void save(const char *file, const char *text)
{
    write_file("code of a student", file, text);
}

// The next event but WATCH_BUILDING; WATCH_NOTHING when none comes in time.
static inline WatchEvent next_event(double seconds)
{
    for (double until = clock_seconds() + seconds; clock_seconds() < until;) {
        WatchEvent event = watch_poll(watch);
        if (event == WATCH_BUILT || event == WATCH_FAILED)
            return event;
        watch_wait(watch, 0.05);
    }
    return WATCH_NOTHING;
}

// What the built object holds: the command copies the source, unless it says "wrong".
static inline void assert_object(const char *file, const char *expected)
{
    char path[512], text[64] = "";
    path_to(path, sizeof path, "objects", file);
    FILE *stream = fopen(path, "r");
    assert_true((stream != NULL) == (expected != NULL));
    if (!stream)
        return;
    size_t size = fread(text, 1, sizeof text - 1, stream);
    text[size] = '\0';
    fclose(stream);
    assert_string_equal(text, expected);
}

static const char command[] =
    "sleep 0.05; case $(cat \"$1\") in "
    "*wrong*) echo \"In file included from somewhere/deep.h:1:\" >&2; echo \"$1:12:5: error: expected ';'\" >&2; exit 1;; "
    "*warned*) echo \"$1:7:1: warning: no return statement\" >&2; cp \"$1\" \"$2.new\";; "
    "*strange*) echo \"$1:3:9: warning: implicit declaration of function 'f'\" >&2; echo \"$1:3:9: error: types\" >&2; "
    "exit 1;; "
    "*silent*) exit 1;; "
    "*linker*) echo \"/usr/bin/ld: cannot find -lmissing\" >&2; exit 1;; "
    "*slow*) sleep 5;; "
    "*english*) echo \"$LC_ALL\" >\"$2.new\";; "
    "*) cp \"$1\" \"$2.new\";; esac && mv \"$2.new\" \"$2\"";

static inline int set_up(void **state)
{
    char path[512];
    Error error = {""};
    strcpy(folder, "/tmp/photonlab_watch_XXXXXX");
    if (!mkdtemp(folder))
        return -1;
    path_to(path, sizeof path, "code of a student", "");
    mkdir(path, 0700);
    path_to(path, sizeof path, "code of a student", "1_diffuse_photon_map");
    mkdir(path, 0700);
    save(STEP ".c", "before");
    path_to(path, sizeof path, "objects", "");
    mkdir(path, 0700);
    path_to(path, sizeof path, "objects", "1_diffuse_photon_map");
    mkdir(path, 0700);
    write_file("objects", STEP ".so", "before");
    if (*state && strcmp(*state, "times") == 0)
        setenv("PHOTONLAB_WATCH", "times", 1);
    else
        unsetenv("PHOTONLAB_WATCH");
    char source[512], objects[512];
    path_to(source, sizeof source, "code of a student", "");
    source[strlen(source) - 1] = '\0';
    path_to(objects, sizeof objects, "objects", "");
    objects[strlen(objects) - 1] = '\0';
    watch = watch_start(source, objects, command, &error);
    return watch ? 0 : -1;
}

static inline int tear_down(void **state)
{
    (void)state;
    char line[256];
    watch_stop(watch);
    snprintf(line, sizeof line, "rm -rf %s", folder);
    return system(line);
}

// With inotify, and without.
#define TEST_BOTH_WAYS(test)                                                                                           \
    static void test(void **state);                                                                                    \
    __attribute__((constructor)) static void test##_by_times(void)                                                     \
    {                                                                                                                  \
        test_add((struct CMUnitTest){#test, test, set_up, tear_down, (void *)"times"});                                \
    }                                                                                                                  \
    TEST_WITH(test, set_up, tear_down, (void *)"inotify")

#endif
