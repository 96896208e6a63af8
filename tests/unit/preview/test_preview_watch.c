// Saving a file of an exercise: what is seen, however it is saved.
#define _GNU_SOURCE
#include "unit/preview/watch_fixture.h"

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

int main(void)
{
    const struct CMUnitTest tests[] = {
        BOTH_WAYS(a_save_is_built),
        BOTH_WAYS(a_rename_over_is_a_save),
        cmocka_unit_test_setup_teardown(a_file_like_no_step_is_told, set_up, tear_down), // by inotify alone
        BOTH_WAYS(a_deleted_step_loses_its_object),
        BOTH_WAYS(a_stage_that_comes_later_is_seen),
        cmocka_unit_test(no_folder_is_an_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
