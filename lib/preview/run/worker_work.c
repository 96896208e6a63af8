// What a worker does, wherever it runs.
#include "preview/run/worker.h"

#include <string.h>

void worker_send(WireKind kind, const void *bytes, size_t size)
{
    worker_send_both(kind, bytes, size, NULL, 0);
}

void worker_send_books(const Worker *worker, WireKind kind)
{
    Recording books;
    memset(&books, 0, sizeof books);
    books.ledger = worker->pass.ledger;
    books.emitted = worker->pass.emitted;
    books.unsound = worker->pass.unsound;
    books.redraw_caps = redraw_cap_count();
    books.segments = worker->pass.segments;
    books.bounces = worker->bounces;
    memcpy(books.states, step_states, sizeof books.states);
    books.play = worker->play;
    worker_send(kind, &books, sizeof books);
}

bool worker_work(Worker *worker, Error *error)
{
    static bool (*const WORK[])(Worker *, Error *) = {[RUN_PHOTONS] = worker_photons,
                                                      [RUN_LOBE] = worker_lobe,
                                                      [RUN_ESTIMATES] = worker_estimates,
                                                      [RUN_DISKS] = worker_disks,
                                                      [RUN_RENDER] = worker_render};
    const WireOrder *order = worker->order;
    if (!steps_load(order->code[0] ? order->code : NULL, error))
        return false;
    worker_beat(0.0);
    worker->play = order->request.play_is_given ? order->request.play : step_choice_for_student();
    bool asked_by_scene = !order->request.play_is_given && worker->scene->settings.spectral;
    if (order->request.spectral || asked_by_scene)
        worker->play.loop = LOOP_WAVELENGTH;
    steps_play(worker->play);
    if (!WORK[order->request.kind](worker, error))
        return false;
    worker_send_books(worker, WIRE_DONE);
    return true;
}
