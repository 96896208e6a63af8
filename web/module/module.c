// An instance's scene, and what was found about it.
#include "web/module/web.h"

#include "base/array.h"
#include "photons/pass/oddities.h"
#include "photons/photon_file.h"
#include "preview/record/fault.h"
#include "preview/run/wire.h"

#include <stdlib.h>

Page page;

const char *EXPORT(web_error)(void)
{
    return page.error.message;
}

// For what JavaScript gives; to be freed.
void *EXPORT(web_allocate)(size_t size)
{
    return malloc(size);
}

// The scene in place of the one before; true when it is sound, otherwise web_error says at which line and column it is
// not, and the one before stays. With `keep_view` the camera and all settings stay.
bool EXPORT(web_scene)(const char *text, size_t size, const char *name, bool keep_view)
{
    page.error.message[0] = '\0';
    Scene *scene = scene_load_text(text, size, name, "", &page.error);
    if (!scene)
        return false;
    bool kept = keep_view && page.scene;
    view_data_free(page.data);
    page.data = NULL; // made when it is first drawn
    scene_free(page.scene);
    page.scene = scene;
    if (!kept) {
        page.view = view_default(scene);
        StepChoice play = page.asked.play;
        page.asked = (RunRequest){.photons = scene->settings.photons, .seed = 1, .recorded = 1000, .samples = 10000};
        page.asked.play = play;
        page.asked.depth = scene->settings.depth;
        page.asked.spectral = scene->settings.spectral;
        page.asked.integrator = scene->settings.integrator;
        page.k = scene->settings.k;
        page.radius = scene->settings.radius;
    }
    for (int kind = 0; kind <= RUN_RENDER; kind++)
        web_begin(kind);
    page.show_rendered = false;
    return true;
}

// "2.3", "1.5", "2.3,6.4": which steps play where several do the same work; "": what the student's code has.
bool EXPORT(web_steps)(const char *choice)
{
    page.error.message[0] = '\0';
    page.play_chosen = choice[0] != '\0';
    return !page.play_chosen || step_choice_parse(choice, &page.asked.play, &page.error);
}

bool EXPORT(web_begin)(int kind)
{
    Recording *all = &page.collected;
    page.finding_bytes = 0;
    if (kind == RUN_PHOTONS)
        *all = (Recording){.photons = all->photons, .legs = all->legs};
    if (kind == RUN_RENDER) {
        image_free(&page.rendered.image);
        page.rendered.passes = 0;
    }
    return true;
}

static bool append(void *array, size_t *count, size_t *capacity, size_t item, const void *bytes, size_t size)
{
    size_t more = size / item;
    if (!array_reserve(array, *count + more, capacity, item))
        return error_set(&page.error, "not enough memory for what was found");
    char *items;
    memcpy(&items, array, sizeof items);
    memcpy(items + *count * item, bytes, more * item);
    *count += more;
    return true;
}

static bool take_picture(const char *bytes)
{
    WirePicture head;
    memcpy(&head, bytes, sizeof head);
    Image *image = &page.rendered.image;
    if (!image->pixels && !image_create(image, page.asked.width, page.asked.height, &page.error))
        return false;
    rendered_add(&page.rendered, head.width, head.height, (const Colour *)(const void *)(bytes + sizeof head),
                 head.quick, head.mean_of);
    return true;
}

static const size_t FOUND_SIZES[RUN_RENDER + 1] = {
    [RUN_LOBE] = sizeof(LobeSample), [RUN_ESTIMATES] = sizeof(IrradianceEstimate), [RUN_DISKS] = sizeof(ShrinkingDisk)};

static void take_books(RunKind run, const Recording *books)
{
    recording_add_books(&page.collected, books);
    if (!FOUND_SIZES[run] || !page.data)
        return;
    page.finding.count = page.finding_bytes / FOUND_SIZES[run];
    view_data_find(page.data, run, page.finding);
    page.finding = (Findings){NULL, 0};
    page.finding_bytes = page.finding_capacity = 0;
}

// A message of a run, of this instance or of one in a worker: WireKind, as preview/run/wire.h has them. Messages of a
// part come in their order; parts come in theirs.
bool EXPORT(web_receive)(int run, int kind, const char *bytes, size_t size)
{
    Recording *to = &page.collected;
    switch ((WireKind)kind) {
    case WIRE_PHOTONS:
        return append(&to->photons, &to->count, &page.photon_capacity, sizeof *to->photons, bytes, size);
    case WIRE_LEGS:
        return append(&to->legs, &to->leg_count, &page.leg_capacity, sizeof *to->legs, bytes, size);
    case WIRE_FINDINGS:
        return append(&page.finding.items, &page.finding_bytes, &page.finding_capacity, 1, bytes, size);
    case WIRE_PICTURE:
        return take_picture(bytes);
    case WIRE_DONE:
        take_books((RunKind)run, (const Recording *)(const void *)bytes);
        return true;
    case WIRE_BEGUN:
    case WIRE_ALIVE:
    case WIRE_FAILED:
    case WIRE_CRASH:
        return true;
    }
    return error_set(&page.error, "a message of an unknown kind");
}

// What was collected: photons, legs, and where they lie; emitted; rays traced; passes of the picture; the farthest that one of
// those that are shown had flown, m.
const double *EXPORT(web_collected)(void)
{
    static double found[10];
    const Recording *all = &page.collected;
    const double now[10] = {(double)(size_t)all->photons, (double)all->count,
                            sizeof *all->photons,         (double)(size_t)all->legs,
                            (double)all->leg_count,       sizeof *all->legs,
                            (double)all->emitted,         (double)all->segments,
                            (double)page.rendered.passes, page.data ? view_data_recording(page.data)->farthest : 0.0};
    memcpy(found, now, sizeof found);
    return found;
}

// What right steps never do, a line each.
const char *EXPORT(web_oddities)(void)
{
    const Recording *all = &page.collected;
    Oddities found = {&all->ledger, all->emitted, &all->unsound, all->redraw_caps, all->states};
    oddities_describe(&found, page.text, sizeof page.text);
    return page.text;
}

// That a student's step was built, and is not the one that played; "": it is.
const char *EXPORT(web_unplayed)(const char *id)
{
    const StepInfo *step = step_find(id);
    page.text[0] = '\0';
    if (step)
        fault_describe_unplayed(&page.collected, step, "make preview WEB=1", page.text, sizeof page.text);
    return page.text;
}

// All that is collected as a file (.ply, .csv), as `photonlab photons` writes it; web_file has it then.
bool EXPORT(web_write_photons)(const char *name)
{
    const Recording *all = &page.collected;
    StoredPhoton *photons = malloc((all->count + 1) * sizeof *photons);
    page.error.message[0] = '\0';
    if (!photons)
        return error_set(&page.error, "not enough memory for the photons");
    for (size_t i = 0; i < all->count; i++)
        photons[i] = all->photons[i].at;
    bool fine = photon_file_write(photons, all->count, name, &page.error);
    free(photons);
    return fine;
}
