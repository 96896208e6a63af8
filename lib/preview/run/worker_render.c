// Pictures by the student's steps, and what can be seen of how they are made, in small ones by the scene's own camera:
// estimates of irradiance (stage 4), disks that shrink (stage 5).
#include "preview/run/worker.h"
#include "render/passes/pass_file.h"

#define COARSE 8 // pixels of the picture to a side of a pixel of the first one; each next one has half as many

#define ESTIMATES_DOWN 160 // pixels
#define DISKS_DOWN     24
#define MOST_ASPECT    4
#define DISK_FIRST     6 // photons of one pass in a disk at first, where as many lie as at a typical point

const char *const radii_rules[RADII_RULES + 1] = {"alike", "pass", "pixel"};

static void beat(void *user, const char *phase, double fraction)
{
    (void)user, (void)phase;
    worker_beat(fraction);
}

// A picture of this size, with the scene's own settings where the request has none.
static RenderOptions options_for(const Worker *worker, int width, int height)
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
        options_for(worker, (request->width + side - 1) / side, (request->height + side - 1) / side);
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
    RenderOptions options = options_for(worker, request->width, request->height);
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

// Of a picture so high, as wide as the scene's own is to its height.
static int across(const Scene *scene, int down)
{
    float aspect = (float)scene->settings.width / (float)scene->settings.height;
    return (int)fmaxf((float)down * fminf(aspect, MOST_ASPECT) + 0.5f, 1.0f);
}

static void send_estimate(void *user, const IrradianceEstimate *estimate)
{
    (void)user;
    worker_send(WIRE_FINDINGS, estimate, sizeof *estimate);
}

// As the scene's own camera needs them.
bool worker_estimates(Worker *worker, Error *error)
{
    RenderOptions options = options_for(worker, across(worker->scene, ESTIMATES_DOWN), ESTIMATES_DOWN);
    options.integrator = INTEGRATOR_GATHER;
    options.estimates.take = send_estimate;
    Image image = {0, 0, NULL};
    RenderStats stats;
    bool ok = render_image(worker->scene, &options, &image, &stats, error);
    image_free(&image);
    return ok;
}

static ShrinkingDisk disks[MOST_ASPECT * DISKS_DOWN * DISKS_DOWN];

static bool note_radii(void *user, const Passes *passes)
{
    const int *width = user;
    for (int i = 0; i < *width * DISKS_DOWN; i++) {
        disks[i].radius[0] = passes->radius;
        disks[i].radius[passes->done] = passes->points[i].radius;
    }
    return true;
}

// Where the scene's own camera sees a rough surface straight.
static size_t keep_seen(const Scene *scene, int width)
{
    size_t count = 0;
    for (int i = 0; i < width * DISKS_DOWN; i++) {
        Hit hit;
        float x = ((float)(i % width) + 0.5f) / (float)width, y = ((float)(i / width) + 0.5f) / DISKS_DOWN;
        Ray ray = camera_ray(&scene->camera, x, y, (float)width / DISKS_DOWN);
        if (!scene_intersect(scene, &ray, &hit) || !material_is_rough(hit.material))
            continue;
        disks[count] = disks[i];
        disks[count].position = hit.position;
        disks[count++].normal = hit.face_normal;
    }
    return count;
}

// The photons are shared out among the passes.
bool worker_disks(Worker *worker, Error *error)
{
    int width = across(worker->scene, DISKS_DOWN);
    RenderOptions options = options_for(worker, width, DISKS_DOWN);
    options.integrator = INTEGRATOR_PHOTONS;
    options.settings.photons = options.settings.photons / DISK_PASSES + 1;
    options.settings.k = DISK_FIRST;
    options.settings.radius = 0.0f; // k decides
    Passes passes = {.alpha = PASS_ALPHA, .last = DISK_PASSES, .by_pixel = true, .heard = note_radii, .user = &width};
    RenderStats stats;
    bool ok = passes_run(worker->scene, &options, &passes, &stats, error);
    passes_free(&passes);
    if (ok)
        worker_send(WIRE_FINDINGS, disks, keep_seen(worker->scene, width) * sizeof *disks);
    return ok;
}
