#include "web/web.h"

#include "base/array.h"
#include "photons/photon_file.h"

#include <stdlib.h>

Page page;

const char *EXPORT(web_error)(void)
{
    return page.error.message;
}

static void forget_photons(void)
{
    page.collected.count = page.collected.leg_count = 0;
    page.collected.emitted = page.collected.recorded = 0;
    page.collected.bounces = 0;
    memset(&page.collected.ledger, 0, sizeof page.collected.ledger);
}

// The scene in place of the one before; true when it is sound, otherwise web_error says at which line and column it is
// not, and the one before stays. The camera stays too where `keep_view` is set.
bool EXPORT(web_scene)(const char *text, size_t size, const char *name, bool keep_view)
{
    page.error.message[0] = '\0';
    Scene *scene = scene_load_text(text, size, name, "", &page.error);
    if (!scene)
        return false;
    View before = page.view;
    bool kept = keep_view && page.scene;
    view_data_free(page.data);
    page.data = NULL; // made when it is first drawn
    scene_free(page.scene);
    page.scene = scene;
    page.view = kept ? before : view_default(scene);
    web_load_steps();
    if (!kept)
        page.asked = (PhotonSettings){.photons = (double)scene->settings.photons, .seed = 1, .recorded = 1000};
    page.asked.depth = scene->settings.depth;
    page.asked.spectral = scene->settings.spectral;
    forget_photons();
    return true;
}

// "2.3", "1.5", "2.3,6.4": which steps play where several do the same work.
bool EXPORT(web_steps)(const char *choice)
{
    page.error.message[0] = '\0';
    forget_photons();
    return step_choice_parse(choice, &page.asked.play, &page.error);
}

void EXPORT(web_forget)(void)
{
    forget_photons();
}

static long path_now; // that the recorder is told of
static float reach;

static bool reserve(size_t photons, size_t legs)
{
    Recording *to = &page.collected;
    return array_reserve(&to->photons, to->count + photons, &page.photon_capacity, sizeof *to->photons) &&
           array_reserve(&to->legs, to->leg_count + legs, &page.leg_capacity, sizeof *to->legs);
}

static void take_path(void *user, long path)
{
    (void)user;
    path_now = path;
}

static void take_photon(void *user, const StoredPhoton *photon, float flown)
{
    Recording *to = user;
    if (reserve(1, 0))
        to->photons[to->count++] = (RecordedPhoton){*photon, flown};
}

static void take_leg(void *user, const Photon *photon, const Hit *hit)
{
    Recording *to = user;
    if ((double)path_now < page.asked.recorded && reserve(0, 1))
        to->legs[to->leg_count++] = path_leg(photon, hit, path_now, reach);
}

static void add_ledger(Ledger *sum, const Ledger *part)
{
    double *to = sum->emitted;
    const double *from = part->emitted;
    for (size_t i = 0; i < sizeof *sum / sizeof *to; i++)
        to[i] += from[i];
}

// Emits the paths first … last−1 of all that are asked for, and collects what they leave: parts that follow each other
// are, together, what one pass gives. Their standard errors of chance are not known.
bool EXPORT(web_trace)(double first, double last)
{
    PhotonRecorder recorder = {&page.collected, take_path, take_photon, take_leg};
    StepChoice play = page.asked.play;
    if (page.asked.spectral != 0.0)
        play.loop = LOOP_WAVELENGTH;
    PhotonPassOptions options = {
        .photons = (long)page.asked.photons,
        .depth = (int)page.asked.depth,
        .seed = (uint64_t)page.asked.seed,
        .threads = 1,
        .keep = KEEP_ALL,
        .play = play,
        .first = (long)first,
        .last = (long)last,
        .recorder = &recorder,
    };
    PhotonPass pass;
    page.error.message[0] = '\0';
    steps_play(play);
    reach = recording_reach(page.scene);
    if (!photon_pass_run(page.scene, &options, &pass, &page.error))
        return false;
    add_ledger(&page.collected.ledger, &pass.ledger);
    page.collected.segments += pass.segments;
    page.collected.emitted = (long)last;
    page.collected.play = play;
    photon_pass_free(&pass);
    return true;
}

// What web_trace collected in another instance, copied into this one's memory, behind what is here.
bool EXPORT(web_take)(const RecordedPhoton *photons, size_t count, const PathLeg *legs, size_t leg_count, double last)
{
    Recording *to = &page.collected;
    if (!reserve(count, leg_count))
        return error_set(&page.error, "not enough memory for the photons");
    memcpy(to->photons + to->count, photons, count * sizeof *photons);
    memcpy(to->legs + to->leg_count, legs, leg_count * sizeof *legs);
    to->count += count;
    to->leg_count += leg_count;
    to->emitted = (long)last;
    return true;
}

// Photons, legs: where they lie, how many there are, how many bytes each has.
const double *EXPORT(web_collected)(void)
{
    static double found[8];
    const Recording *all = &page.collected;
    const double now[8] = {(double)(size_t)all->photons, (double)all->count,     sizeof *all->photons,
                           (double)(size_t)all->legs,    (double)all->leg_count, sizeof *all->legs,
                           (double)all->emitted,         (double)all->segments};
    memcpy(found, now, sizeof found);
    return found;
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
