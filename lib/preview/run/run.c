// A run, seen from the window: its start, signs of life, and end.
#define _GNU_SOURCE // clock_getcpuclockid, F_SETPIPE_SZ
#include "preview/run/run_internal.h"
#include "base/parallel.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#define A_MOMENT   0.004 // s that a poll may take
#define PATIENCE   2.0   // s
#define PER_WORKER 2000  // photons: fewer are not worth a process of their own

// A picture's tiles and trees take longer than a photon.
void run_patience(Run *run, double seconds)
{
    bool quick = run->request.kind == RUN_PHOTONS || run->request.kind == RUN_LOBE;
    run->patience = quick ? seconds : 5.0 * seconds;
}

// To all of its workers, or to one.
static void send_signal(Run *run, int number, int worker)
{
    WireOrder order = {.run = run->number, .signal = number, .worker = worker};
    broker_send(run->broker, &order, NULL);
}

void run_end_workers(Run *run)
{
    bool working = false;
    for (int i = 0; i < run->part_count; i++) {
        Part *part = &run->parts[i];
        working = working || !part->ended;
        if (part->pipe >= 0)
            close(part->pipe);
        part->pipe = -1;
        part_free(part);
    }
    if (working)
        send_signal(run, SIGKILL, 0);
}

void run_free(Run *run)
{
    if (!run)
        return;
    run_end_workers(run);
    process_kill(&run->looker);
    Run **link = &run->broker->runs;
    while (*link != run)
        link = &(*link)->next;
    *link = run->next;
    image_free(&run->rendered.image);
    free(run);
}

static int count_workers(const Broker *broker, const RunRequest *request)
{
    long worth = 1;
    if (request->kind == RUN_PHOTONS)
        worth += request->photons / PER_WORKER;
    else if (request->kind == RUN_RENDER && request->radii == RADII_ALIKE) // otherwise a pass needs the one before
        worth = MOST_WORKERS;
    return worth < broker->workers ? (int)worth : broker->workers;
}

static bool begin(Run *run, Error *error)
{
    int ends[2], write_ends[MOST_WORKERS], opened = 0;
    for (; opened < run->part_count && pipe_open(ends); opened++) {
#ifdef F_SETPIPE_SZ
        fcntl(ends[0], F_SETPIPE_SZ, 1 << 20);
#endif
        run->parts[opened].pipe = ends[0];
        write_ends[opened] = ends[1];
    }
    WireOrder order = {.run = run->number, .workers = run->part_count, .request = run->request};
    snprintf(order.code, sizeof order.code, "%s", run->request.code ? run->request.code : "");
    bool ok = opened == run->part_count || error_set(error, "no pipe for a worker: %s", strerror(errno));
    if (ok && !broker_send(run->broker, &order, write_ends))
        ok =
            error_set(error, "the preview's helper process is gone; if it does not come back, start the preview again");
    for (int i = 0; i < opened; i++)
        close(write_ends[i]); // the worker's end alone keeps the pipe open
    return ok;
}

Run *run_start(Broker *broker, const RunRequest *request, Error *error)
{
    if ((request->kind != RUN_LOBE && request->kind != RUN_RENDER && request->photons < 1) ||
        (request->kind == RUN_LOBE && request->samples < 1) ||
        (request->kind == RUN_RENDER && (request->width < 1 || request->height < 1))) {
        error_set(error, "a run of nothing: photons, samples and sides must be above 0");
        return NULL;
    }
    Run *run = calloc(1, sizeof *run);
    if (!run) {
        error_set(error, "not enough memory for a run");
        return NULL;
    }
    run->broker = broker;
    run->number = ++broker->last_run;
    run->helper = broker->helpers;
    run->request = *request;
    run->part_count = count_workers(broker, request);
    run->started = run->polled = clock_seconds();
    run->looker.output = -1;
    run_patience(run, PATIENCE);
    for (int i = 0; i < MOST_WORKERS; i++)
        run->parts[i].pipe = -1;
    for (int i = 0; i < run->part_count; i++)
        run->parts[i].alive = run->started;
    run->next = broker->runs;
    broker->runs = run;
    if (begin(run, error))
        return run;
    run_free(run);
    return NULL;
}

