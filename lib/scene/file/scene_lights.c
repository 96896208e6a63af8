#include "scene/file/scene_load.h"

#include <stdio.h>
#include <stdlib.h>

// A Lambertian surface of area A and radiance L sends out Φ = πAL. The file gives one of the two.
static bool set_emission(const SceneLoader *loader, const LightEntry *entry, Light *light)
{
    if (!entry->radiance == !entry->power)
        return loader_fault(loader, NULL, "this light has %s; expected exactly one of radiance and power",
                            entry->radiance ? "both radiance and power" : "neither radiance nor power");
    float power_of_radiance = PI * light->area;
    if (entry->radiance) {
        light->radiance = colour_from_entry(entry->radiance);
        light->power = colour_scale(light->radiance, power_of_radiance);
    } else {
        light->power = colour_from_entry(entry->power);
        light->radiance = colour_scale(light->power, 1.0f / power_of_radiance);
    }
    float most = colour_max(light->radiance);
    if (!(most < 1e18f && colour_max(light->power) < 1e18f))
        return loader_fault(loader, NULL, "this light of %g m² is too bright to reckon with; expected less power",
                            light->area);
    return true;
}

// The light's surface shines by a material of its own, which stands after those of the file.
static bool add_light_material(SceneLoader *loader, Colour radiance, uint32_t *material)
{
    Scene *scene = loader->scene;
    if (scene->material_count == MAX_MATERIALS)
        return loader_fault(loader, NULL,
                            "too many materials: each rectangle or sphere that shines counts as one; "
                            "expected at most %d",
                            MAX_MATERIALS);
    Material *own = &scene->materials[scene->material_count];
    *own = (Material){.type = MATERIAL_LIGHT, .radiance = radiance};
    snprintf(own->name, sizeof own->name, "light %d", loader->index + 1);
    *material = (uint32_t)scene->material_count++;
    return true;
}

static bool build_rectangle(SceneLoader *loader, const LightEntry *entry, Light *light)
{
    light->position = vec3_from_entry(entry->corner);
    light->edge_u = vec3_from_entry(entry->edge_u);
    light->edge_v = vec3_from_entry(entry->edge_v);
    if (!scene_check_edges(loader, "edge_v", light->edge_u, light->edge_v))
        return false;
    Vec3 normal = vec3_cross(light->edge_u, light->edge_v);
    light->area = vec3_length(normal);
    light->direction = vec3_scale(normal, 1.0f / light->area);
    light->primitive = (uint32_t)loader->scene->flat_count;
    Flat flat = {.origin = light->position, .edge_u = light->edge_u, .edge_v = light->edge_v};
    return set_emission(loader, entry, light) && add_light_material(loader, light->radiance, &flat.material) &&
           scene_add_flat(loader, flat);
}

static bool build_sphere(SceneLoader *loader, const LightEntry *entry, Light *light)
{
    light->position = vec3_from_entry(entry->centre);
    light->radius = *entry->radius;
    light->area = 4.0f * PI * light->radius * light->radius;
    light->primitive = (uint32_t)loader->scene->sphere_count;
    Sphere sphere = {.centre = light->position, .radius = light->radius};
    return set_emission(loader, entry, light) && add_light_material(loader, light->radiance, &sphere.material) &&
           scene_add_sphere(loader, sphere);
}

// Spot and beam point from their position to their target.
static bool build_aimed(SceneLoader *loader, const LightEntry *entry, Light *light)
{
    Vec3 way = vec3_sub(vec3_from_entry(entry->target), light->position);
    if (vec3_length(way) < SCENE_SMALLEST_LENGTH)
        return loader_fault(loader, "target", "the target is the light's position; expected another point");
    light->direction = vec3_normalize(way);
    if (light->type == LIGHT_SPOT) {
        light->cos_cone = cosf(*entry->angle * (PI / 180.0f));
        return true;
    }
    light->radius = *entry->radius;
    // Across the beam: start from the axis that is least along it.
    Vec3 d = light->direction;
    bool x_least = fabsf(d.x) <= fabsf(d.y) && fabsf(d.x) <= fabsf(d.z);
    Vec3 axis = x_least ? vec3(1, 0, 0) : fabsf(d.y) <= fabsf(d.z) ? vec3(0, 1, 0) : vec3(0, 0, 1);
    light->edge_u = vec3_normalize(vec3_cross(axis, d));
    light->edge_v = vec3_cross(d, light->edge_u);
    return true;
}

static bool build_light(SceneLoader *loader, const LightEntry *entry, Light *light)
{
    light->type = (LightType)entry->type;
    light->primitive = NO_PRIMITIVE;
    const float *given = entry->power ? entry->power : entry->radiance;
    if (given && colour_max(colour_from_entry(given)) <= 0)
        return loader_fault(loader, entry->power ? "power" : "radiance",
                            "this light is dark; expected a number above 0");
    if (light->type == LIGHT_RECTANGLE)
        return build_rectangle(loader, entry, light);
    if (light->type == LIGHT_SPHERE)
        return build_sphere(loader, entry, light);
    light->position = vec3_from_entry(entry->position);
    light->power = colour_from_entry(entry->power);
    return light->type == LIGHT_POINT || build_aimed(loader, entry, light);
}

bool scene_build_lights(SceneLoader *loader)
{
    Scene *scene = loader->scene;
    size_t count = loader->entries->lights_count;
    loader->section = &light_section;
    loader->index = -1;
    if (count == 0)
        return loader_fault(loader, NULL, "the scene has no lights; expected at least one under 'lights:'");
    scene->lights = calloc(count, sizeof *scene->lights);
    if (!scene->lights)
        return error_set(loader->error, "%s: not enough memory", loader->file);
    scene->light_count = count;
    for (loader->index = 0; loader->index < (int)count; loader->index++)
        if (!build_light(loader, &loader->entries->lights[loader->index], &scene->lights[loader->index]))
            return false;
    return true;
}
