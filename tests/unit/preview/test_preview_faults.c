// Every way in which a student's step can fail: the run fails with its sentence, and the next one works.
#include "unit/preview/preview_helpers.h"
#include "base/crash_report.h"

// The fault stands in line 2 of its file, or behind the other headers.
static const Fault faults[] = {
    {"null", DIFFUSE, IN_DIFFUSE("*(volatile int *)0 = 1;")},
    {"divide", DIFFUSE,
     "#include \"photonlab.h\"\nVec3 scatter_diffuse(Vec3 n, Rng *rng) { volatile int zero = 0; "
     "n.x += (float)((int)(rng_u32(rng) >> 1) / zero); return n; }\n"},
    {"recursion", DIFFUSE, IN_DIFFUSE("volatile Vec3 here = n; n = scatter_diffuse(here, rng); n.x += here.y;")},
    {"abort", DIFFUSE, "#include <stdlib.h>\n" IN_DIFFUSE("abort();")},
    {"exit", DIFFUSE, "#include <stdlib.h>\n" IN_DIFFUSE("exit(0);")},
    {"exit_at_once", DIFFUSE, "#include <unistd.h>\n" IN_DIFFUSE("_exit(3);")},
    {"killed", DIFFUSE, "#include <signal.h>\n#include <unistd.h>\n" IN_DIFFUSE("kill(getpid(), SIGKILL);")},
    {"memory", DIFFUSE,
     "#include <stdlib.h>\n" IN_DIFFUSE("for (;;) { volatile char *more = malloc(64u << 20); more[1] = 1; }")},
    {"memory_filled", DIFFUSE,
     "#include <stdlib.h>\n#include <string.h>\n#include <unistd.h>\n" IN_DIFFUSE(
         "char *volatile more = malloc(300u << 20); memset(more, 1, 300u << 20); for (;;) pause();")},
    {"undefined", DIFFUSE,
     "#include \"photonlab.h\"\nVec3 helper_of_mine(Vec3);\n"
     "Vec3 scatter_diffuse(Vec3 n, Rng *rng) { (void)rng;\n return helper_of_mine(n); }\n"},
    {"no_function", DIFFUSE, "#include \"photonlab.h\"\nVec3 scatter_difuse(Vec3 n) { return n; }\n"},
    {"misspelt", "1_diffuse_photon_map/1.3_scatter_difuse", IN_DIFFUSE("")},
    {"endless", LOOP, IN_LOOP("for (volatile int i = 0;; i++) {}")},
    {"asleep", LOOP, "#include <unistd.h>\n" IN_LOOP("for (;;) pause();")},
    {"calls", LOOP, IN_LOOP("Material m = {.name = \"\"}; for (;;) material_is_rough(&m);")},
    {"flood", LOOP, IN_LOOP("Hit hit; while (photon_fly(t, &p, &hit)) for (;;) photon_store(t, &p, &hit);")},
};
#define FAULTS (sizeof faults / sizeof *faults)

static bool has_addr2line(void)
{
    return system("command -v addr2line >/dev/null") == 0;
}

// The run fails with this sentence; `@` in it stands for the place's line and its colon, where that can be known.
static void fails(const char *name, const char *expected)
{
    char whole[512];
    const char *at = strchr(expected, '@');
    if (at)
        snprintf(whole, sizeof whole, "%.*s%s%s", (int)(at - expected), expected, has_addr2line() ? ":" : "",
                 has_addr2line() ? at + 1 : strchr(at, ':'));
    RunRequest request = photons_request(name);
    Run *run = start(&request);
    run_patience(run, 0.15);
    RunStatus status = finish(run);
    if (status.state != RUN_FAILED || strcmp(status.failure, at ? whole : expected) != 0)
        fail_msg("%s: state %d, `%s`, expected `%s`", name, status.state, status.failure, at ? whole : expected);
    assert_int_equal(run_take_recording(run).count, 0);
    run_free(run);
    good_run(name);
}

#define HERE "1.3_scatter_diffuse.c"

TEST(crashes_are_named)
{
    fails("null", HERE "@2: scatter_diffuse: segmentation fault: an address that is not yours (a null pointer, or an "
                       "index far beyond an array?)");
    fails("divide", HERE "@2: scatter_diffuse: an integer was divided by 0");
    fails("abort",
          HERE "@3: scatter_diffuse: abort() was called (an assertion, or memory freed twice? The terminal may tell)");
    fails("recursion", HERE "@2: scatter_diffuse: the stack overflowed: it calls itself without end");
}

TEST(ends_are_named)
{
    fails("exit", HERE "@3: scatter_diffuse: called exit, which ends the whole program");
    fails("exit_at_once", "a step ended the program (exit code 3) before the run was done");
    fails("killed", "the run was ended from outside (signal 9): by hand, or by the system for want of memory?");
}

TEST(memory_is_limited)
{
#ifdef SANITIZED
    skip(); // under it there is no limit
#endif
    fails("memory", HERE "@3: scatter_diffuse: asked for more than 1 GB of memory");
    fails("memory_filled", HERE "@5: scatter_diffuse: asked for ever more memory: 0.3 GB when it was stopped");
}

TEST(missing_names_are_named)
{
    fails("undefined", HERE ":4: scatter_diffuse: calls `helper_of_mine`, and there is no such function");
    fails("no_function", HERE ": there is no function `scatter_diffuse` in it; see the prototype in lib/steps/");
    fails("misspelt", "1.3_scatter_difuse.c: no step has this name; solutions/1_diffuse_photon_map/ shows what they "
                      "are called");
}

TEST(endless_loops_are_ended)
{
#define ENDLESS "@2: trace_photon: ran for 0.15 s without finishing a photon; an endless loop?"
    fails("endless", "1.5_trace_photon.c" ENDLESS);
    fails("flood", "1.5_trace_photon.c" ENDLESS);
    for (int i = 0; i < 8; i++) // now in the step, now in the function that it calls, now in the stub on the way there
        fails("calls", "1.5_trace_photon.c" ENDLESS);
    fails("asleep", "1.5_trace_photon.c@3: trace_photon: ran for 0.15 s without finishing a photon; an endless loop?");
}

// Where a step calls the library, it may be met in the stub for that, which belongs to no line: the next place is the call's.
TEST(a_call_has_a_place_behind_its_stub)
{
    const CrashPlace stub = {"/steps/1.5_trace_photon.so", NULL, NULL, 0x20},
                     library = {"/lib/library.so", "photon_fly", NULL, 0x30},
                     call = {"/steps/1.5_trace_photon.so", "trace_photon", NULL, 0x140};
    InnerPlace inner = {"", "", NULL, 0, 7, false};
    assert_true(crash_take_inner(&inner, &stub, "/steps/"));
    assert_int_equal(inner.caller, 0);
    assert_true(!crash_take_inner(&inner, &library, "/steps/") && !crash_take_inner(&inner, &call, "/steps/"));
    assert_int_equal(inner.offset, 0x20);
    assert_int_equal(inner.caller, 0x140);
}

AROUND_RUNS(faults, FAULTS)
