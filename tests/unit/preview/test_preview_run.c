// Runs in helper processes give the same photons, samples and pictures as without them.
#include "unit/preview/preview_helpers.h"

TEST(the_photons_of_a_pass)
{
    RunRequest request = photons_request(NULL);
    request.photons = 20000;
    PhotonPass pass = pass_like(&request);
    for (int workers = 1; workers <= 3; workers++) {
        broker_workers(broker, workers);
        Run *run = start(&request);
        RunStatus status = finish(run);
        assert_string_equal(status.failure, "");
        assert_string_equal(status.notice, "");
        assert_int_equal(status.state, RUN_DONE);
        Recording recording = run_take_recording(run);
        check_photons(&recording, &pass, "photons");
        assert_int_equal(recording.emitted, request.photons);
        assert_int_equal(recording.segments, pass.segments);
        for (int c = 0; c < 3; c++) {
            assert_within(recording.ledger.emitted[c], pass.ledger.emitted[c], 1e-9, "emitted");
            assert_within(recording.ledger.absorbed[c], pass.ledger.absorbed[c], 1e-9, "absorbed");
            assert_within(recording.ledger.escaped[c], pass.ledger.escaped[c], 1e-9, "escaped");
            assert_within(recording.ledger.chance[c], pass.ledger.chance[c], 1e-9, "chance");
            assert_within(recording.ledger.chance_error[c], pass.ledger.chance_error[c], 1e-9, "error of chance");
        }
        run_free(run);
        recording_free(&recording);
    }
    broker_workers(broker, 2);
}

// Legs follow on each other, and a photon has flown as far as the legs to it are long.
TEST(legs_and_flight)
{
    RunRequest request = photons_request(NULL);
    request.photons = request.recorded = 3000;
    Run *run = start(&request);
    assert_int_equal(finish(run).state, RUN_DONE);
    Recording recording = run_take_recording(run);
    size_t photon = 0, ends[3] = {0}, followed = 0;
    for (size_t i = 0; i < recording.leg_count; i++) {
        const PathLeg *leg = &recording.legs[i];
        float length = vec3_length(vec3_sub(leg->to, leg->from)), flown = leg->flown + length;
        ends[leg->end]++;
        assert_true(leg->path < 3000 && (i == 0 || leg->path >= leg[-1].path));
        assert_true((leg->bounce == 0) == (leg->flown == 0.0f));
        if (i > 0 && leg->path == leg[-1].path && leg->bounce == leg[-1].bounce + 1) {
            assert_memory_equal(&leg->from, &leg[-1].to, sizeof leg->to);
            assert_within(leg->flown, leg[-1].flown + vec3_length(vec3_sub(leg[-1].to, leg[-1].from)), 1e-4, "flown");
            followed++;
        }
        if (leg->end != LEG_SURFACE || photon == recording.count)
            continue;
        const RecordedPhoton *stored = &recording.photons[photon]; // in the same order; mirrors and glass store none
        if (memcmp(&stored->at.position, &leg->to, sizeof leg->to) == 0) {
            assert_within(stored->flown, flown, 1e-4, "a photon's flight");
            photon++;
        }
        assert_true((double)flown <= recording.farthest * 1.00001);
    }
    assert_int_equal(photon, recording.count);
    assert_true(ends[LEG_SURFACE] > 3000 && ends[LEG_ESCAPED] > 100 && followed > 3000);
    run_free(run);
    recording_free(&recording);
}

TEST(lobe_is_the_step)
{
    RunRequest request = {.kind = RUN_LOBE, .seed = 3, .samples = 5000, .exponent = 20.0f, .angle = 60.0f};
    Run *run = start(&request);
    RunStatus status = finish(run);
    assert_string_equal(status.failure, "");
    Findings samples = run_take_findings(run);
    const LobeSample *items = samples.items;
    assert_int_equal(samples.count, 5000);
    long absorbed = 0;
    Mean along = {0};
    for (size_t i = 0; i < samples.count; i++) {
        Rng rng = rng_create(3, i);
        Vec3 out = {0};
        float weight = 0.0f, angle = 60.0f * PI / 180.0f;
        Vec3 in = vec3(sinf(angle), 0.0f, -cosf(angle));
        bool up = steps.scatter_glossy(in, vec3(0.0f, 0.0f, 1.0f), 20.0f, &rng, &out, &weight);
        assert_true(items[i].weight == (up ? weight : 0.0f));
        if (up)
            assert_memory_equal(&out, &items[i].direction, sizeof out);
        absorbed += !up;
        if (up)
            mean_add(&along, items[i].direction.x);
    }
    assert_true(absorbed > 10 && mean_value(&along) > 0.5); // the mirror direction is on the side of +x
    run_free(run);
    findings_free(&samples);
}

TEST(passes_of_a_render)
{
    RunRequest request = {
        .kind = RUN_RENDER, .seed = 5, .photons = 3000, .width = 24, .height = 20, .camera = scene->camera};
    Run *run = start(&request);
    const Image *image = NULL;
    int passes = 0;
    for (double until = clock_seconds() + 20.0; passes < 3 && clock_seconds() < until;) {
        RunStatus status = run_poll(run);
        assert_int_equal(status.state, RUN_GOING);
        image = run_image(run, &passes);
        if (passes < 3)
            run_wait(run, 0.05);
    }
    assert_true(passes >= 3 && image->width == 24 && image->height == 20);
    RenderOptions options = {.settings = scene->settings, .glass_sides = 2, .reuse = REUSE_DEFAULT, .threads = 2};
    options.settings.width = 24;
    options.settings.height = 20;
    options.settings.samples = 1;
    options.settings.photons = 3000;
    double mean = 0.0, seen = (double)image_at(image, 12, 10)->g;
    for (int pass = 0; pass < passes; pass++) {
        options.seed = pass == 0 ? 5 : hash_u64(5 + (uint64_t)pass);
        Image one = picture_of(scene, &options);
        mean += (double)image_at(&one, 12, 10)->g / passes;
    }
    assert_within(seen, mean, 1e-5 * fabs(mean), "mean of the passes");
    run_free(run);
}

TEST(what_has_come_is_a_first_part)
{
    RunRequest request = {.kind = RUN_PHOTONS, .seed = 7, .photons = 100000, .recorded = 10};
    Recording early, whole;
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
    whole = run_take_recording(run);
    assert_true(early.count > 0 && early.count < whole.count / 2);
    assert_int_equal(early.states[2], STEP_REFERENCE);
    assert_true(early.emitted > 0 && early.emitted < 100000);
    assert_memory_equal(early.photons, whole.photons, early.count * sizeof *early.photons);
    recording_free(&early);
    recording_free(&whole);
    run_free(run);
    broker_workers(broker, 2);
}

AROUND_RUNS(NULL, 0)