// Time of a processor that the worker has used, s; −1 where the system does not tell.
static double processor_seconds(pid_t pid)
{
#if defined(__linux__)
    clockid_t clock;
    struct timespec used;
    if (pid <= 0)
        return 0.0; // not there yet
    if (clock_getcpuclockid(pid, &clock) == 0 && clock_gettime(clock, &used) == 0)
        return (double)used.tv_sec + 1e-9 * (double)used.tv_nsec;
#else
    (void)pid;
#endif
    return -1.0;
}

// One that got no processor is not stuck, up to a point; one that sleeps is.
static bool is_stuck(const Run *run, const Part *part, double now)
{
    double quiet = now - part->alive;
    if (quiet < run->patience)
        return false;
    double used = processor_seconds(part->pid);
    return used < 0.0 || used - part->processor > 0.5 * run->patience || quiet > 3.0 * run->patience;
}

static void watch_life(Run *run, Part *part, bool news)
{
    double now = clock_seconds();
    if (news || part->waiting) {
        part->alive = now;
        part->processor = processor_seconds(part->pid);
    } else if (part->pid <= 0) { // the helper has started nothing: no student's code is to blame
        if (now - part->alive > 3.0 * run->patience)
            broker_lose(run->broker);
    } else if (part->asked > 0.0 && now - part->asked > 0.5) {
        run->stuck = true; // it does not answer
        run->still = processor_seconds(part->pid) - part->processor < 0.5 * run->patience;
    } else if (part->asked <= 0.0 && is_stuck(run, part, now)) {
        part->asked = now;
        send_signal(run, SIGUSR1, (int)(part - run->parts));
    }
}

// A window that stood still itself, at ctrl-z or in a debugger, has heard nothing meanwhile.
static void allow_for_pause(Run *run)
{
    double now = clock_seconds(), gap = now - run->polled;
    run->polled = now;
    for (int i = 0; gap > 1.0 && i < run->part_count; i++) {
        run->parts[i].alive += gap;
        run->parts[i].asked += run->parts[i].asked > 0.0 ? gap : 0.0;
    }
}

// True: all parts are done.
static bool read_parts(Run *run)
{
    double until = clock_seconds() + A_MOMENT, fraction = 0.0;
    bool all_done = true;
    for (int i = 0; i < run->part_count; i++) {
        Part *part = &run->parts[i];
        bool news = part_read(run, part, until);
        run->status.news = run->status.news || (news && run->request.kind != RUN_RENDER);
        if (part->pipe >= 0 && !part->done)
            watch_life(run, part, news);
        fraction += part->done ? 1.0 : part->fraction;
        all_done = all_done && part->done;
    }
    run->status.fraction = fraction / (double)run->part_count;
    return all_done;
}

RunStatus run_poll(Run *run)
{
    run->status.news = false;
    if (run->status.state != RUN_GOING)
        return run->status;
    broker_listen(run->broker);
    allow_for_pause(run);
    if (run->failing) {
        run_go_on_with_failure(run);
        return run->status;
    }
    bool all_done = read_parts(run);
    if (!run_look_for_failure(run, all_done) && all_done) {
        run_describe_oddities(run);
        run->status.state = RUN_DONE;
        run->status.news = true;
    }
    return run->status;
}

void run_wait(Run *run, double seconds)
{
    if (run->status.state != RUN_GOING)
        return;
    struct pollfd watched[2 + MOST_WORKERS] = {{run->broker->socket, POLLIN, 0}, {run->looker.output, POLLIN, 0}};
    for (int i = 0; i < run->part_count; i++)
        watched[2 + i] = (struct pollfd){run->parts[i].waiting ? -1 : run->parts[i].pipe, POLLIN, 0};
    poll(watched, 2 + (nfds_t)run->part_count, (int)(1e3 * seconds + 0.999));
}

const Image *run_image(const Run *run, int *passes)
{
    if (passes)
        *passes = run->rendered.passes;
    return run->rendered.image.pixels ? &run->rendered.image : NULL;
}
