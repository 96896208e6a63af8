// Saving a file of an exercise: what is built, when, and what is said of it. Once with inotify and once without.
#define _GNU_SOURCE
#include "test_common.h"
#include "preview/watch.h"

#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#define STEP "1_diffuse_photon_map/1.3_scatter_diffuse"
#define NEXT "1_diffuse_photon_map/1.4_russian_roulette"

static char folder[64];
static Watch *watch;

static void path_to(char *path, size_t size, const char *part, const char *file)
{
    snprintf(path, size, "%s/%s/%s", folder, part, file);
}

static void write_file(const char *part, const char *file, const char *text)
{
    char path[512];
    path_to(path, sizeof path, part, file);
    FILE *stream = fopen(path, "w");
    assert_non_null(stream);
    fputs(text, stream);
    fclose(stream);
}

static void save(const char *file, const char *text)
{
    write_file("code of a student", file, text);
}

// The next event but WATCH_BUILDING; WATCH_NOTHING when none comes in time.
static WatchEvent next_event(double seconds)
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
static void assert_object(const char *file, const char *expected)
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

static int set_up(void **state)
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

// A build that failed yesterday.
static int set_up_behind(void **state)
{
    char path[512];
    Error error = {""};
    if (set_up(state) != 0)
        return -1;
    watch_stop(watch);
    save(STEP ".c", "wrong"); // newer than its object
    save(NEXT ".c", "new");   // which has none
    char source[512], objects[512];
    path_to(source, sizeof source, "code of a student", ".");
    path_to(objects, sizeof objects, "objects", ".");
    path_to(path, sizeof path, "objects", NEXT ".so");
    watch = watch_start(source, objects, command, &error);
    return watch && access(path, F_OK) != 0 ? 0 : -1;
}

static int tear_down(void **state)
{
    (void)state;
    char line[256];
    watch_stop(watch);
    snprintf(line, sizeof line, "rm -rf %s", folder);
    return system(line);
}

static void a_save_is_built(void **state)
{
    (void)state;
    assert_int_equal(next_event(0.2), WATCH_NOTHING); // what was there before is not new
    save(STEP ".c", "first");
    assert_int_equal(next_event(5.0), WATCH_BUILT);
    assert_object(STEP ".so", "first");
    double seconds;
    assert_int_equal(sscanf(watch_message(watch), "1.3_scatter_diffuse.c: built in %lf s", &seconds), 1);
    assert_true(seconds >= 0.05 && seconds < 5.0);
    save(STEP ".c", "english");
    assert_int_equal(next_event(5.0), WATCH_BUILT);
    assert_object(STEP ".so", "C\n");
}

static void a_rename_over_is_a_save(void **state)
{
    (void)state;
    char from[512], to[512];
    save("1_diffuse_photon_map/1.3_scatter_diffuse.c~", "not a step's name");
    save("1_diffuse_photon_map/.1.3_scatter_diffuse.c.swp", "neither");
    save("1_diffuse_photon_map/4913", "nor this");
    assert_int_equal(next_event(0.25), WATCH_NOTHING);
    path_to(from, sizeof from, "code of a student", "1_diffuse_photon_map/4913");
    path_to(to, sizeof to, "code of a student", STEP ".c");
    assert_int_equal(rename(from, to), 0);
    assert_int_equal(next_event(5.0), WATCH_BUILT);
    assert_object(STEP ".so", "nor this");
}

static void errors_are_told(void **state)
{
    (void)state;
    save(STEP ".c", "good");
    assert_int_equal(next_event(5.0), WATCH_BUILT);
    save(STEP ".c", "wrong");
    assert_int_equal(next_event(5.0), WATCH_FAILED);
    assert_string_equal(watch_message(watch), "1.3_scatter_diffuse.c:12:5: error: expected ';'");
    assert_object(STEP ".so", "good");
    save(STEP ".c", "linker");
    assert_int_equal(next_event(5.0), WATCH_FAILED);
    assert_string_equal(watch_message(watch), "1.3_scatter_diffuse.c: ld: cannot find -lmissing");
    save(STEP ".c", "strange"); // the warning is the cause
    assert_int_equal(next_event(5.0), WATCH_FAILED);
    assert_string_equal(watch_message(watch),
                        "1.3_scatter_diffuse.c:3:9: warning: implicit declaration of function 'f'");
    save(STEP ".c", "silent");
    assert_int_equal(next_event(5.0), WATCH_FAILED);
    assert_string_equal(watch_message(watch), "1.3_scatter_diffuse.c: the compiler failed and said nothing");
    save(STEP ".c", "better");
    assert_int_equal(next_event(5.0), WATCH_BUILT);
    assert_object(STEP ".so", "better");
}

static void saves_queue_and_restart(void **state)
{
    (void)state;
    save(STEP ".c", "slow");
    double until = clock_seconds() + 5.0;
    while (watch_poll(watch) != WATCH_BUILDING && clock_seconds() < until)
        watch_wait(watch, 0.05);
    save(STEP ".c", "quick"); // while the other is being built
    save(NEXT ".c", "next");
    double start = clock_seconds();
    assert_int_equal(next_event(5.0), WATCH_BUILT);
    assert_int_equal(next_event(5.0), WATCH_BUILT);
    assert_true(clock_seconds() - start < 4.0);
    // The first build may have read the second save before the times told of it; then it is built once more.
    assert_true(next_event(0.3) == WATCH_NOTHING || next_event(0.3) == WATCH_NOTHING);
    assert_object(STEP ".so", "quick");
    assert_object(NEXT ".so", "next");
}

