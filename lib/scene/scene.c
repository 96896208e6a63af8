#include "scene/scene.h"

#include <string.h>

#include <stdlib.h>

void scene_free(Scene *scene)
{
    if (!scene)
        return;
    for (size_t i = 0; i < scene->material_count; i++)
        free(scene->materials[i].lobe);
    free(scene->materials);
    for (size_t i = 0; i < scene->light_count; i++)
        free(scene->lights[i].spectrum);
    free(scene->lights);
    free(scene->flats);
    free(scene->spheres);
    free(scene->normals);
    bvh_free(scene->bvh);
    free(scene->mesh_files);
    free(scene);
}

// A hit nearer than this does not count, a millionth of the origin's largest coordinate: in a corner, rounding may have
// put the origin just behind the surface next to its own.
static float nearest_distance(Vec3 origin)
{
    float x = fabsf(origin.x), y = fabsf(origin.y), z = fabsf(origin.z);
    float larger = x > y ? x : y;
    return 1e-6f * (larger > z ? larger : z);
}

static Vec3 interpolated_normal(const Scene *scene, const Flat *flat, const BvhHit *at)
{
    const Vec3 *corner = &scene->normals[flat->normals - 1];
    Vec3 sum = vec3_scale(corner[0], 1.0f - at->u - at->v);
    sum = vec3_along(sum, corner[1], at->u);
    return vec3_normalize(vec3_along(sum, corner[2], at->v));
}

// `outside`: the surface's own normal.
static void set_side(const Ray *ray, Vec3 outside, Hit *hit)
{
    hit->entering = vec3_dot(ray->direction, outside) < 0.0f;
    hit->face_normal = hit->entering ? outside : vec3_negate(outside);
    hit->normal = hit->face_normal;
}

static void fill_flat(const Scene *scene, const Ray *ray, const BvhHit *at, Hit *hit)
{
    const Flat *flat = &scene->flats[at->primitive];
    hit->material = &scene->materials[flat->material];
    // By u and v, which puts the point closer to the surface than origin + t·direction would.
    hit->position = vec3_along(vec3_along(flat->origin, flat->edge_u, at->u), flat->edge_v, at->v);
    set_side(ray, flat->normal, hit);
    if (!flat->normals || material_is_rough(hit->material))
        return;
    Vec3 smooth = interpolated_normal(scene, flat, at);
    smooth = hit->entering ? smooth : vec3_negate(smooth);
    if (vec3_dot(ray->direction, smooth) < 0.0f) // at a silhouette it may face away: then face_normal stays
        hit->normal = smooth;
}

static void fill_sphere(const Scene *scene, const Ray *ray, const BvhHit *at, Hit *hit)
{
    const Sphere *sphere = &scene->spheres[at->primitive - scene->flat_count];
    hit->material = &scene->materials[sphere->material];
    Vec3 from_centre = vec3_sub(vec3_along(ray->origin, ray->direction, at->t), sphere->centre);
    Vec3 outside = vec3_normalize(from_centre);
    hit->position = vec3_along(sphere->centre, outside, sphere->radius);
    set_side(ray, outside, hit);
}

bool scene_intersect(const Scene *scene, const Ray *ray, Hit *hit)
{
    BvhHit at;
    if (!bvh_closest(scene->bvh, ray, nearest_distance(ray->origin), INFINITY, &at))
        return false;
    hit->distance = at.t;
    hit->primitive = at.primitive;
    if (at.primitive < scene->flat_count)
        fill_flat(scene, ray, &at, hit);
    else
        fill_sphere(scene, ray, &at, hit);
    return true;
}

bool scene_occluded(const Scene *scene, const Ray *ray, float distance, const Light *light)
{
    float end = distance * (1.0f - 1e-5f);
    return bvh_occluded(scene->bvh, ray, nearest_distance(ray->origin), end, light->primitive);
}

const char *const integrator_names[] = {"photons", "photons-only", "gather", "path", NULL};

bool integrator_parse(const char *name, Integrator *integrator)
{
    for (int i = 0; integrator_names[i]; i++)
        if (strcmp(name, integrator_names[i]) == 0) {
            *integrator = (Integrator)i;
            return true;
        }
    return false;
}
