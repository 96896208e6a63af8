// Samples of a scatter step over the lobe of its equation. A sample's point lies in its direction, as far out as the
// samples are dense there, by the estimate that photon maps make: k nearest over their area. So the cloud lies on the
// equation's surface where the step is right, whatever is wrong in it.
#include "preview/view/view_internal.h"

#include <stdlib.h>

#define NEAREST 300 // samples in an estimate: 6 % of noise
#define RINGS   28
#define SPOKES  48

Vec3 lobe_mirror(const View *view)
{
    float angle = view->angle * (PI / 180.0f);
    return vec3(sinf(angle), 0, cosf(angle));
}

float lobe_density(const View *view, StepChoice play, const LobeTable *table, Vec3 direction)
{
    if (direction.z <= 0.0f)
        return 0.0f;
    if (view->diffuse)
        return direction.z / PI;
    Vec3 mirror = lobe_mirror(view);
    float cosine = fminf(vec3_dot(mirror, direction), 1.0f);
    float lobe = cosine > 0.0f ? powf(cosine, view->exponent) : 0.0f;
    if (play.glossy == GLOSSY_PHONG)
        return (view->exponent + 1.0f) / (2.0f * PI) * lobe;
    if (cosine <= 0.0f)
        return direction.z / PI;
    float share = 0.5f * (1.0f + mirror.z); // of diffuse directions that lie on the mirror direction's side
    return share * lobe / lobe_above_surface(table, mirror.z);
}

// Ring i about the axis, close together where the lobe is.
static float ring_angle(const View *view, int i)
{
    if (view->diffuse)
        return 0.5f * PI * (float)i / RINGS;
    float part = (float)i / (RINGS / 2);
    if (i <= RINGS / 2)
        return acosf(powf(1.0f - 0.999f * part, 1.0f / (view->exponent + 1.0f)));
    float inner = ring_angle(view, RINGS / 2);
    return inner + (PI - inner) * (part - 1.0f);
}

// The view's own stage: up is the normal, and the photon flies from the left to the right.
static Vec3 on_stage(Vec3 local)
{
    return vec3(local.x, local.z, -local.y);
}

static Vec3 surface_point(const Lobe *lobe, const Frame *frame, int ring, int spoke)
{
    float alpha = ring_angle(lobe->view, ring), phi = 2.0f * PI * (float)spoke / SPOKES;
    Vec3 local = vec3(sinf(alpha) * cosf(phi), sinf(alpha) * sinf(phi), cosf(alpha));
    Vec3 direction = frame_to_world(frame, local);
    float density = lobe_density(lobe->view, lobe->play, lobe->table, direction);
    return on_stage(vec3_scale(direction, density / lobe->peak));
}

bool lobe_prepare(const View *view, StepChoice play, Lobe *lobe)
{
    *lobe = (Lobe){view, play, malloc(sizeof(LobeTable)), 1.0f};
    if (!lobe->table)
        return false;
    lobe_table_fill(lobe->table, view->exponent);
    float peak = 0.0f;
    for (int i = 0; i <= 1000; i++) { // along the plane of incidence, where the peak is
        float angle = PI * ((float)i / 1000.0f - 0.5f);
        Vec3 direction = vec3(sinf(angle), 0, cosf(angle));
        peak = fmaxf(peak, lobe_density(view, play, lobe->table, direction));
    }
    lobe->peak = fmaxf(peak, lobe_density(view, play, lobe->table, lobe_mirror(view)));
    return true;
}

