// Where final gathering (stage 4) makes its estimates of irradiance, as dots and short normals, and how far each reaches, as a
// circle: where it alone would serve.
#include "preview/view/view_internal.h"

#include <stdio.h>

enum { CIRCLES };      // settings: drawn
enum { LINES, DOTS };  // lists
#define ACCURACY 0.25f // of irradiance_cache: within this part of its reach an estimate serves
#define NORMAL   0.35f // of the circle's radius

static void build(const View *view, ViewData *data, Vertices *lists)
{
    (void)view;
    const Findings *found = &data->findings[RUN_ESTIMATES];
    const IrradianceEstimate *estimates = found->items;
    float sum = 0.0f;
    for (size_t i = 0; i < found->count; i++)
        sum += colour_max(estimates[i].irradiance);
    for (size_t i = 0; i < found->count; i++) {
        const IrradianceEstimate *e = &estimates[i];
        if (!(e->reach > 0.0f && isfinite(e->reach) && isfinite(vec3_dot(e->position, e->normal))))
            continue;
        Frame frame = frame_about(e->normal);
        Rgba light = rgba_of_power(e->irradiance, 2.0f * sum / (float)found->count);
        float radius = ACCURACY * e->reach;
        vertices_circle(&lists[LINES], e->position, frame.tangent, frame.bitangent, radius, rgba_fade(light, 0.6f));
        vertices_fading(&lists[LINES], e->position, vec3_along(e->position, e->normal, NORMAL * radius), light,
                        rgba_fade(light, 0.0f));
        vertices_point(&lists[DOTS], e->position, light);
    }
}

static void draw(const Pane *pane)
{
    pane_look_at_scene(pane);
    if (pane->view->settings[VIEW_ESTIMATES][CIRCLES] == 0.0)
        pane_draw(pane, LINES, (DrawStyle){.kind = DRAW_LINES});
    pane_draw(pane, DOTS, (DrawStyle){.point_size = 1.0f + floorf(2.0f * pane->scale)});
}

static void describe(const View *view, const ViewData *data, char *text, size_t size)
{
    (void)view;
    const Findings *found = &data->findings[RUN_ESTIMATES];
    const IrradianceEstimate *estimates = found->items;
    float least = INFINITY, most = 0.0f;
    for (size_t i = 0; i < found->count; i++) {
        least = fminf(least, estimates[i].reach);
        most = fmaxf(most, estimates[i].reach);
    }
    if (data->come[RUN_ESTIMATES] == 0)
        snprintf(text, size, "gather rays are on their way");
    else
        snprintf(
            text, size,
            "%zu estimates of irradiance, step 4.4%s: they reach from %.2g to %.2g m; a circle shows the part where one serves",
            found->count, whose_step(data, "4.4"), (double)fminf(least, most), (double)most);
}

const ViewType view_estimates = {
    .help = "where final gathering estimates irradiance, and how far that serves; --no-circles\n",
    .place = IN_THE_SCENE,
    .wires = 0.3f,
    .shows = RUN_ESTIMATES,
    .settings = {{.flag = "no-circles", .kind = SETTING_SWITCH, .key = 'v', .words = "circles, or places alone"}},
    .build = build,
    .draw = draw,
    .describe = describe,
};
