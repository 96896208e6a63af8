// Samples of a scatter step as a cloud over the lobe of its equation.
#include "preview/view/view_internal.h"
#include "base/text.h"

enum { CLOUD, LINES }; // lists; LobeCounts are what is found

#define RINGS  28
#define SPOKES 48

// Ring i about the axis, close together where the lobe is.
static float ring_angle(const Lobe *lobe, int i)
{
    if (lobe->diffuse)
        return 0.5f * PI * (float)i / RINGS;
    float part = (float)i / (RINGS / 2);
    if (i <= RINGS / 2)
        return acosf(powf(1.0f - 0.999f * part, 1.0f / (lobe->exponent + 1.0f)));
    float inner = ring_angle(lobe, RINGS / 2);
    return inner + (PI - inner) * (part - 1.0f);
}

static Vec3 surface_point(const Lobe *lobe, float share, const Frame *frame, int ring, int spoke)
{
    float alpha = ring_angle(lobe, ring), phi = 2.0f * PI * (float)spoke / SPOKES;
    Vec3 local = vec3(sinf(alpha) * cosf(phi), sinf(alpha) * sinf(phi), cosf(alpha));
    Vec3 direction = frame_to_world(frame, local);
    return lobe_upright(vec3_scale(direction, share * lobe_density(lobe, direction) / lobe->peak));
}

// `share` of the surface's size, as bright as `alpha`.
static void add_surface(const Lobe *lobe, float share, float alpha, Vertices *list)
{
    Frame frame = frame_about(lobe->diffuse ? vec3(0, 0, 1) : lobe->mirror);
    Rgba colour = rgba_fade((Rgba){90, 200, 255, 150}, alpha);
    for (int ring = 0; ring < RINGS; ring++)
        for (int spoke = 0; spoke < SPOKES; spoke++) {
            Vec3 here = surface_point(lobe, share, &frame, ring, spoke);
            if (spoke % 2 == 0)
                vertices_line(list, here, surface_point(lobe, share, &frame, ring + 1, spoke), colour);
            vertices_line(list, here, surface_point(lobe, share, &frame, ring, spoke + 1),
                          rgba_fade(colour, 0.24f * alpha));
        }
}

static void add_arrow(Vertices *list, Vec3 from, Vec3 to, Rgba colour)
{
    Vec3 back = vec3_scale(vec3_normalize(vec3_sub(from, to)), 0.07f);
    Frame frame = frame_about(vec3_normalize(back));
    vertices_line(list, from, to, colour);
    for (int i = 0; i < 4; i++) {
        Vec3 side = vec3_scale(i & 1 ? frame.bitangent : frame.tangent, i & 2 ? 0.03f : -0.03f);
        vertices_line(list, to, vec3_add(vec3_add(to, back), side), colour);
    }
}

// The surface as a disk, its normal, and the two directions.
static void add_axes(const Lobe *lobe, Vertices *list)
{
    Vec3 mirror = lobe->mirror, origin = vec3(0, 0, 0);
    Rgba disk = {120, 130, 150, 150};
    for (int i = 1; i <= 4; i++)
        vertices_circle(list, origin, vec3(1, 0, 0), vec3(0, 0, 1), 0.3f * (float)i,
                        rgba_fade(disk, i == 4 ? 0.6f : 0.25f));
    vertices_line(list, vec3(-1.2f, 0, 0), vec3(1.2f, 0, 0), rgba_fade(disk, 0.4f));
    vertices_line(list, vec3(0, 0, -1.2f), vec3(0, 0, 1.2f), rgba_fade(disk, 0.4f));
    add_arrow(list, origin, vec3(0, 1.15f, 0), (Rgba){150, 235, 150, 220});
    add_arrow(list, lobe_upright(vec3(-1.3f * mirror.x, 0, 1.3f * mirror.z)),
              lobe_upright(vec3_scale(vec3(-mirror.x, 0, mirror.z), 0.03f)), (Rgba){235, 235, 245, 230});
    add_arrow(list, origin, lobe_upright(vec3_scale(mirror, 1.2f)), (Rgba){255, 130, 90, 230});
}

static void build(const View *view, ViewData *data, Vertices *lists)
{
    const double *settings = view->settings[VIEW_LOBE];
    Lobe lobe = lobe_of((float)settings[LOBE_EXPONENT], (float)settings[LOBE_ANGLE], settings[LOBE_DIFFUSE] != 0.0,
                        data->recording.play);
    float noise = 2.0f / sqrtf(LOBE_NEAREST);
    add_axes(&lobe, &lists[LINES]);
    add_surface(&lobe, 1.0f, 1.0f, &lists[LINES]);
    add_surface(&lobe, 1.0f + noise, 0.3f, &lists[LINES]); // where 19 of 20 right samples are at most, by chance
    lobe_cloud(&lobe, &data->findings[RUN_LOBE], data->made[VIEW_LOBE].found, &lists[CLOUD]);
}

