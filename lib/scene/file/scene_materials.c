#include "scene/file/scene_load.h"
#include "scene/material_kind.h"

#include "scene/glass_catalogue.h"
#include "base/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *glass_name(const void *unused, size_t i)
{
    (void)unused;
    const SellmeierGlass *glass = glass_at(i);
    return glass ? glass->name : NULL;
}

static const double wavelengths[3] = {WAVELENGTH_RED, WAVELENGTH_GREEN, WAVELENGTH_BLUE};

static bool catalogue_indices(const SceneLoader *loader, const char *name, Material *material)
{
    const SellmeierGlass *glass = glass_find(name);
    if (!glass) {
        char suggestion[400];
        text_suggest(suggestion, sizeof suggestion, name, glass_name, NULL);
        return loader_fault(loader, "glass", "there is no glass '%s'; %s", name, suggestion);
    }
    for (int c = 0; c < 3; c++)
        material->index[c] = (float)glass_index(glass, wavelengths[c]);
    return true;
}

static bool cauchy_indices(const SceneLoader *loader, const MaterialEntry *entry, Material *material)
{
    for (int c = 0; c < 3; c++) {
        material->index[c] = (float)cauchy_index(*entry->index_d, *entry->abbe, wavelengths[c]);
        if (!(material->index[c] >= 0.1f && material->index[c] <= 10.0f))
            return loader_fault(loader, "abbe",
                                "index_d %g with abbe %g gives the index %g at %.0f nm; expected 0.1 to 10",
                                *entry->index_d, *entry->abbe, material->index[c], wavelengths[c]);
    }
    return true;
}

static bool build_glass(const SceneLoader *loader, const MaterialEntry *entry, Material *material)
{
    bool cauchy = entry->index_d || entry->abbe;
    if (!!entry->index + !!entry->indices + !!entry->glass + cauchy != 1 ||
        (cauchy && !(entry->index_d && entry->abbe)))
        return loader_fault(loader, NULL,
                            "glass '%s' has %s index; expected exactly one of: index, indices, glass, or "
                            "index_d together with abbe",
                            entry->name, cauchy || entry->index || entry->indices || entry->glass ? "no single" : "no");
    if (entry->glass && !catalogue_indices(loader, entry->glass, material))
        return false;
    if (cauchy && !cauchy_indices(loader, entry, material))
        return false;
    for (int c = 0; c < 3 && !entry->glass && !cauchy; c++)
        material->index[c] = entry->index ? *entry->index : entry->indices[c];
    material->disperses = material->index[0] != material->index[1] || material->index[1] != material->index[2];
    return true;
}

static bool build_glossy(const SceneLoader *loader, const MaterialEntry *entry, Material *material)
{
    material->diffuse = colour_from_entry(entry->diffuse);
    material->specular = colour_from_entry(entry->specular);
    material->exponent = *entry->exponent;
    // 0.7 + 0.3 may come out a little above 1 in single precision.
    float most = colour_max(colour_add(material->diffuse, material->specular));
    if (most > 1.000001f)
        return loader_fault(loader, NULL,
                            "diffuse + specular of '%s' is %g in a channel; expected at most 1, or the surface "
                            "would give back more light than it gets",
                            entry->name, most);
    material->lobe = calloc(1, sizeof *material->lobe);
    if (!material->lobe)
        return error_set(loader->error, "%s: not enough memory", loader->file);
    lobe_table_fill(material->lobe, material->exponent);
    return true;
}

static bool build_material(const SceneLoader *loader, const MaterialEntry *entry, Material *material)
{
    snprintf(material->name, sizeof material->name, "%s", entry->name);
    material->kind = material_kinds[entry->type];
    material->type = material->kind->type;
    for (int i = 0; i < loader->index; i++)
        if (strcmp(loader->entries->materials[i].name, entry->name) == 0)
            return loader_fault(loader, "name", "a material '%s' stands above already; expected another name",
                                entry->name);
    switch (material->type) {
    case MATERIAL_DIFFUSE:
        material->diffuse = colour_from_entry(entry->reflectance);
        return true;
    case MATERIAL_MIRROR:
        material->specular = entry->reflectance ? colour_from_entry(entry->reflectance) : colour_grey(1);
        return true;
    case MATERIAL_GLOSSY:
        return build_glossy(loader, entry, material);
    default:
        return build_glass(loader, entry, material);
    }
}

bool scene_build_materials(SceneLoader *loader)
{
    Scene *scene = loader->scene;
    scene->materials = calloc(MAX_MATERIALS, sizeof *scene->materials);
    if (!scene->materials)
        return error_set(loader->error, "%s: not enough memory", loader->file);
    loader->section = &material_section;
    for (loader->index = 0; loader->index < (int)loader->entries->materials_count; loader->index++) {
        // Counted before it is built, so that scene_free finds the table of one that failed half-way.
        Material *material = &scene->materials[scene->material_count++];
        if (!build_material(loader, &loader->entries->materials[loader->index], material))
            return false;
    }
    return true;
}
