// Messages of workers, taken as they come.
#include "preview/run/run_internal.h"
#include "base/array.h"
#include "base/parallel.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

bool buffer_add(Buffer *buffer, const void *bytes, size_t size)
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
