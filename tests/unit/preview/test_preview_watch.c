// Saving a file of an exercise: what is seen, however it is saved.
#define _GNU_SOURCE
#include "unit/preview/watch_fixture.h"

TEST_BOTH_WAYS(a_save_is_built)
{
    assert_int_equal(next_event(0.2), WATCH_NOTHING); // what was there before is not new
    assert_built(STEP ".c", "first");
    assert_object(STEP ".so", "first");
    double seconds;
    assert_int_equal(sscanf(watch_message(watch), "1.3_scatter_diffuse.c: built in %lf s", &seconds), 1);
    assert_true(seconds >= 0.05 && seconds < 5.0);
    assert_built(STEP ".c", "english");
    assert_object(STEP ".so", "C\n");
}

TEST_BOTH_WAYS(a_rename_over_is_a_save)
{
    save("1_diffuse_photon_map/1.3_scatter_diffuse.c~", "not a step's name");
    save("1_diffuse_photon_map/.1.3_scatter_diffuse.c.swp", "neither");
    save("1_diffuse_photon_map/4913", "nor this");
    assert_int_equal(next_event(0.25), WATCH_NOTHING);
    assert_int_equal(rename(path_to(SOURCES, "1_diffuse_photon_map/4913"), path_to(SOURCES, STEP ".c")), 0);
    assert_int_equal(next_event(5.0), WATCH_BUILT);
    assert_object(STEP ".so", "nor this");
}

TEST_WITH(a_file_like_no_step_is_told, set_up, tear_down, NULL)
{
    save("1_diffuse_photon_map/.1.3_scatter_diffuse.c", "an editor's");
    save("1_diffuse_photon_map/1.3_scatter_diffuse.c~", "an editor's");
    assert_int_equal(next_event(0.3), WATCH_NOTHING);
    save("1_diffuse_photon_map/1.3_copy.c", "lost");
    assert_int_equal(next_event(5.0), WATCH_FAILED);
    assert_ptr_equal(strstr(watch_message(watch), "1.3_copy.c: no step has this name"), watch_message(watch));
    assert_built(STEP ".c", "found");
}

TEST_BOTH_WAYS(a_deleted_step_loses_its_object)
{
    assert_built(STEP ".c", "there");
    unlink(path_to(SOURCES, STEP ".c"));
    assert_int_equal(next_event(5.0), WATCH_BUILT);
    assert_string_equal(watch_message(watch), "1.3_scatter_diffuse.c: deleted; the reference plays in its place");
    assert_object(STEP ".so", NULL);
}

TEST_BOTH_WAYS(a_stage_that_comes_later_is_seen)
{
    assert_int_equal(mkdir(path_to(SOURCES, "2_glossy_lobe"), 0700), 0);
    assert_built("2_glossy_lobe/2.1_sample_lobe.c", "lobe");
    assert_object("2_glossy_lobe/2.1_sample_lobe.so", "lobe");
}

TEST(no_folder_is_an_error)
{
    assert_null(watch_start("/no/such/folder", folder, "true", &said));
    assert_string_equal(said.message, "/no/such/folder: no such folder to watch");
}
