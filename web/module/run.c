// Runs steps: what a worker process does for the window (preview/run/worker.h), with messages to JavaScript.
#include "preview/run/worker.h"
#include "web/module/web.h"

#include "base/parallel.h"

#define BEAT     0.05 // s between signs of life
#define PATIENCE 1.8  // s without one, of code that is watched; five times as much where pictures are made

void IMPORT(photonlab_send)(int run, int kind, const void *first, size_t first_size, const void *rest,
                            size_t rest_size);
void IMPORT(photonlab_beat)(double fraction);

static RunKind kind_now;
static long caps_before;
static double last_beat;

static void note_life(void)
{
    last_beat = clock_seconds();
    web_alive(kind_now == RUN_PHOTONS || kind_now == RUN_LOBE ? PATIENCE : 5.0 * PATIENCE);
}

void worker_send_both(WireKind kind, const void *first, size_t first_size, const void *rest, size_t rest_size)
{
    Recording books;
    if (kind == WIRE_DONE) { // an instance runs more than once
        memcpy(&books, first, sizeof books);
        books.redraw_caps -= caps_before;
        first = &books;
    }
    photonlab_send((int)kind_now, (int)kind, first, first_size, rest, rest_size);
}

void worker_beat(double fraction)
{
    static unsigned calls;
    if (calls++ % 16 != 0 || clock_seconds() - last_beat < BEAT)
        return;
    note_life();
    photonlab_beat(fraction);
}

// Part number `part` of `parts`, of what the view and the parameters ask for.
bool EXPORT(web_run)(int kind, int part, int parts)
{
    static WireOrder order; // its path is long
    const double *lobe = page.view.settings[VIEW_LOBE];
    page.error.message[0] = '\0';
    if (!page.scene)
        return error_set(&page.error, "there is no scene yet");
    RunRequest *request = &order.request;
    *request = page.asked;
    kind_now = request->kind = (RunKind)kind;
    request->play_is_given = page.play_chosen;
    if (!page.play_chosen && page.scene->settings.spectral && !page.asked.spectral) {
        request->play_is_given = true; // the scene asks for single wavelengths, and the page does not
        request->play = step_choice_for_student();
    }
    request->exponent = (float)lobe[LOBE_EXPONENT];
    request->angle = (float)lobe[LOBE_ANGLE];
    request->diffuse = lobe[LOBE_DIFFUSE] != 0.0;
    request->camera = orbit_camera(&page.view.orbit);
    order.workers = parts;
    Scene scene = *page.scene;
    scene.settings.k = page.k;
    scene.settings.radius = page.radius;
    Worker worker = {.scene = &scene, .order = &order, .index = part};
    caps_before = redraw_cap_count();
    note_life();
    return worker_work(&worker, &page.error);
}
