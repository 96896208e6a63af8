// Getting a run under way: a pipe for each worker, and the order to the helper.
#define _GNU_SOURCE // F_SETPIPE_SZ
#include "preview/run/run_internal.h"
#include "base/parallel.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define PATIENCE   2.0  // s
#define PER_WORKER 2000 // photons: fewer are not worth a process of their own

static int count_workers(const Broker *broker, const RunRequest *request)
{
    bool in_a_row = request->kind == RUN_RENDER && request->radii != RADII_ALIKE; // a pass needs the one before
    if (in_a_row || (request->kind != RUN_PHOTONS && request->kind != RUN_RENDER))
        return 1;
    long worth = request->kind == RUN_PHOTONS ? 1 + request->photons / PER_WORKER : MOST_WORKERS;
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
    bool ok =
        opened == run->part_count
            ? broker_send(run->broker, &order, write_ends) ||
                  error_set(error,
                            "the preview's helper process is gone; if it does not come back, start the preview again")
            : error_set(error, "no pipe for a worker: %s", strerror(errno));
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
