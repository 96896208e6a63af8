// The table of steps, and what of a reference step the judge does not ask: the others are checked in tests/steps/, as students' are.
#include "unit/test_common.h"

// The sine of the angle to the axis keeps its digits close to it. For n = 1e6 it is about 1e-3 and cosα a
// number next to 1 in single precision; 1 − cos²α would take a handful of values only.
TEST(sample_lobe_of_a_huge_exponent)
{
    enum { BINS = 50, COUNT = 200 * BINS };
    long counts[BINS] = {0};
    Rng rng = rng_create(22, 0);
    for (int i = 0; i < COUNT; i++) {
        Vec3 d = steps.sample_lobe(1e6f, &rng);
        double sin2 = (double)d.x * d.x + (double)d.y * d.y;
        counts[(int)fmin(pow(1.0 - sin2, 0.5 * (1e6 + 1.0)) * BINS, BINS - 1)]++;
    }
    double chi2 = 0.0;
    for (int i = 0; i < BINS; i++)
        chi2 += (double)((counts[i] - 200) * (counts[i] - 200)) / 200.0;
    assert_true(chi2 < 85.4); // of 49 degrees of freedom: right code is above it once in 1000
}

// 1.10 comes after 1.9.
static int number_of(const StepInfo *step)
{
    return 1000 * step->stage + atoi(strchr(step->id, '.') + 1);
}

TEST(table_is_in_order)
{
    assert_int_equal(step_table[0].stage, 1);
    for (int i = 1; i < STEP_COUNT; i++) {
        assert_true(number_of(&step_table[i - 1]) < number_of(&step_table[i]));
        int further = step_table[i].stage - step_table[i - 1].stage;
        assert_true(further == 0 || further == 1);
    }
    assert_int_equal(step_table[STEP_COUNT - 1].stage, STAGE_COUNT);
    for (int i = 0; i < STEP_COUNT; i++)
        assert_ptr_equal(step_find(step_table[i].id), &step_table[i]);
}

TEST(an_id_is_no_part_of_another)
{
    assert_true(step_is_listed("1.10 2.1", "1.10") && step_is_listed("1.10,2.1", "2.1"));
    assert_false(step_is_listed("1.10 12.1", "1.1") || step_is_listed("1.10 12.1", "2.1") || step_is_listed("", "1.1"));
}

// What plays in the place of what, and what `--steps` makes of it.
TEST(pairs_of_steps)
{
    StepChoice choice;
    char text[40];
    assert_true(step_choice_parse("1.5", &choice, &said));
    step_choice_print(choice, text, sizeof text);
    assert_string_equal(text, "2.4,1.5");
    assert_true(step_is_played(step_find("1.5"), choice) && !step_is_played(step_find("3.5"), choice));
    assert_ptr_equal(step_chosen_by(step_find("3.5")), step_find("3.4"));
    assert_ptr_equal(step_chosen_by(step_find("2.1")), step_find("2.1"));
    assert_true(steps_are_paired(step_find("3.5"), step_find("1.5")));
    assert_false(steps_are_paired(step_find("3.5"), step_find("3.4")) ||
                 steps_are_paired(step_find("1.5"), step_find("2.4")));
    assert_false(step_choice_parse("3.4,1.5", &choice, &said));
    assert_string_equal(
        said.message,
        "--steps 3.4,1.5: no choice `1.5`; expected 2.4 or 2.3, and 3.4 or 1.5 or 6.4, parted by a comma");
    bool started[STEP_COUNT] = {false};
    started[STEP_trace_photon] = started[STEP_scatter_glossy_source_text] = started[STEP_scatter_glossy_phong] = true;
    step_choice_print(step_choice_for(started), text, sizeof text);
    assert_string_equal(text, "2.4,1.5");
}
