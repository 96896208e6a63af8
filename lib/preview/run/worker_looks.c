// What can be seen of how pictures are made: estimates of irradiance (stage 4), disks that shrink (stage 5). Small pictures by the
// scene's own camera.
#include "preview/run/worker.h"
#include "render/passes/passes.h"

#define ESTIMATES_DOWN 160 // pixels
#define DISKS_DOWN     24
#define MOST_ASPECT    4
#define DISK_FIRST     6 // photons of one pass in a disk at first, where as many lie as at a typical point

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
    RenderOptions options = worker_options(worker, across(worker->scene, ESTIMATES_DOWN), ESTIMATES_DOWN);
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
    RenderOptions options = worker_options(worker, width, DISKS_DOWN);
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
