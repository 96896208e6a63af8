// What a worker does, wherever it runs.
#include "preview/run/worker.h"

bool worker_work(Worker *worker, Error *error)
{
    const WireOrder *order = worker->order;
    if (!steps_load(order->code[0] ? order->code : NULL, error))
        return false;
    worker_beat(0.0);
    worker->play = order->request.play_is_given ? order->request.play : step_choice_for_student();
    bool asked_by_scene = !order->request.play_is_given && worker->scene->settings.spectral;
    if (order->request.spectral || asked_by_scene)
        worker->play.loop = LOOP_WAVELENGTH;
    steps_play(worker->play);
    switch (order->request.kind) {
    case RUN_PHOTONS:
        return worker_photons(worker, error);
    case RUN_LOBE:
        return worker_lobe(worker, error);
    case RUN_ESTIMATES:
        return worker_estimates(worker, error);
    case RUN_DISKS:
        return worker_disks(worker, error);
    case RUN_RENDER:
        return worker_render(worker, error);
    }
    return error_set(error, "no such kind of run");
}
