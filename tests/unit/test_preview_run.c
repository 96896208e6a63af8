// Students' code in helper processes: the same photons as a photon pass, and every way in which a step can fail.
#define _GNU_SOURCE
#include "test_common.h"
#include "preview/broker.h"

#include <dirent.h>
#include <signal.h>
#include <stdio.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

static Scene *scene;
static Broker *broker;
static char folder[] = "/tmp/photonlab_preview_XXXXXX";

// ---- steps with a fault each, line 2 of their file

#define DIFFUSE "1_diffuse_photon_map/1.3_scatter_diffuse"
#define LOOP    "1_diffuse_photon_map/1.5_trace_photon"
#define IN_DIFFUSE(body)                                                                                               \
    "#include \"photonlab.h\"\nVec3 scatter_diffuse(Vec3 n, Rng *rng) { (void)rng; " body " return n; }\n"
#define IN_LOOP(body)                                                                                                      \
    "#include \"photonlab.h\"\nvoid trace_photon(PhotonTrace *t, Photon p, Rng *rng) { (void)t, (void)p, (void)rng; " body \
    " }\n"

static const struct {
    const char *name, *file, *code;
} faults[] = {
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
    {"flood", LOOP, IN_LOOP("Hit hit; while (photon_fly(t, &p, &hit)) for (;;) photon_store(t, &p, &hit);")},
    {"good", DIFFUSE, "#include \"../../solution_1.3.c\"\n"},
};
#define FAULTS (sizeof faults / sizeof *faults)

static void write_text(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    assert_int_equal(fclose(file), 0);
}

static void build_faults(void)
{
    char path[1024], command[8192];
    int length = snprintf(
        command, sizeof command,
        "cp solutions/" DIFFUSE ".c %s/solution_1.3.c; here=$(pwd); cd %s || exit 1; "
        "build() { ${CC:-cc} -O1 -g -fPIC -shared -D_DEFAULT_SOURCE -w -I\"$here/lib\" \"$1.c\" -o \"$1.so\"; }; ",
        folder, folder);
    for (size_t i = 0; i < FAULTS; i++) {
        snprintf(path, sizeof path, "%s/%s", folder, faults[i].name);
        assert_int_equal(mkdir(path, 0700), 0);
        snprintf(path, sizeof path, "%s/%s/1_diffuse_photon_map", folder, faults[i].name);
        assert_int_equal(mkdir(path, 0700), 0);
        snprintf(path, sizeof path, "%s/%s/%s.c", folder, faults[i].name, faults[i].file);
        write_text(path, faults[i].code);
        length += snprintf(command + length, sizeof command - (size_t)length, "build %s/%s & ", faults[i].name,
                           faults[i].file);
    }
    snprintf(command + length, sizeof command - (size_t)length, "wait");
    assert_int_equal(system(command), 0);
}

// ---- runs

static RunRequest scatter_request(const char *name, char *code, size_t size)
{
    if (name)
        snprintf(code, size, "%s/%s", folder, name);
    return (RunRequest){.kind = RUN_SCATTER, .code = name ? code : NULL, .seed = 7, .photons = 4000, .recorded = 50};
}

static RunStatus finish(Run *run)
{
    RunStatus status = run_poll(run);
    for (double until = clock_seconds() + 20.0; status.state == RUN_GOING && clock_seconds() < until;) {
        run_wait(run, 0.05);
        status = run_poll(run);
    }
    return status;
}

static Run *start(const RunRequest *request)
{
    Error error = {""};
    Run *run = run_start(broker, request, &error);
    if (!run)
        fail_msg("%s", error.message);
    return run;
}

static PhotonPass pass_of(const RunRequest *request)
{
    PhotonPassOptions options = {.photons = request->photons,
                                 .depth = scene->settings.depth,
                                 .seed = request->seed,
                                 .keep = KEEP_ALL,
                                 .threads = 2};
    PhotonPass pass;
    assert_true(photon_pass_run(scene, &options, &pass, NULL));
    return pass;
}

static void check_photons(const Scatter *scatter, const PhotonPass *pass, const char *what)
{
    if (scatter->count != pass->rest.count)
        fail_msg("%s: %zu photons, expected %zu", what, scatter->count, pass->rest.count);
    for (size_t i = 0; i < scatter->count; i++)
        if (memcmp(&scatter->photons[i].at, &pass->rest.photons[i], sizeof(StoredPhoton)) != 0)
            fail_msg("%s: photon %zu differs", what, i);
}

