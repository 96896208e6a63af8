// Results of a finished run, joined from its parts.
#include "preview/run/run_internal.h"
#include "base/parallel.h"
#include "photons/pass/oddities.h"

#include <stdlib.h>
#include <string.h>

// The error of a sum: each part's error gives back its sum of squares (see photon_pass.c).
static void add_ledger(Ledger *sum, long sum_paths, const Ledger *part, long paths)
{
    for (int c = 0; c < 3; c++) {
        double before = sum->chance[c], own = part->chance[c];
        double squares = part->chance_error[c] * part->chance_error[c] + own * own / (double)paths;
        if (sum_paths > 0)
            squares += sum->chance_error[c] * sum->chance_error[c] + before * before / (double)sum_paths;
        sum->emitted[c] += part->emitted[c];
        sum->absorbed[c] += part->absorbed[c];
        sum->escaped[c] += part->escaped[c];
        sum->cut[c] += part->cut[c];
        sum->chance[c] += own;
        double variance = squares - sum->chance[c] * sum->chance[c] / (double)(sum_paths + paths);
        sum->chance_error[c] = sqrt(fmax(0.0, variance));
    }
}

static void sum_up(const Run *run, Scatter *scatter)
{
    for (int i = 0; i < run->part_count; i++) {
        const WireDone *part = &run->parts[i].result;
        if (part->emitted > 0)
            add_ledger(&scatter->ledger, scatter->emitted, &part->ledger, part->emitted);
        scatter->emitted += part->emitted;
        scatter->segments += part->segments;
        unsound_paths_add(&scatter->unsound, &part->unsound);
        scatter->redraw_caps += part->redraw_caps;
        scatter->bounces = part->bounces > scatter->bounces ? part->bounces : scatter->bounces;
        scatter->play = part->play;
        memcpy(scatter->states, part->states, sizeof scatter->states);
    }
}

void run_describe_oddities(Run *run)
{
    Scatter sum = {.photons = NULL};
    char text[ODDITIES_SIZE];
    sum_up(run, &sum);
    if (run->request.kind != RUN_SCATTER)
        sum.ledger = (Ledger){.emitted = {0.0}};
    Oddities found = {&sum.ledger, sum.emitted, &sum.unsound, sum.redraw_caps, sum.states};
    oddities_describe(&found, text, sizeof text);
    size_t length = strlen(text);
    if (length > 0)
        text[length - 1] = '\0'; // the last newline
    memcpy(run->status.notice, text, sizeof run->status.notice);
}

// Part after part: that is the order of the paths. The first part's memory takes the others'.
static Heap join(Run *run, Heap *(*choose)(Part *))
{
    Heap whole = *choose(&run->parts[0]);
    *choose(&run->parts[0]) = (Heap){NULL, 0, 0};
    for (int i = 1; i < run->part_count; i++) {
        Heap *part = choose(&run->parts[i]);
        if (!heap_add(&whole, part->bytes, part->size))
            break;
        free(part->bytes);
        *part = (Heap){NULL, 0, 0};
    }
    return whole;
}

static Heap *photons_of(Part *part)
{
    return &part->photons;
}

static Heap *legs_of(Part *part)
{
    return &part->legs;
}

static double find_farthest(const Scatter *scatter)
{
    float farthest = 0.0f;
    for (size_t i = 0; i < scatter->count; i++)
        farthest = fmaxf(farthest, scatter->photons[i].flown);
    for (size_t i = 0; i < scatter->leg_count; i++) {
        const ScatterLeg *leg = &scatter->legs[i];
        farthest = fmaxf(farthest, leg->flown + vec3_length(vec3_sub(leg->to, leg->from)));
    }
    return (double)farthest;
}

double scatter_farthest(const Scatter *scatter)
{
    return scatter->farthest;
}

Scatter run_take_scatter(Run *run)
{
    Scatter scatter = {.photons = NULL};
    if (run->status.state != RUN_DONE || run->request.kind != RUN_SCATTER)
        return scatter;
    sum_up(run, &scatter);
    Heap photons = join(run, photons_of), legs = join(run, legs_of);
    scatter.photons = (ScatterPhoton *)(void *)photons.bytes;
    scatter.count = photons.size / sizeof *scatter.photons;
    scatter.legs = (ScatterLeg *)(void *)legs.bytes;
    scatter.leg_count = legs.size / sizeof *scatter.legs;
    scatter.recorded = run->request.recorded < run->request.photons ? run->request.recorded : run->request.photons;
    scatter.seconds = run->seconds;
    scatter.farthest = find_farthest(&scatter);
    return scatter;
}

static bool copy_parts(const Run *run, Scatter *scatter)
{
    Heap photons = {NULL, 0, 0}, legs = {NULL, 0, 0};
    bool ok = run->parts[0].photons.size > 0; // the first part's books are in by then
    for (int i = 0; ok && i < run->part_count; i++) {
        const Part *part = &run->parts[i];
        ok = heap_add(&photons, part->photons.bytes, part->photons.size) &&
             heap_add(&legs, part->legs.bytes, part->legs.size);
    }
    scatter->photons = (ScatterPhoton *)(void *)photons.bytes;
    scatter->count = photons.size / sizeof *scatter->photons;
    scatter->legs = (ScatterLeg *)(void *)legs.bytes;
    scatter->leg_count = legs.size / sizeof *scatter->legs;
    return ok && scatter->count > 0;
}

bool run_copy_partial(const Run *run, Scatter *scatter)
{
    *scatter = (Scatter){.photons = NULL};
    if (run->status.state != RUN_GOING || run->failing || run->request.kind != RUN_SCATTER)
        return false;
    if (!copy_parts(run, scatter)) {
        scatter_free(scatter);
        return false;
    }
    scatter->play = run->parts[0].result.play;
    memcpy(scatter->states, run->parts[0].result.states, sizeof scatter->states);
    scatter->recorded = run->request.recorded < run->request.photons ? run->request.recorded : run->request.photons;
    scatter->emitted = (long)(run->status.fraction * (double)run->request.photons);
    scatter->emitted = scatter->emitted > 0 ? scatter->emitted : 1;
    for (size_t i = 0; i < scatter->count; i++)
        scatter->bounces =
            scatter->photons[i].at.bounce + 1 > scatter->bounces ? scatter->photons[i].at.bounce + 1 : scatter->bounces;
    scatter->seconds = clock_seconds() - run->started;
    scatter->farthest = find_farthest(scatter);
    return true;
}

void scatter_free(Scatter *scatter)
{
    free(scatter->photons);
    free(scatter->legs);
    *scatter = (Scatter){.photons = NULL};
}

LobeSamples run_take_lobe(Run *run)
{
    LobeSamples samples = {NULL, NULL, 0};
    const Heap *heap = &run->parts[0].samples;
    if (run->status.state != RUN_DONE || run->request.kind != RUN_LOBE)
        return samples;
    size_t count = heap->size / sizeof(WireSample);
    samples.directions = malloc((count + 1) * sizeof *samples.directions);
    samples.weights = malloc((count + 1) * sizeof *samples.weights);
    if (!samples.directions || !samples.weights) {
        lobe_samples_free(&samples);
        return samples;
    }
    for (; samples.count < count; samples.count++) {
        WireSample sample;
        memcpy(&sample, heap->bytes + samples.count * sizeof sample, sizeof sample);
        samples.directions[samples.count] = sample.direction;
        samples.weights[samples.count] = sample.weight;
    }
    return samples;
}

void lobe_samples_free(LobeSamples *samples)
{
    free(samples->directions);
    free(samples->weights);
    *samples = (LobeSamples){NULL, NULL, 0};
}
