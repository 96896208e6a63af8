// What the judge says of steps, and which step comes next.
#include "preview/record/verdicts.h"
#include "unit/test_common.h"

static Verdicts verdicts;

TEST(a_line_becomes_a_verdict)
{
    const StepInfo *step = verdicts_take_line(&verdicts, "1.3\tfail\texpected 1\tline 7\tsquare root missing\nmore");
    const Verdict *verdict = &verdicts.steps[STEP_scatter_diffuse];
    assert_ptr_equal(step, &step_table[STEP_scatter_diffuse]);
    assert_int_equal(verdict->state, VERDICT_FAIL);
    assert_string_equal(verdict->message, "expected 1");
    assert_string_equal(verdict->where, "line 7");
    assert_string_equal(verdict->looks_like, "square root missing");
    assert_non_null(verdicts_take_line(&verdicts, "1.3\tpass"));
    assert_int_equal(verdict->state, VERDICT_PASS);
    assert_string_equal(verdict->looks_like, "");
    const char *const others[] = {"", "1.3", "1.3\tfails", "9.9\tpass", "took 1 s", "\tpass"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        assert_null(verdicts_take_line(&verdicts, others[i]));
    assert_int_equal(verdict->state, VERDICT_PASS);
}

TEST(the_next_step_is_one_that_is_not_right)
{
    memset(&verdicts, 0, sizeof verdicts);
    verdicts.count = step_count_of(0);
    assert_int_equal(verdicts.count, STEP_COUNT);
    verdicts.steps[1].state = VERDICT_PASS;
    assert_int_equal(verdicts_next(&verdicts), 2);
    for (size_t i = 0; i < STEP_COUNT; i++)
        verdicts.steps[i].state = VERDICT_PASS;
    assert_true(verdicts_all_right(&verdicts));
    verdicts.steps[3].state = VERDICT_ERROR;
    verdicts.present = 5;
    assert_false(verdicts_all_right(&verdicts));
    assert_int_equal(verdicts_next(&verdicts), 3);
    verdicts.present = 3;
    assert_int_equal(verdicts_next(&verdicts), 3);
}

TEST(a_course_of_three_stages_ends_with_its_last_step)
{
    memset(&verdicts, 0, sizeof verdicts);
    verdicts.count = step_count_of(3);
    assert_string_equal(step_table[verdicts.count - 1].id, "3.5");
    verdicts.present = verdicts.count - 1;
    assert_int_equal(verdicts_next(&verdicts), 0);
    for (size_t i = 0; i < verdicts.count; i++)
        verdicts.steps[i].state = VERDICT_PASS;
    assert_true(verdicts_all_right(&verdicts));
}