static void good_run(const char *what)
{
    char code[1024];
    RunRequest request = scatter_request("good", code, sizeof code);
    PhotonPass pass = pass_of(&request);
    Run *run = start(&request);
    RunStatus status = finish(run);
    if (status.state != RUN_DONE)
        fail_msg("%s: %s", what, status.failure);
    Scatter scatter = run_take_scatter(run);
    check_photons(&scatter, &pass, what);
    assert_int_equal(scatter.states[2], STEP_STUDENT);
    run_free(run);
    scatter_free(&scatter);
    photon_pass_free(&pass);
}

static void the_photons_of_a_pass(void **state)
{
    (void)state;
    char code[1024];
    RunRequest request = scatter_request(NULL, code, sizeof code);
    request.photons = 20000;
    PhotonPass pass = pass_of(&request);
    for (int workers = 1; workers <= 3; workers++) {
        broker_workers(broker, workers);
        Run *run = start(&request);
        RunStatus status = finish(run);
        assert_string_equal(status.failure, "");
        assert_string_equal(status.notice, "");
        assert_int_equal(status.state, RUN_DONE);
        Scatter scatter = run_take_scatter(run);
        check_photons(&scatter, &pass, "scatter");
        assert_int_equal(scatter.emitted, request.photons);
        assert_int_equal(scatter.segments, pass.segments);
        for (int c = 0; c < 3; c++) {
            assert_within(scatter.ledger.emitted[c], pass.ledger.emitted[c], 1e-9, "emitted");
            assert_within(scatter.ledger.absorbed[c], pass.ledger.absorbed[c], 1e-9, "absorbed");
            assert_within(scatter.ledger.escaped[c], pass.ledger.escaped[c], 1e-9, "escaped");
            assert_within(scatter.ledger.chance[c], pass.ledger.chance[c], 1e-9, "chance");
            assert_within(scatter.ledger.chance_error[c], pass.ledger.chance_error[c], 1e-9, "error of chance");
        }
        run_free(run);
        scatter_free(&scatter);
    }
    broker_workers(broker, 2);
    photon_pass_free(&pass);
}

// Legs follow on each other, and a photon has flown as far as the legs to it are long.
static void legs_and_flight(void **state)
{
    (void)state;
    char code[1024];
    RunRequest request = scatter_request(NULL, code, sizeof code);
    request.photons = request.recorded = 3000;
    Run *run = start(&request);
    assert_int_equal(finish(run).state, RUN_DONE);
    Scatter scatter = run_take_scatter(run);
    size_t photon = 0, ends[3] = {0}, followed = 0;
    for (size_t i = 0; i < scatter.leg_count; i++) {
        const ScatterLeg *leg = &scatter.legs[i];
        float length = vec3_length(vec3_sub(leg->to, leg->from)), flown = leg->flown + length;
        ends[leg->end]++;
        assert_true(leg->path < 3000 && (i == 0 || leg->path >= leg[-1].path));
        assert_true((leg->bounce == 0) == (leg->flown == 0.0f));
        if (i > 0 && leg->path == leg[-1].path && leg->bounce == leg[-1].bounce + 1) {
            assert_memory_equal(&leg->from, &leg[-1].to, sizeof leg->to);
            assert_within(leg->flown, leg[-1].flown + vec3_length(vec3_sub(leg[-1].to, leg[-1].from)), 1e-4, "flown");
            followed++;
        }
        if (leg->end != LEG_SURFACE || photon == scatter.count)
            continue;
        const ScatterPhoton *stored = &scatter.photons[photon]; // in the same order; mirrors and glass store none
        if (memcmp(&stored->at.position, &leg->to, sizeof leg->to) == 0) {
            assert_within(stored->flown, flown, 1e-4, "a photon's flight");
            photon++;
        }
        assert_true((double)flown <= scatter_farthest(&scatter) * 1.00001);
    }
    assert_int_equal(photon, scatter.count);
    assert_true(ends[LEG_SURFACE] > 3000 && ends[LEG_ESCAPED] > 100 && followed > 3000);
    run_free(run);
    scatter_free(&scatter);
}

