// Messages of workers, taken as they come.
#include "preview/run/run_internal.h"
#include "base/parallel.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static bool buffer_reserve(Buffer *buffer, size_t size)
{
    if (size <= buffer->capacity)
        return true;
    size_t capacity = buffer->capacity ? buffer->capacity : 4096;
    while (capacity < size)
        capacity *= 2;
    char *bytes = realloc(buffer->bytes, capacity);
    if (!bytes)
        return false;
    buffer->bytes = bytes;
    buffer->capacity = capacity;
    return true;
}

bool buffer_add(Buffer *buffer, const void *bytes, size_t size)
{
    if (size == 0)
        return true;
    if (!buffer_reserve(buffer, buffer->size + size))
        return false;
    memcpy(buffer->bytes + buffer->size, bytes, size);
    buffer->size += size;
    return true;
}

void part_free(Part *part)
{
    free(part->payload.bytes);
    part->payload = (Buffer){NULL, 0, 0};
    for (int kind = 0; kind < WIRE_FOUND; kind++) {
        free(part->found[kind].bytes);
        part->found[kind] = (Buffer){NULL, 0, 0};
    }
}

// The quick picture, blown up.
static void show_quick(Run *run, const WirePicture *head, const Colour *pixels)
{
    for (int y = 0; y < run->image.height; y++)
        for (int x = 0; x < run->image.width; x++) {
            int column = (int)((long)x * head->width / run->image.width);
            int row = (int)((long)y * head->height / run->image.height);
            *image_at(&run->image, x, y) = pixels[(size_t)row * (size_t)head->width + (size_t)column];
        }
}

static void add_pass(Run *run, const Colour *pixels)
{
    float share = 1.0f / (float)++run->passes;
    size_t count = (size_t)run->image.width * (size_t)run->image.height;
    for (size_t i = 0; i < count; i++) {
        Colour *mean = &run->image.pixels[i];
        *mean = colour_add(*mean, colour_scale(colour_sub(pixels[i], *mean), share));
    }
}

// Passes are taken in their order, so that the same seed gives the same picture.
bool run_take_picture(Run *run, Part *part)
{
    WirePicture head;
    memcpy(&head, part->payload.bytes, sizeof head);
    const Colour *pixels = (const Colour *)(const void *)(part->payload.bytes + sizeof head);
    if (!head.quick && run->passes % run->part_count != (int)(part - run->parts))
        return false;
    if (!run->image.pixels && !image_create(&run->image, run->request.width, run->request.height, NULL)) {
        run->out_of_memory = true;
        return true;
    }
    size_t expected = sizeof head + (size_t)head.width * (size_t)head.height * sizeof *pixels;
    bool whole = head.width == run->image.width && head.height == run->image.height;
    if (expected != part->payload.size || head.width < 1 || head.height < 1)
        return true;
    if (head.quick && run->passes == 0)
        show_quick(run, &head, pixels);
    else if (!head.quick && whole)
        add_pass(run, pixels);
    run->status.news = true;
    return true;
}

// A worker tells twice: at once, and when it has found the way to the student's code. Of several that were asked, the
// first word of one must not replace the last of another.
static void take_crash(Failure *failure, const char *bytes)
{
    WireCrash crash;
    memcpy(&crash, bytes, sizeof crash);
    if (!failure->has_crash || crash.object[0] || !failure->crash.object[0])
        failure->crash = crash;
    failure->has_crash = true;
}

static bool take_message(Run *run, Part *part)
{
    const Buffer *payload = &part->payload;
    switch ((WireKind)part->head.kind) {
    case WIRE_PHOTONS:
    case WIRE_LEGS:
    case WIRE_SAMPLES:
        return buffer_add(&part->found[part->head.kind], payload->bytes, payload->size);
    case WIRE_PICTURE:
        part->waiting = payload->size >= sizeof(WirePicture) && !run_take_picture(run, part);
        return true;
    case WIRE_BEGUN:
    case WIRE_DONE:
        if (payload->size == sizeof part->result) {
            memcpy(&part->result, payload->bytes, sizeof part->result);
            part->done = part->head.kind == WIRE_DONE;
        }
        return true;
    case WIRE_FAILED:
        if (!run->failure.words) {
            size_t size = payload->size < sizeof run->words ? payload->size : sizeof run->words - 1;
            memcpy(run->words, payload->bytes, size);
            run->failure.words = run->words;
        }
        return true;
    case WIRE_CRASH:
        if (payload->size == sizeof run->failure.crash)
            take_crash(&run->failure, payload->bytes);
        return true;
    }
    return true;
}

// Where the next bytes go, and how many are wanted; NULL when memory is short or the head makes no sense.
static char *next_place(Part *part, size_t *size)
{
    if (part->head_size < sizeof part->head) {
        *size = sizeof part->head - part->head_size;
        return (char *)&part->head + part->head_size;
    }
    if (part->head.bytes > WIRE_MOST_BYTES || !buffer_reserve(&part->payload, part->head.bytes))
        return NULL;
    *size = part->head.bytes - part->payload.size;
    return part->payload.bytes + part->payload.size;
}

static void note_bytes(Part *part, size_t size)
{
    if (part->head_size < sizeof part->head)
        part->head_size += size;
    else
        part->payload.size += size;
}

static bool is_whole(const Part *part)
{
    return part->head_size == sizeof part->head && part->payload.size == part->head.bytes;
}

bool part_read(Run *run, Part *part, double until)
{
    bool news = false;
    while (part->pipe >= 0 && !part->waiting && clock_seconds() < until) {
        size_t size;
        char *capacity = next_place(part, &size);
        ssize_t got = capacity ? read(part->pipe, capacity, size) : 0;
        if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR))
            return news;
        if (got <= 0) {
            run->out_of_memory = run->out_of_memory || !capacity;
            close(part->pipe);
            part->pipe = -1;
            return true;
        }
        news = true;
        note_bytes(part, (size_t)got);
        if (!is_whole(part))
            continue;
        if (!take_message(run, part))
            run->out_of_memory = true;
        part->head_size = part->waiting ? part->head_size : 0;
        part->payload.size = part->waiting ? part->payload.size : 0;
    }
    return news;
}
