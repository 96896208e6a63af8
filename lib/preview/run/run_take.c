// Messages of workers, taken as they come, and results, joined from a run's parts.
#include "preview/run/run_internal.h"
#include "base/array.h"
#include "base/parallel.h"
#include "photons/pass/oddities.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static bool buffer_add(Buffer *buffer, const void *bytes, size_t size)
{
    if (size == 0)
        return true;
    if (!array_reserve(&buffer->bytes, buffer->size + size, &buffer->capacity, 1))
        return false;
    memcpy(buffer->bytes + buffer->size, bytes, size);
    buffer->size += size;
    return true;
}

static void buffer_free(Buffer *buffer)
{
    free(buffer->bytes);
    *buffer = (Buffer){NULL, 0, 0};
}

void part_free(Part *part)
{
    buffer_free(&part->incoming);
    for (int kind = 0; kind < WIRE_FOUND; kind++)
        buffer_free(&part->found[kind]);
}

// Passes are taken in their order, so that the same seed gives the same picture. False: its turn has not come.
static bool take_picture(Run *run, const Part *part, const char *bytes, size_t size)
{
    WirePicture head;
    if (size < sizeof head)
        return true;
    memcpy(&head, bytes, sizeof head);
    const Colour *pixels = (const Colour *)(const void *)(bytes + sizeof head);
    if (!head.quick && !head.mean_of && run->rendered.passes % run->part_count != (int)(part - run->parts))
        return false;
    Image *image = &run->rendered.image;
    if (!image->pixels && !image_create(image, run->request.width, run->request.height, NULL)) {
        run->out_of_memory = true;
        return true;
    }
    size_t expected = sizeof head + (size_t)head.width * (size_t)head.height * sizeof *pixels;
    if (expected == size && head.width > 0 && head.height > 0)
        rendered_add(&run->rendered, head.width, head.height, pixels, head.quick, head.mean_of);
    run->status.news = true;
    return true;
}

// A worker tells more than once: at once, and when it has found the way to the student's code. Of several that were
// asked, the first word of one must not replace the last of another.
static void take_crash(Run *run, const char *bytes)
{
    WireCrash crash;
    memcpy(&crash, bytes, sizeof crash);
    if (!run->has_crash || crash.inner.object[0] || !run->crash.inner.object[0])
        run->crash = crash;
    run->has_crash = true;
}

// False: a picture whose turn has not come.
static bool take_message(Run *run, Part *part, const WireHead *head, const char *bytes)
{
    part->fraction = head->fraction >= 0.0 && head->fraction <= 1.0 ? head->fraction : part->fraction;
    part->pid = (pid_t)head->pid;
    switch ((WireKind)head->kind) {
    case WIRE_PHOTONS:
    case WIRE_LEGS:
    case WIRE_FINDINGS:
        run->out_of_memory = !buffer_add(&part->found[head->kind], bytes, head->bytes) || run->out_of_memory;
        break;
    case WIRE_ALIVE:
        break;
    case WIRE_PICTURE:
        return take_picture(run, part, bytes, head->bytes);
    case WIRE_BEGUN:
    case WIRE_DONE:
        if (head->bytes == sizeof part->result) {
            memcpy(&part->result, bytes, sizeof part->result);
            part->done = head->kind == WIRE_DONE;
        }
        break;
    case WIRE_FAILED:
        if (!run->words[0])
            snprintf(run->words, sizeof run->words, "%.*s", (int)head->bytes, bytes);
        break;
    case WIRE_CRASH:
        if (head->bytes == sizeof run->crash)
            take_crash(run, bytes);
        break;
    }
    return true;
}

// How many bytes of the message are known to come.
static size_t message_size(const Buffer *message)
{
    size_t size = sizeof(WireHead);
    return message->size < size ? size : size + ((const WireHead *)(const void *)message->bytes)->bytes;
}

// Takes the message if it is whole and its turn has come.
static void finish_message(Run *run, Part *part)
{
    Buffer *message = &part->incoming;
    if (message->size < message_size(message))
        return;
    const WireHead *head = (const WireHead *)(const void *)message->bytes;
    part->waiting = !take_message(run, part, head, message->bytes + sizeof *head);
    message->size = part->waiting ? message->size : 0;
}

bool part_read(Run *run, Part *part, double until)
{
    Buffer *message = &part->incoming;
    bool news = false;
    if (part->waiting)
        finish_message(run, part);
    while (part->pipe >= 0 && !part->waiting) {
        if (clock_seconds() > until)
            return true;
        size_t size = message_size(message);
        bool has_memory = size <= WIRE_MOST_BYTES && array_reserve(&message->bytes, size, &message->capacity, 1);
        ssize_t got = has_memory ? read(part->pipe, message->bytes + message->size, size - message->size) : 0;
        if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR))
            return news;
        news = true;
        if (got > 0) {
            message->size += (size_t)got;
            finish_message(run, part);
            continue;
        }
        run->out_of_memory = run->out_of_memory || !has_memory;
        close(part->pipe);
        part->pipe = -1;
    }
    return news;
}

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

// Part after part: that is the order of the paths. `take`: the parts' memory goes meanwhile.
static bool join(Run *run, WireKind kind, bool take, Buffer *whole)
{
    for (int i = 0; i < run->part_count; i++) {
        Buffer *part = &run->parts[i].found[kind];
        if (take && !whole->bytes) {
            *whole = *part;
            *part = (Buffer){NULL, 0, 0};
            continue;
        }
        if (!buffer_add(whole, part->bytes, part->size))
            return false;
        if (take)
            buffer_free(part);
    }
    return true;
}

// False: memory is short; what there was memory for is in it.
static bool fill_in(Run *run, bool take, Recording *recording)
{
    Buffer photons = {NULL, 0, 0}, legs = {NULL, 0, 0};
    bool ok = join(run, WIRE_PHOTONS, take, &photons) && join(run, WIRE_LEGS, take, &legs);
    recording->photons = (RecordedPhoton *)(void *)photons.bytes;
    recording->count = photons.size / sizeof *recording->photons;
    recording->legs = (PathLeg *)(void *)legs.bytes;
    recording->leg_count = legs.size / sizeof *recording->legs;
    recording->recorded = run->request.recorded < run->request.photons ? run->request.recorded : run->request.photons;
    recording->seconds = clock_seconds() - run->started;
    recording_measure(recording);
    return ok;
}

Recording run_take_recording(Run *run)
{
    Recording recording = {.photons = NULL};
    if (run->status.state != RUN_DONE || run->request.kind != RUN_PHOTONS)
        return recording;
    sum_up(run, &recording);
    fill_in(run, true, &recording);
    return recording;
}

bool run_copy_partial(Run *run, Recording *recording)
{
    const Part *first = &run->parts[0];
    *recording = (Recording){.photons = NULL};
    if (run->status.state != RUN_GOING || run->failing || run->request.kind != RUN_PHOTONS ||
        first->found[WIRE_PHOTONS].size == 0) // the first part's books are in by then
        return false;
    if (!fill_in(run, false, recording)) {
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
