#include "scene/file/scene_section.h"

#include "base/text.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LARGEST_SCENE_FILE (4u << 20) // bytes; big geometry belongs into a mesh

static bool build_scene(SceneFile *file)
{
    Scene *scene = file->scene = calloc(1, sizeof *scene);
    if (!scene)
        return scene_out_of_memory(file);
    scene->materials = calloc(MAX_MATERIALS, sizeof *scene->materials);
    scene->lights = calloc(MAX_LIGHTS, sizeof *scene->lights);
    scene->spheres = calloc(file->entry_count, sizeof *scene->spheres); // an entry makes one at most
    if (!scene->materials || !scene->lights || !scene->spheres)
        return scene_out_of_memory(file);
    for (int i = 0; i < SCENE_SECTIONS; i++)
        for (size_t e = 0; e < file->entry_count; e++) {
            SceneEntry *entry = &file->entries[e];
            if (entry->section == scene_sections[i] && !(scene_sections[i]->build(entry) && scene_check_use(entry)))
                return false;
        }
    // Spheres are counted after the flats, whose number is known only now.
    for (size_t i = 0; i < scene->light_count; i++)
        if (scene->lights[i].type == LIGHT_SPHERE)
            scene->lights[i].primitive += (uint32_t)scene->flat_count;
    for (size_t i = 0; i < scene->flat_count; i++)
        scene->flats[i].normal = vec3_normalize(vec3_cross(scene->flats[i].edge_u, scene->flats[i].edge_v));
    scene->bvh = bvh_build(scene->flats, scene->flat_count, scene->spheres, scene->sphere_count, file->error);
    return scene->bvh || error_set(file->error, "%s: not enough memory for the hierarchy", file->name);
}

Scene *scene_load_text(const char *text, size_t size, const char *name, const char *folder, Error *error)
{
    SceneFile file = {.name = name, .error = error, .folder = folder};
    bool fine = scene_read(text, size, &file) && build_scene(&file);
    scene_file_free(&file);
    if (fine)
        return file.scene;
    scene_free(file.scene);
    return NULL;
}

Scene *scene_load(const char *path, Error *error)
{
    size_t size = 0;
    char *text = text_read_file(path, LARGEST_SCENE_FILE, &size, error);
    if (!text)
        return NULL;
    const char *slash = strrchr(path, '/');
    char folder[PATH_MAX];
    snprintf(folder, sizeof folder, "%.*s", slash ? (int)(slash - path) + 1 : 0, path);
    Scene *scene = scene_load_text(text, size, path, folder, error);
    free(text);
    return scene;
}
