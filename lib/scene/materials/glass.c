// Clear glass: what is not reflected goes through.
#include "scene/glass_catalogue.h"
#include "scene/material_kind.h"
#include "base/text.h"

static const char *glass_name(const void *unused, size_t i)
{
    (void)unused;
    const SellmeierGlass *glass = glass_at(i);
    return glass ? glass->name : NULL;
}

// The three indices, by whichever of the four ways the file gives; what it does not give is NULL or 0.
static bool read_indices(SceneEntry *entry, Material *material)
{
    static const double wavelengths[3] = {WAVELENGTH_RED, WAVELENGTH_GREEN, WAVELENGTH_BLUE};
    const char *name = scene_word(entry, "glass");
    bool one = scene_given(entry, "index");
    Colour given = one ? colour_grey(scene_number(entry, "index")) : scene_colour(entry, "indices");
    double index_d = (double)scene_number(entry, "index_d"), abbe = (double)scene_number(entry, "abbe");
    material->sellmeier = name ? glass_find(name) : NULL;
    if (name && !material->sellmeier)
        return scene_fault(entry, "glass", "there is no glass '%s'; %s", name,
                           text_suggest(name, glass_name, NULL).text);
    for (int c = 0; c < 3; c++) {
        float *index = &material->index[c];
        *index = name       ? (float)glass_index(material->sellmeier, wavelengths[c])
                 : abbe > 0 ? (float)cauchy_index(index_d, abbe, wavelengths[c])
                            : colour_channel(given, c);
        if (abbe > 0 && !(*index >= 0.1f && *index <= 10.0f))
            return scene_fault(entry, "abbe",
                               "index_d %g with abbe %g gives the index %g at %.0f nm; expected 0.1 to 10", index_d,
                               abbe, *index, wavelengths[c]);
    }
    return true;
}

static bool build(SceneEntry *entry, Material *material)
{
    bool index_d = scene_given(entry, "index_d"), abbe = scene_given(entry, "abbe");
    int ways =
        scene_given(entry, "index") + scene_given(entry, "indices") + scene_given(entry, "glass") + (index_d || abbe);
    if (ways != 1 || index_d != abbe)
        return scene_fault(entry, NULL,
                           "glass '%s' has %s index; expected exactly one of: index, indices, glass, or "
                           "index_d together with abbe",
                           material->name, ways > 0 ? "no single" : "no");
    if (!read_indices(entry, material))
        return false;
    const float *index = material->index;
    material->disperses = index[0] != index[1] || index[1] != index[2];
    double a, b;
    if (abbe)
        cauchy_coefficients((double)scene_number(entry, "index_d"), (double)scene_number(entry, "abbe"), &a, &b);
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
