#include "scene/file/scene_load.h"

#include "base/text.h"
#include "scene/file/scene_read.h"

#include <stdlib.h>
#include <string.h>

#define LARGEST_SCENE_FILE (4u << 20) // bytes; big geometry belongs into a mesh

static bool build_scene(SceneBuilder *builder, const SceneList lists[SCENE_SECTIONS])
{
    Scene *scene = builder->scene;
    scene->materials = calloc(MAX_MATERIALS, sizeof *scene->materials);
    if (!scene->materials)
        return error_set(builder->source.error, "%s: not enough memory", builder->source.file);
    for (int i = 0; i < SCENE_SECTIONS; i++)
        for (size_t e = 0; e < lists[i].count; e++)
            if (!scene_sections[i]->build(builder, &lists[i].entries[e]) || !scene_check_use(&lists[i].entries[e]))
                return false;
    // Spheres are counted after the flats, whose number is known only now.
    for (size_t i = 0; i < scene->light_count; i++)
        if (scene->lights[i].type == LIGHT_SPHERE)
            scene->lights[i].primitive += (uint32_t)scene->flat_count;
    scene->bvh = bvh_build(scene->flats, scene->flat_count, scene->spheres, scene->sphere_count, builder->source.error);
    return scene->bvh ||
           error_set(builder->source.error, "%s: not enough memory for the hierarchy", builder->source.file);
}

Scene *scene_load_text(const char *text, size_t size, const char *file, const char *folder, Error *error)
{
    SceneList lists[SCENE_SECTIONS] = {{.given = false}};
    SceneBuilder builder = {.source = {file, error}, .folder = folder};
    if (scene_read(text, size, &builder.source, lists)) {
        builder.scene = calloc(1, sizeof *builder.scene);
        if (!builder.scene)
            error_set(error, "%s: not enough memory", file);
        else if (!build_scene(&builder, lists)) {
            scene_free(builder.scene);
            builder.scene = NULL;
        }
    }
    scene_lists_free(lists);
    return builder.scene;
}

// What stands in a path before the file's name, with its last slash; the caller frees it.
static char *folder_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    size_t length = slash ? (size_t)(slash - path) + 1 : 0;
    char *folder = malloc(length + 1);
    if (folder) {
        memcpy(folder, path, length);
        folder[length] = '\0';
    }
    return folder;
}

Scene *scene_load(const char *path, Error *error)
{
    size_t size = 0;
    char *text = text_read_file(path, LARGEST_SCENE_FILE, &size, error);
    char *folder = text ? folder_of(path) : NULL;
    Scene *scene = folder ? scene_load_text(text, size, path, folder, error) : NULL;
    if (text && !folder)
        error_set(error, "%s: not enough memory", path);
    free(folder);
    free(text);
    return scene;
}