// Turned as the scene is, but from where the lobe is seen best.
static void draw(const Pane *pane)
{
    Orbit start = orbit_of_camera(&pane->data->scene->camera, bvh_bounds(pane->data->scene->bvh)),
          orbit = pane->view->orbit;
    orbit.yaw -= start.yaw;
    orbit.pitch -= start.pitch;
    orbit.vertical_fov = 35.0f;
    orbit_turn(&orbit, 0.35f, 0.25f);
    orbit_frame(&orbit, (Box){{-1, -0.05f, -1}, {1, 1.25f, 1}}, (float)pane->width / (float)pane->height);
    orbit.target = vec3(0, 0.5f, 0);
    orbit.distance *= 0.8f;
    pane_frame(&pane->view->framing, &orbit);
    pane_look(pane, &orbit, (Box){{-2, -2, -2}, {2, 2, 2}}, 0, 0);
    pane_draw(pane, CLOUD, (DrawStyle){.point_size = fmaxf(pane->scale - 0.5f, 1.0f)});
    pane_draw(pane, LINES, (DrawStyle){.kind = DRAW_LINES});
}

static void describe(const View *view, const ViewData *data, char *text, size_t size)
{
    const double *settings = view->settings[VIEW_LOBE];
    const LobeCounts *counts = data->made[VIEW_LOBE].found;
    size_t count = data->findings[RUN_LOBE].count;
    bool diffuse = settings[LOBE_DIFFUSE] != 0.0;
    const char *step = diffuse ? "1.3" : data->recording.play.glossy == GLOSSY_PHONG ? "2.4" : "2.3";
    const char *whose = whose_step(data, step);
    text[0] = '\0';
    if (diffuse)
        text_append(text, size, "diffuse, step %s%s: density cos(theta)/pi", step, whose);
    else
        text_append(text, size, "glossy, step %s%s: exponent %.4g, %.4g degrees", step, whose, settings[LOBE_EXPONENT],
                    settings[LOBE_ANGLE]);
    text_append(text, size, "\n%zu samples, %.1f %% absorbed", count,
                count ? 100.0 * (double)counts->absorbed / (double)count : 0.0);
    if (counts->below)
        text_append(text, size, "\n%zu point into the surface (red)", counts->below);
    if (counts->not_unit)
        text_append(text, size, "\n%zu are not of unit length (drawn at theirs)", counts->not_unit);
}

static void legend(const View *view, const ViewData *data, Legend *legend)
{
    (void)view, (void)data;
    legend_add(legend, (Rgba){90, 200, 255, 255}, "the equation; faint: + noise");
    legend_add(legend, (Rgba){255, 205, 110, 255}, "samples");
    legend_add(legend, (Rgba){235, 235, 245, 255}, "photon");
    legend_add(legend, (Rgba){255, 130, 90, 255}, "mirror direction");
    legend_add(legend, (Rgba){150, 235, 150, 255}, "normal");
}

static void choose(View *view, const ViewData *data, bool sideways, int step)
{
    (void)data;
    double *settings = view->settings[VIEW_LOBE], exponent = settings[LOBE_EXPONENT];
    if (sideways)
        settings[LOBE_ANGLE] = fmin(fmax(settings[LOBE_ANGLE] + 5.0 * step, 0.0), 85.0);
    else
        settings[LOBE_EXPONENT] = fmin(fmax(step > 0 ? exponent * 1.5 + 0.5 : (exponent - 0.5) / 1.5, 0.0), 5000.0);
}

const ViewType view_lobe = {
    .help = "20000 samples of the scatter step over the lobe of the equation; --exponent N,\n"
            "--angle DEGREES of the mirror direction to the normal, --diffuse\n",
    .arrows = "angle, exponent",
    .place = ON_A_STAND,
    .shows = RUN_LOBE,
    .settings =
        {[LOBE_EXPONENT] = {.flag = "exponent", .kind = SETTING_NUMBER, .start = 20, .high = 1e6},
         [LOBE_ANGLE] = {.flag = "angle", .kind = SETTING_NUMBER, .start = 45, .high = 89.9},
         [LOBE_DIFFUSE] = {.flag = "diffuse", .kind = SETTING_SWITCH, .key = 'd', .words = "glossy or diffuse step"}},
    .build = build,
    .draw = draw,
    .describe = describe,
    .legend = legend,
    .choose = choose,
    .found_size = sizeof(LobeCounts),
};
