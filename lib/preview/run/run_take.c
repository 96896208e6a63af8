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

static void sum_up(const Run *run, Recording *recording)
{
    for (int i = 0; i < run->part_count; i++) {
        const WireDone *part = &run->parts[i].result;
        if (part->emitted > 0)
            add_ledger(&recording->ledger, recording->emitted, &part->ledger, part->emitted);
        recording->emitted += part->emitted;
        recording->segments += part->segments;
        unsound_paths_add(&recording->unsound, &part->unsound);
        recording->redraw_caps += part->redraw_caps;
        recording->bounces = part->bounces > recording->bounces ? part->bounces : recording->bounces;
        recording->play = part->play;
        memcpy(recording->states, part->states, sizeof recording->states);
    }
}

void run_describe_oddities(Run *run)
{
    Recording sum = {.photons = NULL};
    char text[ODDITIES_SIZE];
    sum_up(run, &sum);
    if (run->request.kind != RUN_PHOTONS)
        sum.ledger = (Ledger){.emitted = {0.0}};
    Oddities found = {&sum.ledger, sum.emitted, &sum.unsound, sum.redraw_caps, sum.states};
    oddities_describe(&found, text, sizeof text);
    size_t length = strlen(text);
    if (length > 0)
        text[length - 1] = '\0'; // the last newline
    memcpy(run->status.notice, text, sizeof run->status.notice);
}

// Part after part: that is the order of the paths. The first part's memory takes the others'.
static Buffer join(Run *run, WireKind kind)
{
    Buffer whole = run->parts[0].found[kind];
    run->parts[0].found[kind] = (Buffer){NULL, 0, 0};
    for (int i = 1; i < run->part_count; i++) {
        Buffer *part = &run->parts[i].found[kind];
        if (!buffer_add(&whole, part->bytes, part->size))
            break;
        free(part->bytes);
        *part = (Buffer){NULL, 0, 0};
    }
    return whole;
}

static Buffer copy(const Run *run, WireKind kind, bool *ok)
{
    Buffer whole = {NULL, 0, 0};
    for (int i = 0; *ok && i < run->part_count; i++)
        *ok = buffer_add(&whole, run->parts[i].found[kind].bytes, run->parts[i].found[kind].size);
    return whole;
}

static void fill_in(const Run *run, Buffer photons, Buffer legs, double seconds, Recording *recording)
{
    recording->photons = (RecordedPhoton *)(void *)photons.bytes;
    recording->count = photons.size / sizeof *recording->photons;
    recording->legs = (PathLeg *)(void *)legs.bytes;
    recording->leg_count = legs.size / sizeof *recording->legs;
    recording->recorded = run->request.recorded < run->request.photons ? run->request.recorded : run->request.photons;
    recording->seconds = seconds;
    recording_measure(recording);
}

Recording run_take_recording(Run *run)
{
    Recording recording = {.photons = NULL};
    if (run->status.state != RUN_DONE || run->request.kind != RUN_PHOTONS)
        return recording;
    sum_up(run, &recording);
    Buffer photons = join(run, WIRE_PHOTONS);
    fill_in(run, photons, join(run, WIRE_LEGS), run->seconds, &recording);
    return recording;
}

bool run_copy_partial(const Run *run, Recording *recording)
{
    *recording = (Recording){.photons = NULL};
    if (run->status.state != RUN_GOING || run->failing || run->request.kind != RUN_PHOTONS)
        return false;
    bool ok = run->parts[0].found[WIRE_PHOTONS].size > 0; // the first part's books are in by then
    Buffer photons = copy(run, WIRE_PHOTONS, &ok);
    fill_in(run, photons, copy(run, WIRE_LEGS, &ok), clock_seconds() - run->started, recording);
    if (!ok) {
        recording_free(recording);
        return false;
    }
    recording->play = run->parts[0].result.play;
    memcpy(recording->states, run->parts[0].result.states, sizeof recording->states);
    recording->emitted = (long)(run->status.fraction * (double)run->request.photons);
    recording->emitted = recording->emitted > 0 ? recording->emitted : 1;
    return true;
}

LobeSamples run_take_lobe(Run *run)
{
    Buffer *buffer = &run->parts[0].found[WIRE_SAMPLES];
    LobeSamples samples = {NULL, 0};
    if (run->status.state != RUN_DONE || run->request.kind != RUN_LOBE)
        return samples;
    samples.items = (LobeSample *)(void *)buffer->bytes;
    samples.count = buffer->size / sizeof *samples.items;
    *buffer = (Buffer){NULL, 0, 0};
    return samples;
}
