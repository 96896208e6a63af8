// Results of a finished run, joined from its parts.
#include "preview/run/run_internal.h"
#include "base/parallel.h"
#include "photons/pass/oddities.h"

#include <stdlib.h>
#include <string.h>

static void sum_up(const Run *run, Recording *recording)
{
    for (int i = 0; i < run->part_count; i++)
        recording_add_books(recording, &run->parts[i].result);
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

// Part after part: that is the order of the paths. Takes the parts' memory, the first one's for all, or copies it.
static bool join(Run *run, WireKind kind, bool take, Buffer *whole)
{
    for (int i = 0; i < run->part_count; i++) {
        Buffer *part = &run->parts[i].found[kind], none = {NULL, 0, 0};
        if (take && i == 0) {
            *whole = *part;
        } else {
            if (!buffer_add(whole, part->bytes, part->size))
                return false;
            if (!take)
                continue;
            free(part->bytes);
        }
        *part = none;
    }
    return true;
}

// False: memory is short; what there was memory for is in it.
static bool fill_in(Run *run, bool take, double seconds, Recording *recording)
{
    Buffer photons = {NULL, 0, 0}, legs = {NULL, 0, 0};
    bool ok = join(run, WIRE_PHOTONS, take, &photons) && join(run, WIRE_LEGS, take, &legs);
    recording->photons = (RecordedPhoton *)(void *)photons.bytes;
    recording->count = photons.size / sizeof *recording->photons;
    recording->legs = (PathLeg *)(void *)legs.bytes;
    recording->leg_count = legs.size / sizeof *recording->legs;
    recording->recorded = run->request.recorded < run->request.photons ? run->request.recorded : run->request.photons;
    recording->seconds = seconds;
    recording_measure(recording);
    return ok;
}

Recording run_take_recording(Run *run)
{
    Recording recording = {.photons = NULL};
    if (run->status.state != RUN_DONE || run->request.kind != RUN_PHOTONS)
        return recording;
    sum_up(run, &recording);
    fill_in(run, true, run->seconds, &recording);
    return recording;
}

bool run_copy_partial(Run *run, Recording *recording)
{
    const Part *first = &run->parts[0];
    *recording = (Recording){.photons = NULL};
    if (run->status.state != RUN_GOING || run->failing || run->request.kind != RUN_PHOTONS ||
        first->found[WIRE_PHOTONS].size == 0) // the first part's books are in by then
        return false;
    if (!fill_in(run, false, clock_seconds() - run->started, recording)) {
        recording_free(recording);
        return false;
    }
    recording->play = first->result.play;
    memcpy(recording->states, first->result.states, sizeof recording->states);
    recording->emitted = (long)fmax(1.0, run->status.fraction * (double)run->request.photons);
    return true;
}

Image run_take_image(Run *run)
{
    Image image = run->rendered.image;
    run->rendered = (Rendered){.passes = 0};
    return image;
}

Findings run_take_findings(Run *run)
{
    static const size_t SIZES[RUN_RENDER] = {[RUN_LOBE] = sizeof(LobeSample),
                                             [RUN_ESTIMATES] = sizeof(IrradianceEstimate),
                                             [RUN_DISKS] = sizeof(ShrinkingDisk)};
    Buffer *buffer = &run->parts[0].found[WIRE_FINDINGS];
    RunKind kind = run->request.kind;
    if (run->status.state != RUN_DONE || kind == RUN_PHOTONS || kind == RUN_RENDER)
        return (Findings){NULL, 0};
    Findings findings = {buffer->bytes, buffer->size / SIZES[kind]};
    *buffer = (Buffer){NULL, 0, 0};
    return findings;
}
