// A student's folder that is watched, for the tests of saving and of building.
#pragma once

#include "unit/test_common.h"
#include "preview/watch/watch.h"

#include <sys/stat.h>
#include <unistd.h>

#define STEP "1_diffuse_photon_map/1.3_scatter_diffuse"
#define NEXT "1_diffuse_photon_map/1.4_russian_roulette"

static char folder[64];
static Watch *watch;

#define SOURCES "code of a student"
#define OBJECTS "objects"

static inline const char *path_to(const char *part, const char *file)
{
    return words("%s/%s%s%s", folder, part, *file ? "/" : "", file);
}

static inline void save(const char *file, const char *text)
{
    write_text(path_to(SOURCES, file), text);
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
    char text[64] = "";
    FILE *stream = fopen(path_to(OBJECTS, file), "r");
    assert_true((stream != NULL) == (expected != NULL));
    if (!stream)
        return;
    size_t size = fread(text, 1, sizeof text - 1, stream);
    text[size] = '\0';
    fclose(stream);
    assert_string_equal(text, expected);
}

// What comes of a save.
static inline void assert_built(const char *file, const char *text)
{
    save(file, text);
    assert_int_equal(next_event(5.0), WATCH_BUILT);
}

static inline void assert_fails(const char *file, const char *text, const char *message)
{
    save(file, text);
    assert_int_equal(next_event(5.0), WATCH_FAILED);
    assert_string_equal(watch_message(watch), message);
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
    strcpy(folder, "/tmp/photonlab_watch_XXXXXX");
    if (!mkdtemp(folder))
        return -1;
    for (int i = 0; i < 4; i++)
        mkdir(path_to(i < 2 ? SOURCES : OBJECTS, i % 2 ? "1_diffuse_photon_map" : ""), 0700);
    save(STEP ".c", "before");
    write_text(path_to(OBJECTS, STEP ".so"), "before");
    if (*state && strcmp(*state, "times") == 0)
        setenv("PHOTONLAB_WATCH", "times", 1);
    else
        unsetenv("PHOTONLAB_WATCH");
    watch = watch_start(path_to(SOURCES, ""), path_to(OBJECTS, ""), command, &said);
    return watch ? 0 : -1;
}

FIXTURE(tear_down)
{
    watch_stop(watch);
    return system(words("rm -rf %s", folder)) || free_all(state);
}

// With inotify, and without.
#define TEST_BOTH_WAYS(test)                                                                                           \
    static void test(void **state);                                                                                    \
    __attribute__((constructor)) static void test##_by_times(void)                                                     \
    {                                                                                                                  \
        test_add((struct CMUnitTest){#test, test, set_up, tear_down, (void *)"times"});                                \
    }                                                                                                                  \
    TEST_WITH(test, set_up, tear_down, (void *)"inotify")
