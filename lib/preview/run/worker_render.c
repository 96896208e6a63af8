// Pictures by the student's steps.
#include "preview/run/worker.h"
#include "render/passes/pass_file.h"

#define COARSE 8 // pixels of the picture to a side of a pixel of the first one; each next one has half as many

const char *const radii_rules[RADII_RULES + 1] = {"alike", "pass", "pixel"};

static void beat(void *user, const char *phase, double fraction)
{
    (void)user, (void)phase;
    worker_beat(fraction);
}

RenderOptions worker_options(const Worker *worker, int width, int height)
{
    const RunRequest *request = &worker->order->request;
    RenderOptions options = {
        .integrator = request->integrator,
        .settings = worker->scene->settings,
        .seed = request->seed,
        .threads = 1, // a worker a core does passes of its own
        .play = worker->play,
        .hero = true,
        .glass_sides = 2,
        .reuse = REUSE_DEFAULT,
        .progress = {beat, NULL},
    };
    RenderSettings *settings = &options.settings;
    settings->samples = 1;
    settings->width = width;
    settings->height = height;
    settings->photons = request->photons > 0 ? request->photons : settings->photons;
    settings->depth = request->depth > 0 ? request->depth : settings->depth;
    return options;
}

static void send_picture(const Image *image, bool coarse, int mean_of)
{
    WirePicture head = {image->width, image->height, coarse, mean_of};
    size_t pixels = (size_t)image->width * (size_t)image->height;
    worker_send_both(WIRE_PICTURE, &head, sizeof head, image->pixels, pixels * sizeof image->pixels[0]);
}

// `side`: of the picture's pixels, to one of this one.
static bool render_pass(Worker *worker, uint64_t pass, int side, Error *error)
{
    const RunRequest *request = &worker->order->request;
    RenderOptions options =
        worker_options(worker, (request->width + side - 1) / side, (request->height + side - 1) / side);
    // The first pass is the picture that `photonlab render --samples 1 --seed S` gives.
    options.seed = pass == 0 ? request->seed : hash_u64(request->seed + pass);
    if (side == COARSE && options.integrator == INTEGRATOR_GATHER) // the first is wanted soon
        options.integrator = INTEGRATOR_PHOTONS;
    options.settings.photons = side > 1 ? options.settings.photons / side + 1 : options.settings.photons;
    Image image = {0, 0, NULL};
    RenderStats stats;
    if (!render_image(worker->scene, &options, &image, &stats, error))
        return false;
    send_picture(&image, side > 1, 0);
    image_free(&image);
    return true;
}

static bool send_mean(void *user, const Passes *passes)
{
    Error *error = user;
    Image image = {0, 0, NULL};
    if (!passes_picture(passes, &image, error))
        return false;
    send_picture(&image, false, passes->done);
    image_free(&image);
    return true;
}

// Progressive photon mapping.
static bool render_in_a_row(Worker *worker, Error *error)
{
    const RunRequest *request = &worker->order->request;
    RenderOptions options = worker_options(worker, request->width, request->height);
    Passes passes = {.alpha = PASS_ALPHA,
                     .last = request->passes > 0 ? request->passes : MOST_PASSES,
                     .by_pixel = request->radii == RADII_BY_PIXEL,
                     .heard = send_mean,
                     .user = error};
    RenderStats stats;
    bool ok = passes_run(worker->scene, &options, &passes, &stats, error) && !error->message[0];
    passes_free(&passes);
    return ok;
}

bool worker_render(Worker *worker, Error *error)
{
    const RunRequest *request = &worker->order->request;
    static Scene scene; // as the request's camera sees it
    scene = *worker->scene;
    scene.camera = request->camera;
    worker->scene = &scene;
    uint64_t passes = request->passes > 0 ? (uint64_t)request->passes : UINT64_MAX;
    for (int side = COARSE; worker->index == 0 && request->passes == 0 && side > 1; side /= 2)
        if (!render_pass(worker, 0, side, error))
            return false;
    if (request->radii != RADII_ALIKE)
        return render_in_a_row(worker, error);
    for (uint64_t pass = (uint64_t)worker->index; pass < passes; pass += (uint64_t)worker->order->workers)
        if (!render_pass(worker, pass, 1, error))
            return false;
    return true;
}
