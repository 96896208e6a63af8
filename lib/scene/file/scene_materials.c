#include "scene/file/scene_section.h"

#include "scene/material_kind.h"

#include <stdio.h>
#include <string.h>

// Kind number i of those that a file may ask for.
static const MaterialKind *kind_at(size_t i)
{
    for (size_t k = 0; k < material_kind_count; k++)
        if (material_kinds[k]->scene.name && i-- == 0)
            return material_kinds[k];
    return NULL;
}

static const SceneType *type_at(size_t i)
{
    const MaterialKind *kind = kind_at(i);
    return kind ? &kind->scene : NULL;
}

const char *scene_material_name(const void *file, size_t i)
{
    const Scene *scene = ((const SceneFile *)file)->scene;
    // Those of shining surfaces, which have no kind, stand behind the others.
    return i < scene->material_count && scene->materials[i].kind ? scene->materials[i].name : NULL;
}

static bool build(SceneEntry *entry)
{
    Scene *scene = entry->file->scene;
    const char *name = scene_word(entry, "name");
    for (size_t i = 0; i < scene->material_count; i++)
        if (strcmp(scene->materials[i].name, name) == 0)
            return scene_fault(entry, "name", "a material '%s' stands above already; expected another name", name);
    // Counted before it is built, so that scene_free finds the table of one that failed half-way.
    Material *material = &scene->materials[scene->material_count++];
    snprintf(material->name, sizeof material->name, "%s", name);
    material->kind = kind_at(entry->type_number);
    material->type = material->kind->type;
    return material->kind->build(entry, material);
}

static const SceneKeys keys = {
    {"name", KEY_WORD, KEY_REQUIRED, RANGE_NAME, "what shapes and meshes call it by"},
    {"type", KEY_TYPE, KEY_REQUIRED, RANGE_ANY, "one of the types below"},
};

const SceneSection material_section = {
    "materials", "What surfaces do with light.", MAX_MATERIALS, false, keys, NULL, type_at, build};