static void add_surface(const Lobe *lobe, Vertices *list)
{
    Vec3 axis = lobe->view->diffuse ? vec3(0, 0, 1) : lobe_mirror(lobe->view);
    Frame frame = frame_about(axis);
    Rgba colour = {90, 200, 255, 150};
    for (int ring = 0; ring < RINGS; ring++)
        for (int spoke = 0; spoke < SPOKES; spoke++) {
            Vec3 here = surface_point(lobe, &frame, ring, spoke);
            if (spoke % 2 == 0)
                vertices_line(list, here, surface_point(lobe, &frame, ring + 1, spoke), colour);
            vertices_line(list, here, surface_point(lobe, &frame, ring, spoke + 1), rgba_fade(colour, 0.24f));
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

static void add_stage(const View *view, Vertices *list)
{
    Vec3 mirror = lobe_mirror(view), origin = vec3(0, 0, 0);
    Rgba disk = {120, 130, 150, 150};
    for (int i = 1; i <= 4; i++)
        vertices_circle(list, origin, vec3(1, 0, 0), vec3(0, 0, 1), 0.3f * (float)i,
                        rgba_fade(disk, i == 4 ? 0.6f : 0.25f));
    vertices_line(list, vec3(-1.2f, 0, 0), vec3(1.2f, 0, 0), rgba_fade(disk, 0.4f));
    vertices_line(list, vec3(0, 0, -1.2f), vec3(0, 0, 1.2f), rgba_fade(disk, 0.4f));
    add_arrow(list, origin, vec3(0, 1.15f, 0), (Rgba){150, 235, 150, 220});
    add_arrow(list, on_stage(vec3(-1.3f * mirror.x, 0, 1.3f * mirror.z)),
              on_stage(vec3_scale(vec3(-mirror.x, 0, mirror.z), 0.03f)), (Rgba){235, 235, 245, 230});
    add_arrow(list, origin, on_stage(vec3_scale(mirror, 1.2f)), (Rgba){255, 130, 90, 230});
}

// Part of the disk of radius r about a direction that lies above the surface, where directions can be.
static float part_above(float height, float r)
{
    float t = height / r;
    if (t >= 1.0f || t <= 0.0f)
        return 1.0f;
    return 1.0f - (acosf(t) - t * sqrtf(1.0f - t * t)) / PI;
}

// Directions that are no numbers or nothing are counted and left out.
static size_t usable(Side *side, StoredPhoton *photons)
{
    size_t count = 0;
    side->lobe_absorbed = side->lobe_below = side->lobe_long = 0;
    for (size_t i = 0; i < side->lobe.count; i++) {
        Vec3 d = side->lobe.items[i].direction;
        float length = vec3_length(d), weight = side->lobe.items[i].weight;
        if (weight == 0.0f) {
            side->lobe_absorbed++;
            continue;
        }
        bool sound = isfinite(length) && length > 1e-6f;
        side->lobe_long += !sound || fabsf(length - 1.0f) > 1e-3f;
        side->lobe_below += sound && d.z < 0.0f;
        if (sound)
            photons[count++] = (StoredPhoton){.position = vec3_scale(d, 1.0f / length), .power = {length, weight, 0}};
    }
    return count;
}

void lobe_cloud(const Lobe *lobe, Side *side, Vertices *list)
{
    StoredPhoton *photons = malloc((side->lobe.count + 1) * sizeof *photons);
    NearPhoton near[PHOTON_MAP_NEAREST_ROOM(NEAREST)];
    Error error;
    size_t count = photons ? usable(side, photons) : 0;
    PhotonMap *map = photons ? photon_map_build(photons, count, &error) : NULL;
    for (size_t i = 0; map && i < count; i++) {
        const StoredPhoton *sample = &photon_map_photons(map)[i];
        float radius2 = INFINITY;
        if (photon_map_nearest(map, sample->position, NEAREST, &radius2, near) < NEAREST)
            continue;
        radius2 = fmaxf(radius2, 1e-10f);
        float share = (float)(NEAREST - 1) / (float)side->lobe.count; // without the sample itself
        float density = share / (PI * radius2 * part_above(sample->position.z, sqrtf(radius2)));
        float far_out = fminf(density / lobe->peak, 2.5f) * sample->power.r;
        Rgba colour = sample->position.z < 0.0f ? (Rgba){255, 50, 50, 255} : (Rgba){255, 205, 110, 120};
        vertices_point(list, on_stage(vec3_scale(sample->position, far_out)), colour);
    }
    if (map)
        photon_map_free(map);
}

// Turned as the scene is, but from where the stage is seen best.
static Orbit stage_orbit(const Pane *pane)
{
    Orbit start = orbit_of_camera(&pane->scene->camera, bvh_bounds(pane->scene->bvh)), orbit = pane->view->orbit;
    orbit.yaw -= start.yaw;
    orbit.pitch -= start.pitch;
    orbit.vertical_fov = 35.0f;
    orbit_turn(&orbit, 0.35f, 0.25f);
    float aspect = (float)pane->width / (float)pane->height;
    orbit_frame(&orbit, (Box){{-1, -0.05f, -1}, {1, 1.25f, 1}}, aspect);
    orbit.target = vec3(0, 0.5f, 0);
    orbit.distance *= 0.8f;
    pane_frame(&pane->view->framing, &orbit);
    return orbit;
}

void view_lobe_draw(const Pane *pane)
{
    Side *side = pane->side;
    const View *view = pane->view;
    const double key[KEY_SIZE] = {view->exponent, view->angle, view->diffuse, side->recording.play.glossy};
    bool lines_known = cache_is(&side->lobe_lines, key), points_known = cache_is(&side->lobe_points, key);
    Lobe lobe;
    if ((!lines_known || !points_known) && lobe_prepare(view, side->recording.play, &lobe)) {
        Vertices lines = {.items = NULL}, points = {.items = NULL};
        add_stage(view, &lines);
        add_surface(&lobe, &lines);
        cache_fill(pane->canvas, &side->lobe_lines, &lines);
        if (!points_known) {
            lobe_cloud(&lobe, side, &points);
            cache_fill(pane->canvas, &side->lobe_points, &points);
        }
        free(lobe.table);
    }
    Orbit orbit = stage_orbit(pane);
    pane_look(pane, &orbit, (Box){{-2, -2, -2}, {2, 2, 2}});
    batch_draw(pane->canvas, side->lobe_points.batch, 0, batch_count(side->lobe_points.batch),
               &(DrawStyle){.no_depth = true, .point_size = fmaxf(pane->scale - 0.5f, 1.0f)});
    batch_draw(pane->canvas, side->lobe_lines.batch, 0, batch_count(side->lobe_lines.batch),
               &(DrawStyle){.kind = DRAW_LINES, .no_depth = true});
}
