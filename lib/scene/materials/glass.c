// Clear glass: what is not reflected goes through.
#include "scene/glass_catalogue.h"
#include "scene/material_kind.h"
#include "base/text.h"

static const double wavelengths[3] = {WAVELENGTH_RED, WAVELENGTH_GREEN, WAVELENGTH_BLUE};

static const char *glass_name(const void *unused, size_t i)
{
    (void)unused;
    const SellmeierGlass *glass = glass_at(i);
    return glass ? glass->name : NULL;
}

static bool catalogue_indices(const SceneEntry *entry, const char *name, Material *material)
{
    const SellmeierGlass *glass = glass_find(name);
    if (!glass)
        return scene_fault(entry, "glass", "there is no glass '%s'; %s", name,
                           text_suggest(name, glass_name, NULL).text);
    material->sellmeier = glass;
    for (int c = 0; c < 3; c++)
        material->index[c] = (float)glass_index(glass, wavelengths[c]);
    return true;
}

static bool cauchy_indices(SceneEntry *entry, float index[3])
{
    float index_d = scene_number(entry, "index_d");
    float abbe = scene_number(entry, "abbe");
    for (int c = 0; c < 3; c++) {
        index[c] = (float)cauchy_index(index_d, abbe, wavelengths[c]);
        if (!(index[c] >= 0.1f && index[c] <= 10.0f))
            return scene_fault(entry, "abbe",
                               "index_d %g with abbe %g gives the index %g at %.0f nm; expected 0.1 to 10",
                               (double)index_d, (double)abbe, (double)index[c], wavelengths[c]);
    }
    return true;
}

static bool build(SceneEntry *entry, Material *material)
{
    float *index = material->index;
    bool one = scene_given(entry, "index");
    bool three = scene_given(entry, "indices");
    bool named = scene_given(entry, "glass");
    bool index_d = scene_given(entry, "index_d");
    bool abbe = scene_given(entry, "abbe");
    int ways = one + three + named + (index_d || abbe);
    if (ways != 1 || index_d != abbe)
        return scene_fault(entry, NULL,
                           "glass '%s' has %s index; expected exactly one of: index, indices, glass, or "
                           "index_d together with abbe",
                           material->name, ways > 0 ? "no single" : "no");
    if (named && !catalogue_indices(entry, scene_word(entry, "glass"), material))
        return false;
    if (abbe && !cauchy_indices(entry, index))
        return false;
    Colour given = one ? colour_grey(scene_number(entry, "index")) : scene_colour(entry, "indices");
    for (int c = 0; c < 3 && (one || three); c++)
        index[c] = colour_channel(given, c);
    material->disperses = index[0] != index[1] || index[1] != index[2];
    double a, b;
    if (abbe)
        cauchy_coefficients(scene_number(entry, "index_d"), scene_number(entry, "abbe"), &a, &b);
    else
        cauchy_through(index, &a, &b);
    material->cauchy[0] = (float)a;
    material->cauchy[1] = (float)b;
    return true;
}

#define RANGE_OF_INDEX RANGE_TOLD(0.1, 10, NULL, "a refractive index, 0.1 to 10")
static const SceneKeys keys = {
    {"index", KEY_NUMBER, KEY_OPTIONAL, RANGE_OF_INDEX, "one refractive index for all colours"},
    {"indices", KEY_COLOUR, KEY_OPTIONAL, RANGE_OF_INDEX, "one for each colour"},
    {"glass", KEY_WORD, KEY_OPTIONAL, RANGE_NAME, "a real glass by its name"},
    {"index_d", KEY_NUMBER, KEY_OPTIONAL, RANGE_OF_INDEX, "with abbe: the index at 587.6 nm"},
    {"abbe", KEY_NUMBER, KEY_OPTIONAL, RANGE_TOLD(1, 1000, NULL, "an Abbe number, 1 to 1000"),
     "the Abbe number: the smaller, the more it disperses"},
};

MATERIAL_KIND(glass) = {
    .scene = {"glass", "glass", "Clear glass. Exactly one of `index`, `indices`, `glass`, or `index_d` with `abbe`.",
              keys, "{name: prism, type: glass, glass: N-SF11}"},
    .build = build,
    .type = MATERIAL_GLASS,
    .optics = OPTICS_GLASS,
    .line = {120, 215, 235, 150},
};