static void lobe_is_the_step(void **state)
{
    (void)state;
    RunRequest request = {.kind = RUN_LOBE, .seed = 3, .samples = 5000, .exponent = 20.0f, .angle = 60.0f};
    Run *run = start(&request);
    RunStatus status = finish(run);
    assert_string_equal(status.failure, "");
    LobeSamples samples = run_take_lobe(run);
    assert_int_equal(samples.count, 5000);
    long absorbed = 0;
    Mean along;
    memset(&along, 0, sizeof along);
    for (size_t i = 0; i < samples.count; i++) {
        Rng rng = rng_create(3, i);
        Vec3 out = {0};
        float weight = 0.0f, angle = 60.0f * PI / 180.0f;
        Vec3 in = vec3(sinf(angle), 0.0f, -cosf(angle));
        bool up = steps.scatter_glossy(in, vec3(0.0f, 0.0f, 1.0f), 20.0f, &rng, &out, &weight);
        assert_true(samples.weights[i] == (up ? weight : 0.0f));
        if (up)
            assert_memory_equal(&out, &samples.directions[i], sizeof out);
        absorbed += !up;
        if (up)
            mean_add(&along, samples.directions[i].x);
    }
    assert_true(absorbed > 10 && mean_value(&along) > 0.5); // the mirror direction is on the side of +x
    run_free(run);
    lobe_samples_free(&samples);
}

static void passes_of_a_render(void **state)
{
    (void)state;
    RunRequest request = {
        .kind = RUN_RENDER, .seed = 5, .photons = 3000, .width = 24, .height = 20, .camera = scene->camera};
    Run *run = start(&request);
    const Image *image = NULL;
    int passes = 0;
    Image first = {0, 0, NULL};
    for (double until = clock_seconds() + 20.0; passes < 3 && clock_seconds() < until;) {
        RunStatus status = run_poll(run);
        assert_int_equal(status.state, RUN_GOING);
        image = run_image(run, &passes);
        if (passes == 0)
            run_wait(run, 0.05);
    }
    assert_true(passes >= 3 && image->width == 24 && image->height == 20);
    RenderOptions options = {.settings = scene->settings, .glass_sides = 2, .reuse = REUSE_DEFAULT, .threads = 2};
    options.settings.width = 24;
    options.settings.height = 20;
    options.settings.samples = 1;
    options.settings.photons = 3000;
    RenderStats stats;
    double mean[3] = {0}, seen = 0.0;
    for (int pass = 0; pass < passes; pass++) {
        options.seed = pass == 0 ? 5 : hash_u64(5 + (uint64_t)pass);
        assert_true(render_image(scene, &options, &first, &stats, NULL));
        mean[0] += (double)image_at(&first, 12, 10)->g / passes;
        image_free(&first);
    }
    seen = (double)image_at(image, 12, 10)->g;
    assert_within(seen, mean[0], 1e-5 * fabs(mean[0]), "mean of the passes");
    run_free(run);
}

// ---- faults

static bool has_addr2line(void)
{
    return system("command -v addr2line >/dev/null") == 0;
}

// The run fails with this sentence; `@` in it stands for the place's line and its colon, where that can be known.
static void fails(const char *name, const char *expected)
{
    char code[1024], whole[512];
    const char *at = strchr(expected, '@');
    if (at)
        snprintf(whole, sizeof whole, "%.*s%s%s", (int)(at - expected), expected, has_addr2line() ? ":" : "",
                 has_addr2line() ? at + 1 : strchr(at, ':'));
    RunRequest request = scatter_request(name, code, sizeof code);
    Run *run = start(&request);
    run_patience(run, 0.15);
    RunStatus status = finish(run);
    if (status.state != RUN_FAILED || strcmp(status.failure, at ? whole : expected) != 0)
        fail_msg("%s: state %d, `%s`, expected `%s`", name, status.state, status.failure, at ? whole : expected);
    assert_int_equal(run_take_scatter(run).count, 0);
    run_free(run);
    good_run(name);
}

#define HERE "1.3_scatter_diffuse.c"

