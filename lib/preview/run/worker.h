// A worker: a process that does a part of one request, and ends.
#pragma once

#include "preview/run/wire.h"
#include "render/render.h"

typedef struct {
    const Scene *scene;
    const WireOrder *order;
    int index; // of order->workers
    StepChoice play;
    PhotonPass pass; // what it has counted: its books
    int bounces;     // the most that a photon had met
} Worker;

// Does the part, sends what it finds down the pipe, and ends the process.
void worker_run(Worker *worker, int pipe);

// The work itself, by the steps of the order's folder. False with a reason. It and its parts, by kind of request, know no
// process: what they find goes through worker_send….
bool worker_work(Worker *worker, Error *error);
bool worker_estimates(Worker *worker, Error *error);
bool worker_disks(Worker *worker, Error *error);
bool worker_render(Worker *worker, Error *error); // of no number of passes: goes on until it is killed

// Everything behind one head. Ends the process when the window no longer listens.
void worker_send(WireKind kind, const void *bytes, size_t size);
// In two parts.
void worker_send_both(WireKind kind, const void *first, size_t first_size, const void *rest, size_t rest_size);
// Says that something was finished, and how much is now, 0…1 of the part. Cheap: may be called for each path.
void worker_beat(double fraction);
