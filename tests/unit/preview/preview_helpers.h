// Runs of students' code in the preview's helper processes: what their tests share. Steps are built in a folder of the
// test's own, each case in a folder of its name; "good" is there always.
#pragma once

#include "preview/run/run_internal.h"
#include "unit/test_common.h"

#include <sys/stat.h>
#include <unistd.h>

static Scene *scene;
static Broker *broker;
static char folder[] = "/tmp/photonlab_preview_XXXXXX";

#define DIFFUSE "1_diffuse_photon_map/1.3_scatter_diffuse"
#define LOOP    "1_diffuse_photon_map/1.5_trace_photon"
#define IN_DIFFUSE(body)                                                                                               \
    "#include \"photonlab.h\"\nVec3 scatter_diffuse(Vec3 n, Rng *rng) { (void)rng; " body " return n; }\n"
#define IN_LOOP(body)                                                                                                  \
    "#include \"photonlab.h\"\nvoid trace_photon(PhotonTrace *t, Photon p, Rng *rng) "                                 \
    "{ (void)t, (void)p, (void)rng; " body " }\n"

// A student's step: the folder's name, the step's file without ".c", and what it holds.
typedef struct {
    const char *name, *file, *code;
} Fault;

// Appends the command that builds it.
static inline int prepare_fault(const Fault *fault, char *command, size_t size)
{
    assert_int_equal(mkdir(words("%s/%s", folder, fault->name), 0700), 0);
    assert_int_equal(mkdir(words("%s/%s/1_diffuse_photon_map", folder, fault->name), 0700), 0);
    write_text(words("%s/%s/%s.c", folder, fault->name, fault->file), fault->code);
    return snprintf(command, size, "build %s/%s & ", fault->name, fault->file);
}

// Side by side; only lines and functions are wanted of what a debugger can know.
static inline void build_faults(const Fault *faults, size_t count)
{
    static const Fault good = {"good", DIFFUSE, "#include \"../../solution_1.3.c\"\n"};
    char command[8192];
    int length = snprintf(
        command, sizeof command,
        "cp solutions/" DIFFUSE ".c %s/solution_1.3.c; here=$(pwd); cd %s || exit 1; "
        "build() { ${CC:-cc} -O0 -g1 -fPIC -shared -D_DEFAULT_SOURCE -w -I\"$here/lib\" \"$1.c\" -o \"$1.so\" || "
        "echo \"$1\" >>failed; }; ",
        folder, folder);
    length += prepare_fault(&good, command + length, sizeof command - (size_t)length);
    for (size_t i = 0; i < count; i++)
        length += prepare_fault(&faults[i], command + length, sizeof command - (size_t)length);
    snprintf(command + length, sizeof command - (size_t)length, "wait; test ! -e failed");
    assert_int_equal(system(command), 0);
}

// ---- runs

// Of this step's folder, or of the reference alone.
static inline RunRequest photons_request(const char *name)
{
    const char *code = name ? words("%s/%s", folder, name) : NULL;
    return (RunRequest){.kind = RUN_PHOTONS, .code = code, .seed = 7, .photons = 4000, .recorded = 50};
}

static inline RunStatus finish(Run *run)
{
    RunStatus status = run_poll(run);
    for (double until = clock_seconds() + 20.0; status.state == RUN_GOING && clock_seconds() < until;) {
        run_wait(run, 0.05);
        status = run_poll(run);
    }
    return status;
}

static inline Run *start(const RunRequest *request)
{
    Run *run = run_start(broker, request, &said);
    assert_works(run);
    return run;
}

static inline PhotonPass pass_like(const RunRequest *request)
{
    return pass_of(scene, (PhotonPassOptions){.photons = request->photons, .seed = request->seed, .threads = 2});
}

static inline void check_photons(const Recording *recording, const PhotonPass *pass, const char *what)
{
    if (recording->count != pass->rest.count)
        fail_msg("%s: %zu photons, expected %zu", what, recording->count, pass->rest.count);
    for (size_t i = 0; i < recording->count; i++)
        if (memcmp(&recording->photons[i].at, &pass->rest.photons[i], sizeof(StoredPhoton)) != 0)
            fail_msg("%s: photon %zu differs", what, i);
}

static inline void good_run(const char *what)
{
    RunRequest request = photons_request("good");
    PhotonPass pass = pass_like(&request);
    Run *run = start(&request);
    RunStatus status = finish(run);
    if (status.state != RUN_DONE)
        fail_msg("%s: %s", what, status.failure);
    Recording recording = run_take_recording(run);
    check_photons(&recording, &pass, what);
    assert_int_equal(recording.states[2], STEP_STUDENT);
    run_free(run);
    recording_free(&recording);
}

// ---- for cmocka's group setup and teardown

static inline int preview_start(void **state, const Fault *faults, size_t count)
{
    setenv("ASAN_OPTIONS", "detect_leaks=0", 0);
    scene = scene_load("scenes/box_dispersion.yaml", &said);
    bool made = mkdtemp(folder) != NULL;
    broker = scene && made ? broker_start(scene, words("%s/undefined", folder), &said) : NULL;
    if (!broker) {
        print_error("%s\n", said.message);
        return -1;
    }
    broker_workers(broker, 2);
    build_faults(faults, count);
    return load_reference_steps(state); // after the helper was forked
}

FIXTURE(preview_end)
{
    broker_stop(broker);
    scene_free(scene);
    return system(words("rm -rf %s", folder)) || free_all(state);
}

#define AROUND_RUNS(faults, count)                                                                                     \
    FIXTURE(set_up)                                                                                                    \
    {                                                                                                                  \
        return preview_start(state, faults, count);                                                                    \
    }                                                                                                                  \
    AROUND_TESTS(set_up, preview_end)