static void crashes_are_named(void **state)
{
    (void)state;
    fails("null", HERE "@2: scatter_diffuse: segmentation fault: an address that is not yours (a null pointer, or an "
                       "index far beyond an array?)");
    fails("divide", HERE "@2: scatter_diffuse: an integer was divided by 0");
    fails("abort",
          HERE "@3: scatter_diffuse: abort() was called (an assertion, or memory freed twice? The terminal may tell)");
    fails("recursion", HERE "@2: scatter_diffuse: the stack overflowed: it calls itself without end");
}

static void ends_are_named(void **state)
{
    (void)state;
    fails("exit", HERE "@3: scatter_diffuse: called exit, which ends the whole program");
    fails("exit_at_once", "a step ended the program (exit code 3) before the run was done");
    fails("killed", "the run was ended from outside (signal 9): by hand, or by the system for want of memory?");
}

static void memory_is_limited(void **state)
{
    (void)state;
#if defined(__SANITIZE_ADDRESS__)
    skip(); // under it there is no limit
#endif
    fails("memory", HERE "@3: scatter_diffuse: asked for more than 1 GB of memory");
    fails("memory_filled", HERE "@5: scatter_diffuse: asked for ever more memory: 0.3 GB when it was stopped");
}

static void what_has_come_is_a_first_part(void **state)
{
    (void)state;
    RunRequest request = {.kind = RUN_SCATTER, .seed = 7, .photons = 400000, .recorded = 10};
    Scatter early, whole;
    broker_workers(broker, 1);
    Run *run = start(&request);
    bool some = false;
    while (!some && run_poll(run).state == RUN_GOING) {
        run_wait(run, 0.05);
        some = run_copy_partial(run, &early);
    }
    assert_true(some);
    assert_int_equal(finish(run).state, RUN_DONE);
    assert_false(run_copy_partial(run, &whole));
    whole = run_take_scatter(run);
    assert_true(early.count > 0 && early.count < whole.count / 2);
    assert_int_equal(early.states[2], STEP_REFERENCE);
    assert_true(early.emitted > 0 && early.emitted < 400000);
    assert_memory_equal(early.photons, whole.photons, early.count * sizeof *early.photons);
    scatter_free(&early);
    scatter_free(&whole);
    run_free(run);
    broker_workers(broker, 2);
}

static void missing_names_are_named(void **state)
{
    (void)state;
    fails("undefined", HERE ":4: scatter_diffuse: calls `helper_of_mine`, and there is no such function");
    fails("no_function", HERE ": there is no function `scatter_diffuse` in it; see the prototype in lib/steps/");
    fails("misspelt", "1.3_scatter_difuse.c: no step has this name; solutions/1_diffuse_photon_map/ shows what they "
                      "are called");
}

static void endless_loops_are_ended(void **state)
{
    (void)state;
#define ENDLESS "@2: trace_photon: ran for 0.15 s without finishing a photon; an endless loop?"
    fails("endless", "1.5_trace_photon.c" ENDLESS);
    fails("flood", "1.5_trace_photon.c" ENDLESS);
    fails("asleep", "1.5_trace_photon.c@3: trace_photon: ran for 0.15 s without finishing a photon; an endless loop?");
}

// ---- nothing is left behind

static int count_files(void)
{
    int count = 0;
    DIR *directory = opendir("/proc/self/fd");
    while (directory && readdir(directory))
        count++;
    if (directory)
        closedir(directory);
    return count;
}

// Processes that the helper has, dead ones included; −1 where the system does not tell.
static int count_workers(void)
{
    char path[128], text[4096] = "";
    snprintf(path, sizeof path, "/proc/%ld/task/%ld/children", (long)broker->pid, (long)broker->pid);
    FILE *file = fopen(path, "r");
    if (!file)
        return -1;
    int count = 0;
    if (fgets(text, sizeof text, file))
        for (char *word = strtok(text, " "); word; word = strtok(NULL, " "))
            count++;
    fclose(file);
    return count;
}

static void nothing_is_left_of_200_runs(void **state)
{
    (void)state;
    char code[1024];
    int before = count_files();
    for (int i = 0; i < 200; i++) {
        RunRequest request = scatter_request(i % 5 ? "endless" : NULL, code, sizeof code);
        Run *run = start(&request);
        if (i % 2)
            run_wait(run, 0.001);
        run_poll(run);
        run_free(run);
    }
    assert_int_equal(count_files(), before);
    for (double until = clock_seconds() + 5.0; count_workers() > 0 && clock_seconds() < until;)
        usleep(1000);
    assert_true(count_workers() <= 0);
    assert_int_equal(waitpid(-1, NULL, WNOHANG), 0); // the helper lives, nobody else is there
    good_run("after 200 runs");
}

