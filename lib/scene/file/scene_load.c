#include "scene/file/scene_load.h"

#include "scene/file/scene_locate.h"
#include "base/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LARGEST_SCENE_FILE (4u << 20) // bytes; big geometry belongs into a mesh

bool loader_fault(const SceneLoader *loader, const char *key, const char *format, ...)
{
    char path[128], what[700];
    const char *section = loader->section ? loader->section->name : "";
    int used = loader->index < 0 ? snprintf(path, sizeof path, "%s", section)
                                 : snprintf(path, sizeof path, "%s[%d]", section, loader->index);
    if (key)
        snprintf(path + used, sizeof path - (size_t)used, ".%s", key);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    text_make_printable(what);
    size_t line, column;
    scene_locate(loader->text, loader->size, path, &line, &column);
    return error_set(loader->error, "%s:%zu:%zu: %s", loader->file, line, column, what);
}

// scene_check_text has found every fault that libcyaml can find; should it find another, its own words are
// the best there are.
static void keep_message(cyaml_log_t level, void *context, const char *format, va_list arguments)
{
    char *message = context;
    (void)level;
    if (!message[0])
        vsnprintf(message, 200, format, arguments);
    message[strcspn(message, "\n")] = '\0';
}

static cyaml_config_t cyaml_settings(char *message)
{
    return (cyaml_config_t){
        .log_fn = keep_message,
        .log_ctx = message,
        .mem_fn = cyaml_mem,
        .log_level = CYAML_LOG_WARNING,
        .flags = CYAML_CFG_NO_ALIAS,
    };
}

static SceneEntries *read_entries(const char *text, size_t size, const char *file, Error *error)
{
    if (!scene_check_text(text, size, file, error))
        return NULL;
    char message[200] = "";
    cyaml_config_t settings = cyaml_settings(message);
    cyaml_data_t *entries = NULL;
    cyaml_err_t result = cyaml_load_data((const uint8_t *)text, size, &settings, &scene_schema, &entries, NULL);
    if (result != CYAML_OK)
        error_set(error, "%s:1:1: %s (%s)", file, cyaml_strerror(result), message);
    return entries;
}

bool scene_build_camera(SceneLoader *loader)
{
    const CameraEntry *entry = loader->entries->camera;
    loader->section = &camera_section;
    loader->index = -1;
    Vec3 position = vec3_from_entry(entry->position), target = vec3_from_entry(entry->target);
    Vec3 up = entry->up ? vec3_from_entry(entry->up) : vec3(0, 1, 0);
    Vec3 view = vec3_sub(target, position);
    if (vec3_length(view) < SCENE_SMALLEST_LENGTH)
        return loader_fault(loader, "target", "the target is the camera's position; expected another point");
    if (flat_is_degenerate(view, up))
        return loader_fault(loader, entry->up ? "up" : NULL,
                            "up (%g, %g, %g) is zero or along the view; expected another direction", up.x, up.y, up.z);
    loader->scene->camera = camera_create(position, target, up, *entry->vertical_fov);
    return true;
}

static RenderSettings render_settings(const RenderEntry *entry)
{
    RenderSettings settings = {512, 512, 4, 500000, 100, 0, 32};
    if (!entry)
        return settings;
    settings.width = entry->width ? *entry->width : settings.width;
    settings.height = entry->height ? *entry->height : settings.height;
    settings.samples = entry->samples ? *entry->samples : settings.samples;
    settings.photons = entry->photons ? *entry->photons : settings.photons;
    settings.k = entry->k ? *entry->k : settings.k;
    settings.radius = entry->radius ? *entry->radius : settings.radius;
    settings.depth = entry->depth ? *entry->depth : settings.depth;
    return settings;
}

static bool build_scene(SceneLoader *loader)
{
    Scene *scene = loader->scene;
    scene->settings = render_settings(loader->entries->render);
    if (!scene_validate(loader) || !scene_build_camera(loader) || !scene_build_materials(loader) ||
        !scene_build_lights(loader) || !scene_build_shapes(loader))
        return false;
    // Spheres are counted after the flats, whose number is known only now.
    for (size_t i = 0; i < scene->light_count; i++)
        if (scene->lights[i].type == LIGHT_SPHERE)
            scene->lights[i].primitive += (uint32_t)scene->flat_count;
    scene->bvh = bvh_build(scene->flats, scene->flat_count, scene->spheres, scene->sphere_count, loader->error);
    return scene->bvh || error_set(loader->error, "%s: not enough memory for the hierarchy", loader->file);
}

Scene *scene_load_text(const char *text, size_t size, const char *file, const char *folder, Error *error)
{
    SceneEntries *entries = read_entries(text, size, file, error);
    if (!entries)
        return NULL;
    SceneLoader loader = {
        .file = file, .text = text, .size = size, .folder = folder, .entries = entries, .error = error};
    loader.scene = calloc(1, sizeof *loader.scene);
    if (!loader.scene)
        error_set(error, "%s: not enough memory", file);
    else if (!build_scene(&loader)) {
        scene_free(loader.scene);
        loader.scene = NULL;
    }
    char message[200] = "";
    cyaml_config_t settings = cyaml_settings(message);
    cyaml_free(&settings, &scene_schema, entries, 0);
    return loader.scene;
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
