// A test program: TEST(name) { … } is a test of it, and no list has to name it. Each program includes this once, as main is here.
#ifndef PHOTONLAB_TEST_H
#define PHOTONLAB_TEST_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

static struct CMUnitTest all_tests[64];
static size_t test_count;
static CMFixtureFunction before_all, after_all;

static void test_add(struct CMUnitTest test)
{
    assert_true(test_count < sizeof all_tests / sizeof *all_tests);
    all_tests[test_count++] = test;
}

// A test with what runs before and after it, and the state that they get.
#define TEST_WITH(test, before, after, start)                                                                          \
    static void test(void **state);                                                                                    \
    __attribute__((constructor)) static void test##_is_a_test(void)                                                    \
    {                                                                                                                  \
        test_add((struct CMUnitTest){#test, test, before, after, start});                                              \
    }                                                                                                                  \
    static void test(__attribute__((unused)) void **state)

#define TEST(test) TEST_WITH(test, NULL, NULL, NULL)

// What runs before the first test and after the last; NULL: nothing.
#define AROUND_TESTS(before, after)                                                                                    \
    __attribute__((constructor)) static void around_tests(void)                                                        \
    {                                                                                                                  \
        before_all = before;                                                                                           \
        after_all = after;                                                                                             \
    }

int main(void)
{
    return _cmocka_run_group_tests("tests", all_tests, test_count, before_all, after_all);
}

#endif