// Dead, if not yet buried: whose task that is differs.
static bool is_zombie(long pid)
{
    char path[64], text[512] = "";
    snprintf(path, sizeof path, "/proc/%ld/stat", pid);
    FILE *file = fopen(path, "r");
    bool zombie = file && fgets(text, sizeof text, file) && strstr(text, ") Z");
    if (file)
        fclose(file);
    return zombie;
}

static bool is_gone(long pid)
{
    for (double until = clock_seconds() + 5.0; clock_seconds() < until; usleep(1000))
        if (kill((pid_t)pid, 0) != 0 || is_zombie(pid))
            return true;
    return false;
}

// A window that is killed takes helper and workers with it.
static void the_helper_ends_with_the_window(void **state)
{
    (void)state;
    int told[2];
    assert_int_equal(pipe(told), 0);
    pid_t window = fork();
    if (window == 0) {
        char code[1024];
        Broker *own = broker_start(scene, NULL, NULL);
        RunRequest request = scatter_request("endless", code, sizeof code);
        Run *run = own ? run_start(own, &request, NULL) : NULL;
        long pids[2] = {own ? (long)own->pid : 0, 0};
        while (run && !(pids[1] = own->hearts[0].pid))
            usleep(1000);
        if (write(told[1], pids, sizeof pids) == (ssize_t)sizeof pids)
            pause();
        _exit(1);
    }
    long pids[2] = {0, 0};
    assert_int_equal(read(told[0], pids, sizeof pids), sizeof pids);
    assert_true(pids[0] > 0 && pids[1] > 0);
    kill(window, SIGKILL);
    waitpid(window, NULL, 0);
    assert_true(is_gone(pids[1]));
    close(told[0]);
    close(told[1]);
}

static void a_lost_helper_is_told(void **state)
{
    (void)state;
    char code[1024];
    Error error = {""};
    Broker *own = broker_start(scene, NULL, &error);
    assert_non_null(own);
    RunRequest request = scatter_request("endless", code, sizeof code);
    Run *run = run_start(own, &request, &error);
    kill(own->pid, SIGKILL);
    RunStatus status = finish(run);
    assert_int_equal(status.state, RUN_FAILED);
    assert_string_equal(status.failure, "the preview's helper process is gone; start the preview again");
    assert_null(run_start(own, &request, &error));
    assert_string_equal(error.message, "the preview's helper process is gone; start it again");
    broker_stop(own);
}

static int set_up(void **state)
{
    Error error = {""};
    setenv("ASAN_OPTIONS", "detect_leaks=0", 0);
    char source[1024];
    scene = scene_load("scenes/box_dispersion.yaml", &error);
    bool made = mkdtemp(folder) != NULL;
    snprintf(source, sizeof source, "%s/undefined", folder);
    broker = scene && made ? broker_start(scene, source, &error) : NULL;
    if (!broker) {
        print_error("%s\n", error.message);
        return -1;
    }
    broker_workers(broker, 2);
    build_faults();
    return load_reference_steps(state); // after the helper was forked
}

static int tear_down(void **state)
{
    (void)state;
    char command[1024];
    broker_stop(broker);
    scene_free(scene);
    snprintf(command, sizeof command, "rm -rf %s", folder);
    return system(command);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_photons_of_a_pass),
        cmocka_unit_test(legs_and_flight),
        cmocka_unit_test(lobe_is_the_step),
        cmocka_unit_test(passes_of_a_render),
        cmocka_unit_test(crashes_are_named),
        cmocka_unit_test(ends_are_named),
        cmocka_unit_test(memory_is_limited),
        cmocka_unit_test(what_has_come_is_a_first_part),
        cmocka_unit_test(missing_names_are_named),
        cmocka_unit_test(endless_loops_are_ended),
        cmocka_unit_test(nothing_is_left_of_200_runs),
        cmocka_unit_test(the_helper_ends_with_the_window),
        cmocka_unit_test(a_lost_helper_is_told),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