static void warnings_are_told(void **state)
{
    (void)state;
    save(STEP ".c", "warned");
    assert_int_equal(next_event(5.0), WATCH_BUILT);
    assert_string_equal(watch_warning(watch), "1.3_scatter_diffuse.c:7:1: warning: no return statement");
    save(STEP ".c", "fine");
    assert_int_equal(next_event(5.0), WATCH_BUILT);
    assert_string_equal(watch_warning(watch), "");
}

static void a_file_like_no_step_is_told(void **state)
{
    (void)state;
    save("1_diffuse_photon_map/.1.3_scatter_diffuse.c", "an editor's");
    save("1_diffuse_photon_map/1.3_scatter_diffuse.c~", "an editor's");
    assert_int_equal(next_event(0.3), WATCH_NOTHING);
    save("1_diffuse_photon_map/1.3_copy.c", "lost");
    assert_int_equal(next_event(5.0), WATCH_FAILED);
    assert_ptr_equal(strstr(watch_message(watch), "1.3_copy.c: no step has this name"), watch_message(watch));
    save(STEP ".c", "found");
    assert_int_equal(next_event(5.0), WATCH_BUILT);
}

// As a compiler writes it: the watched folder has blanks in its name.
static void a_header_is_saved_for_its_steps(void **state)
{
    (void)state;
    char path[512];
    save("1_diffuse_photon_map/mine.h", "one");
    assert_int_equal(next_event(0.3), WATCH_NOTHING); // nobody reads it
    save(STEP ".c", "good");
    assert_int_equal(next_event(5.0), WATCH_BUILT);
    path_to(path, sizeof path, "objects", STEP ".d");
    FILE *stream = fopen(path, "w");
    assert_non_null(stream);
    fprintf(stream, "x.so: \\\n %s/code\\ of\\ a\\ student/" STEP ".c lib/other.h \\\n", folder);
    fprintf(stream, " %s/code\\ of\\ a\\ student/1_diffuse_photon_map/mine.h\n\nlib/other.h:\n", folder);
    fclose(stream);
    save(STEP ".c", "better"); // reads it from now on
    assert_int_equal(next_event(5.0), WATCH_BUILT);
    assert_int_equal(next_event(1.3), WATCH_NOTHING);
    save("1_diffuse_photon_map/mine.h", "two times");
    assert_int_equal(next_event(5.0), WATCH_BUILT);
}

static void what_is_behind_is_built_at_the_start(void **state)
{
    (void)state;
    assert_string_equal(watch_broken(watch), "");
    assert_int_equal(next_event(5.0), WATCH_FAILED);
    assert_string_equal(watch_message(watch), "1.3_scatter_diffuse.c:12:5: error: expected ';'");
    assert_int_equal(next_event(5.0), WATCH_BUILT);
    assert_object(NEXT ".so", "new");
    assert_object(STEP ".so", "before");
    assert_string_equal(watch_step(watch)->id, "1.4");
    assert_string_equal(watch_broken(watch), "1.3_scatter_diffuse.c:12:5: error: expected ';'");
    save(STEP ".c", "mended");
    assert_int_equal(next_event(5.0), WATCH_BUILT);
    assert_string_equal(watch_broken(watch), "");
}

static void a_deleted_step_loses_its_object(void **state)
{
    (void)state;
    char path[512];
    save(STEP ".c", "there");
    assert_int_equal(next_event(5.0), WATCH_BUILT);
    path_to(path, sizeof path, "code of a student", STEP ".c");
    unlink(path);
    assert_int_equal(next_event(5.0), WATCH_BUILT);
    assert_string_equal(watch_message(watch), "1.3_scatter_diffuse.c: deleted; the reference plays in its place");
    assert_object(STEP ".so", NULL);
}

static void a_stage_that_comes_later_is_seen(void **state)
{
    (void)state;
    char path[512];
    path_to(path, sizeof path, "code of a student", "2_glossy_lobe");
    assert_int_equal(mkdir(path, 0700), 0);
    save("2_glossy_lobe/2.1_sample_lobe.c", "lobe");
    assert_int_equal(next_event(5.0), WATCH_BUILT);
    assert_object("2_glossy_lobe/2.1_sample_lobe.so", "lobe");
}

static void no_folder_is_an_error(void **state)
{
    (void)state;
    Error error = {""};
    assert_null(watch_start("/no/such/folder", folder, "true", &error));
    assert_string_equal(error.message, "/no/such/folder: no such folder to watch");
}

#define BOTH_WAYS(test)                                                                                                \
    cmocka_unit_test_prestate_setup_teardown(test, set_up, tear_down, (void *)"inotify"),                              \
        cmocka_unit_test_prestate_setup_teardown(test, set_up, tear_down, (void *)"times")

int main(void)
{
    const struct CMUnitTest tests[] = {
        BOTH_WAYS(a_save_is_built),
        BOTH_WAYS(a_rename_over_is_a_save),
        BOTH_WAYS(errors_are_told),
        BOTH_WAYS(saves_queue_and_restart),
        BOTH_WAYS(warnings_are_told),
        cmocka_unit_test_setup_teardown(a_file_like_no_step_is_told, set_up, tear_down), // by inotify alone
        BOTH_WAYS(a_header_is_saved_for_its_steps),
        cmocka_unit_test_setup_teardown(what_is_behind_is_built_at_the_start, set_up_behind, tear_down),
        BOTH_WAYS(a_deleted_step_loses_its_object),
        BOTH_WAYS(a_stage_that_comes_later_is_seen),
        cmocka_unit_test(no_folder_is_an_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
