// The disks in which progressive photon mapping looks for photons, at points that the eye sees, as pass after pass shrinks
// them (Hachisuka et al. 2008): a map of radii, by step 5.3.
#include "preview/view/view_internal.h"

#include <stdio.h>

enum { PASS };  // settings: after so many
enum { DISKS }; // lists

// From red, as at first, to blue, a fifth of that and less.
static Rgba colour_of(float radius, float first)
{
    float shrunk = fminf(fmaxf(-logf(radius / first) / logf(5.0f), 0.0f), 1.0f);
    return palette_hue(0.66f * shrunk);
}

static int pass_of(const View *view)
{
    return (int)fmin(view->settings[VIEW_RADII][PASS], DISK_PASSES);
}

static void build(const View *view, ViewData *data, Vertices *lists)
{
    const Findings *found = &data->findings[RUN_DISKS];
    const ShrinkingDisk *disks = found->items;
    for (size_t i = 0; i < found->count; i++) {
        float radius = disks[i].radius[pass_of(view)], first = disks[i].radius[0];
        Frame frame = frame_about(disks[i].normal);
        if (radius > 0.0f && isfinite(radius) && first > 0.0f)
            vertices_circle(&lists[DISKS], disks[i].position, frame.tangent, frame.bitangent, radius,
                            colour_of(radius, first));
    }
}

static void draw(const Pane *pane)
{
    pane_look_at_scene(pane);
    pane_draw(pane, DISKS, (DrawStyle){.kind = DRAW_LINES});
}

static void describe(const View *view, const ViewData *data, char *text, size_t size)
{
    const Findings *found = &data->findings[RUN_DISKS];
    const ShrinkingDisk *disks = found->items;
    int pass = pass_of(view);
    float least = INFINITY, most = 0.0f;
    for (size_t i = 0; i < found->count; i++) {
        least = fminf(least, disks[i].radius[pass]);
        most = fmaxf(most, disks[i].radius[pass]);
    }
    if (data->come[RUN_DISKS] == 0)
        snprintf(text, size, "the passes are on their way");
    else if (!(most > 0.0f))
        snprintf(text, size, "no photons, no radii");
    else
        snprintf(text, size, "after %d of %d passes%s: radii from %.2g to %.2g m", pass, DISK_PASSES,
                 whose_step(data, "5.3"), (double)least, (double)most);
}

static void legend(const View *view, const ViewData *data, Legend *legend)
{
    (void)view, (void)data;
    static const float shares[] = {1.0f, 0.8f, 0.6f, 0.4f, 0.2f};
    for (int i = 0; i < 5; i++)
        legend_add(legend, colour_of(shares[i], 1.0f), "%s%g", i == 0 ? "of the first radius: " : "",
                   (double)shares[i]);
}

static void choose(View *view, const ViewData *data, bool sideways, int step)
{
    (void)data;
    double *pass = &view->settings[VIEW_RADII][PASS];
    if (!sideways)
        *pass = fmin(fmax(*pass + step, 0.0), DISK_PASSES);
}

const ViewType view_radii = {
    .help = "disks that passes look for photons in, where the eye sees them; --pass N passes later\n",
    .arrows = "passes",
    .place = IN_THE_SCENE,
    .wires = 0.3f,
    .shows = RUN_DISKS,
    .settings = {{.flag = "pass", .kind = SETTING_WHOLE, .start = 16, .low = 0, .high = DISK_PASSES}},
    .build = build,
    .draw = draw,
    .describe = describe,
    .legend = legend,
    .choose = choose,
};
