// What is built of the files of an exercise, when, and what is said of it.
#define _GNU_SOURCE
#include "unit/preview/watch_fixture.h"

// A build that failed yesterday.
static int set_up_behind(void **state)
{
    if (set_up(state) != 0)
        return -1;
    watch_stop(watch);
    save(STEP ".c", "wrong"); // newer than its object
    save(NEXT ".c", "new");   // which has none
    watch = watch_start(path_to(SOURCES, "."), path_to(OBJECTS, "."), command, &said);
    return watch && access(path_to(OBJECTS, NEXT ".so"), F_OK) != 0 ? 0 : -1;
}

TEST_BOTH_WAYS(errors_are_told)
{
    assert_built(STEP ".c", "good");
    assert_fails(STEP ".c", "wrong", "1.3_scatter_diffuse.c:12:5: error: expected ';'");
    assert_object(STEP ".so", "good");
    assert_fails(STEP ".c", "linker", "1.3_scatter_diffuse.c: ld: cannot find -lmissing");
    assert_fails(
        STEP ".c", "strange",
        "1.3_scatter_diffuse.c:3:9: warning: implicit declaration of function 'f'"); // the warning is the cause
    assert_fails(STEP ".c", "silent", "1.3_scatter_diffuse.c: the compiler failed and said nothing");
    assert_built(STEP ".c", "better");
    assert_object(STEP ".so", "better");
}

TEST_BOTH_WAYS(saves_queue_and_restart)
{
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

TEST_BOTH_WAYS(warnings_are_told)
{
    assert_built(STEP ".c", "warned");
    assert_string_equal(watch_warning(watch), "1.3_scatter_diffuse.c:7:1: warning: no return statement");
    assert_built(STEP ".c", "fine");
    assert_string_equal(watch_warning(watch), "");
}

// As a compiler writes it: the watched folder has blanks in its name.
TEST_BOTH_WAYS(a_header_is_saved_for_its_steps)
{
    save("1_diffuse_photon_map/mine.h", "one");
    assert_int_equal(next_event(0.3), WATCH_NOTHING); // nobody reads it
    assert_built(STEP ".c", "good");
    FILE *stream = fopen(path_to(OBJECTS, STEP ".d"), "w");
    assert_non_null(stream);
    fprintf(stream, "x.so: \\\n %s/code\\ of\\ a\\ student/" STEP ".c lib/other.h \\\n", folder);
    fprintf(stream, " %s/code\\ of\\ a\\ student/1_diffuse_photon_map/mine.h\n\nlib/other.h:\n", folder);
    fclose(stream);
    assert_built(STEP ".c", "better"); // reads it from now on
    assert_int_equal(next_event(1.3), WATCH_NOTHING);
    assert_built("1_diffuse_photon_map/mine.h", "two times");
}

TEST_WITH(what_is_behind_is_built_at_the_start, set_up_behind, tear_down, NULL)
{
    assert_string_equal(watch_broken(watch), "");
    assert_int_equal(next_event(5.0), WATCH_FAILED);
    assert_string_equal(watch_message(watch), "1.3_scatter_diffuse.c:12:5: error: expected ';'");
    assert_int_equal(next_event(5.0), WATCH_BUILT);
    assert_object(NEXT ".so", "new");
    assert_object(STEP ".so", "before");
    assert_string_equal(watch_step(watch)->id, "1.4");
    assert_string_equal(watch_broken(watch), "1.3_scatter_diffuse.c:12:5: error: expected ';'");
    assert_built(STEP ".c", "mended");
    assert_string_equal(watch_broken(watch), "");
}
