// What can be said of an entry without looking at others: its keys and the range of each number.
#include "scene/file/scene_load.h"

#include <stdio.h>
#include <string.h>

typedef struct {
    const char *section; // NULL: any
    const char *keys;    // between single spaces
    double low, high;
    bool open; // low and high themselves are refused
    const char *expected;
} NumberRule;

static const NumberRule rules[] = {
    {"render", "width height", 1, MOST_SIDE, false, "1 to 16384 pixels"},
    {"render", "samples", 1, MOST_SAMPLES, false, "1 to 1000000 rays per pixel"},
    {"render", "photons", 1, MOST_PHOTONS, false, "1 to 1000000000 photons"},
    {"render", "k", 1, MOST_K, false, "1 to 1000000 photons"},
    {"render", "radius", 0, 1e9, false, "a length in metres, or 0 for no limit"},
    {"render", "depth", 1, MOST_DEPTH, false, "1 to 1000 bounces"},
    {NULL, "radius scale side length", SCENE_SMALLEST_LENGTH, 1e9, false, "a number greater than 0 (from 1e-9)"},
    {NULL, "vertical_fov angle", 0, 180, true, "an angle between 0 and 180 degrees"},
    {NULL, "reflectance diffuse specular", 0, 1, false, "0 to 1"},
    {NULL, "radiance power", 0, 1e9, false, "0 or more"},
    {NULL, "exponent", 0, 10000, false, "0 to 10000"},
    {NULL, "index indices index_d", 0.1, 10, false, "a refractive index, 0.1 to 10"},
    {NULL, "abbe", 1, 1000, false, "an Abbe number, 1 to 1000"},
};

// Does `keys` hold `key`, as a whole word?
static bool has_key(const char *keys, const char *key)
{
    size_t length = strlen(key);
    for (const char *at = keys; (at = strstr(at, key)); at += length)
        if ((at == keys || at[-1] == ' ') && (at[length] == ' ' || at[length] == '\0'))
            return true;
    return false;
}

static const NumberRule *find_rule(const char *section, const char *key)
{
    for (size_t i = 0; i < sizeof rules / sizeof rules[0]; i++)
        if ((!rules[i].section || strcmp(rules[i].section, section) == 0) && has_key(rules[i].keys, key))
            return &rules[i];
    return NULL;
}

// Where the entry keeps the value of a key; NULL when the file does not give it.
static const void *field_value(const cyaml_schema_field_t *field, const void *entry)
{
    const void *value;
    memcpy(&value, (const char *)entry + field->data_offset, sizeof value);
    return value;
}

static bool in_range(const NumberRule *rule, double value)
{
    return rule->open ? value > rule->low && value < rule->high : value >= rule->low && value <= rule->high;
}

static bool check_numbers(const SceneLoader *loader, const cyaml_schema_field_t *field, const void *value)
{
    const NumberRule *rule = find_rule(loader->section->name, field->key);
    if (!rule)
        return true;
    if (field->value.type == CYAML_INT) {
        long whole = field->value.data_size == sizeof(int) ? *(const int *)value : *(const long *)value;
        return in_range(rule, (double)whole) ||
               loader_fault(loader, field->key, "%s is %ld; expected %s", field->key, whole, rule->expected);
    }
    if (field->value.type == CYAML_FLOAT)
        return in_range(rule, *(const float *)value) || loader_fault(loader, field->key, "%s is %g; expected %s",
                                                                     field->key, *(const float *)value, rule->expected);
    for (int i = 0; i < 3; i++) {
        char key[64];
        snprintf(key, sizeof key, "%s[%d]", field->key, i);
        float number = ((const float *)value)[i];
        if (!in_range(rule, number))
            return loader_fault(loader, key, "%s is %g; expected %s", field->key, number, rule->expected);
    }
    return true;
}

static bool validate_entry(const SceneLoader *loader, const void *entry)
{
    const cyaml_schema_field_t *field = loader->section->fields;
    const TypeKeys *keys = loader->section->keys ? &loader->section->keys[*(const int *)entry] : NULL;
    for (; field->key; field++) {
        if (!(field->value.flags & CYAML_FLAG_POINTER))
            continue; // `type` itself
        const void *value = field_value(field, entry);
        bool belongs = !keys || !(field->value.flags & CYAML_FLAG_OPTIONAL) || has_key(keys->required, field->key) ||
                       has_key(keys->optional, field->key);
        if (value && !belongs)
            return loader_fault(loader, field->key, "a %s has no '%s'; its keys are: %s%s%s", keys->type, field->key,
                                keys->required, keys->required[0] && keys->optional[0] ? " " : "", keys->optional);
        if (!value && keys && has_key(keys->required, field->key))
            return loader_fault(loader, NULL, "this %s has no '%s'; expected the keys: %s", keys->type, field->key,
                                keys->required);
        if (value && field->value.type != CYAML_STRING && !check_numbers(loader, field, value))
            return false;
    }
    return true;
}

static bool validate_list(SceneLoader *loader, const SceneSection *section, const void *list, size_t stride,
                          size_t count)
{
    loader->section = section;
    for (loader->index = 0; loader->index < (int)count; loader->index++)
        if (!validate_entry(loader, (const char *)list + (size_t)loader->index * stride))
            return false;
    return true;
}

bool scene_validate(SceneLoader *loader)
{
    const SceneEntries *entries = loader->entries;
    loader->index = -1;
    loader->section = &camera_section;
    if (!validate_entry(loader, entries->camera))
        return false;
    loader->section = &render_section;
    if (entries->render && !validate_entry(loader, entries->render))
        return false;
    return validate_list(loader, &material_section, entries->materials, sizeof(MaterialEntry),
                         entries->materials_count) &&
           validate_list(loader, &light_section, entries->lights, sizeof(LightEntry), entries->lights_count) &&
           validate_list(loader, &shape_section, entries->shapes, sizeof(ShapeEntry), entries->shapes_count);
}
