// A test program: TEST(name) { … } is a test of it, and no list has to name it. Each program includes this once, as main is here.
// What a test makes by way of `at_end` is freed when it ends, passed or not.
#pragma once

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

#include "base/error.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static struct CMUnitTest all_tests[64];
static size_t test_count;
static CMFixtureFunction before_all, after_all;

static void test_add(struct CMUnitTest test)
{
    assert_true(test_count < sizeof all_tests / sizeof *all_tests);
    all_tests[test_count++] = test;
}

// ---- errors

// For calls to say in what went wrong; the first that is said stays. Empty again after assert_said, and at a test's end.
static Error said;

static inline void assert_said(const char *words)
{
    if (!strstr(said.message, words))
        fail_msg("\"%s\" does not say \"%s\"", said.message, words);
    said = (Error){""};
}

// The call, which takes &said, gives false or NULL, and says these words.
#define assert_refused(call, words) (assert_string_equal(said.message, ""), assert_true(!(call)), assert_said(words))

// It gives something else; if not, what it says is the failure.
#define assert_works(call)                                                                                             \
    do {                                                                                                               \
        if (!(call))                                                                                                   \
            fail_msg("%s", said.message);                                                                              \
    } while (0)

// ---- what is freed at the end

typedef struct Owned {
    struct Owned *older;
    void (*release)(void *thing);
    void *thing;
} Owned;

static Owned *newest;

static inline void at_end(void (*release)(void *thing), void *thing)
{
    Owned *owned = malloc(sizeof *owned);
    assert_non_null(owned);
    *owned = (Owned){newest, release, thing};
    newest = owned;
}

// What runs before or after tests; 0: all went well.
#define FIXTURE(name) static inline int name(__attribute__((unused)) void **state)

// The newest first.
FIXTURE(free_all)
{
    while (newest) {
        Owned owned = *newest;
        free(newest);
        newest = owned.older;
        owned.release(owned.thing);
    }
    said = (Error){""};
    return 0;
}

// Defines `name(thing)`: `release(thing)` is for the test's end. Gives the thing.
#define FREED_AT_END(name, type, release)                                                                              \
    static inline void name##_now(void *thing)                                                                         \
    {                                                                                                                  \
        release((type *)thing);                                                                                        \
    }                                                                                                                  \
    static inline type *name(type *thing)                                                                              \
    {                                                                                                                  \
        at_end(name##_now, thing);                                                                                     \
        return thing;                                                                                                  \
    }

// Zeroed memory that is there until then.
static inline void *memory(size_t count, size_t size)
{
    void *all = calloc(count, size);
    assert_non_null(all);
    at_end(free, all);
    return all;
}

// A copy that is there until then: of a value that a function gave, to be released by its address.
static inline void *kept(const void *value, size_t size)
{
    return memcpy(memory(1, size), value, size);
}

// As printf words it, up to 4095 bytes.
static inline char *words(const char *format, ...) PRINTF_LIKE(1, 2);
static inline char *words(const char *format, ...)
{
    char *text = memory(1, 4096);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, 4096, format, arguments);
    va_end(arguments);
    return text;
}

static inline void write_text(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    assert_int_equal(fclose(file), 0);
}

// ---- tests

// A test with what runs before and after it, and the state that they get.
#define TEST_WITH(test, before, after, start)                                                                          \
    static void test(void **state);                                                                                    \
    __attribute__((constructor)) static void test##_is_a_test(void)                                                    \
    {                                                                                                                  \
        test_add((struct CMUnitTest){#test, test, before, after, start});                                              \
    }                                                                                                                  \
    static void test(__attribute__((unused)) void **state)

#define TEST(test) TEST_WITH(test, NULL, free_all, NULL)

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
