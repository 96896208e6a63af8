// Feeds the scene loader with whatever libFuzzer thinks of. It must come back with a scene or with a message, and never
// crash, hang or leak. Meshes are not read.
#include "fuzz/fuzz.h"
#include "scene/scene.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (size == 0)
        return 0;
    Error error = {""};
    Scene *scene = scene_load_text((const char *)data, size, "fuzz.yaml", NULL, &error);
    require(scene ? error.message[0] == '\0' : error.message[0] != '\0');
    if (!scene)
        return 0;
    for (size_t i = 0; i < scene->flat_count; i++)
        require(scene->flats[i].material < scene->material_count);
    for (size_t i = 0; i < scene->light_count; i++) {
        const Light *light = &scene->lights[i];
        require(isfinite(colour_sum(light->power)) && isfinite(colour_sum(light->radiance)));
        require(light->primitive == NO_PRIMITIVE || light->primitive < scene->flat_count + scene->sphere_count);
    }
    Ray ray = camera_ray(&scene->camera, 0.3f, 0.6f, 1.5f);
    require(fabsf(vec3_length(ray.direction) - 1.0f) < 1e-3f);
    Hit hit;
    if (scene_intersect(scene, &ray, &hit))
        require(hit.distance > 0);
    scene_free(scene);
    return 0;
}
