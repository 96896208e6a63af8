#include "preview/run/worker.h"
#include "render/render.h"

#define QUICK 4 // pixels of the picture to a side of a pixel of the quick one

static void beat(void *user, const char *phase, double fraction)
{
    (void)user, (void)phase;
    worker_beat(fraction);
}

static bool render_pass(Worker *worker, uint64_t pass, bool quick, Error *error)
{
    const RunRequest *request = &worker->order->request;
    Scene scene = *worker->scene;
    scene.camera = request->camera;
    RenderOptions options = {
        .integrator = INTEGRATOR_PHOTONS,
        .settings = scene.settings,
        // The first pass is the picture that `photonlab render --samples 1 --seed S` gives.
        .seed = pass == 0 ? request->seed : hash_u64(request->seed + pass),
        .threads = 1, // a worker a core does passes of its own
        .play = worker->play,
        .hero = true,
        .glass_sides = 2,
        .reuse = REUSE_DEFAULT,
        .progress = {beat, NULL},
    };
    RenderSettings *settings = &options.settings;
    settings->samples = 1;
    settings->width = quick ? (request->width + QUICK - 1) / QUICK : request->width;
    settings->height = quick ? (request->height + QUICK - 1) / QUICK : request->height;
    settings->photons = request->photons > 0 ? request->photons : settings->photons;
    settings->photons = quick ? settings->photons / QUICK + 1 : settings->photons;
    settings->depth = request->depth > 0 ? request->depth : settings->depth;
    Image image = {0, 0, NULL};
    RenderStats stats;
    if (!render_image(&scene, &options, &image, &stats, error))
        return false;
    WirePicture head = {image.width, image.height, quick};
    size_t pixels = (size_t)image.width * (size_t)image.height;
    worker_send_both(WIRE_PICTURE, &head, sizeof head, image.pixels, pixels * sizeof image.pixels[0]);
    image_free(&image);
    return true;
}

bool worker_render(Worker *worker, Error *error)
{
    if (worker->index == 0 && !render_pass(worker, 0, true, error))
        return false;
    for (uint64_t pass = (uint64_t)worker->index;; pass += (uint64_t)worker->order->workers)
        if (!render_pass(worker, pass, false, error))
            return false;
}
