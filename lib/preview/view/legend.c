// What the colours mean.
#include "preview/view/view_internal.h"

#include <stdarg.h>
#include <stdio.h>

void legend_add(Legend *legend, Rgba colour, const char *format, ...)
{
    if (legend->count == MOST_ENTRIES)
        return;
    va_list arguments;
    va_start(arguments, format);
    legend->entries[legend->count].colour = colour;
    vsnprintf(legend->entries[legend->count++].text, sizeof legend->entries->text, format, arguments);
    va_end(arguments);
}

void list_wavelengths(Legend *legend)
{
    for (int nm = 650; nm >= 450; nm -= 50)
        legend_add(legend, palette_photon(band_of_wavelength((float)nm)), "%d nm", nm);
}

// Rough ones where photons are stored; all where they fly to.
static void list_materials(const Scene *scene, bool all, Legend *legend)
{
    for (size_t i = 0; i < scene->material_count; i++)
        if (all || material_is_rough(&scene->materials[i]))
            legend_add(legend, palette_material((int)i), "%.24s", scene->materials[i].name);
}

// The colours of photons that have one: power shows them, too.
static void list_hues(const ViewData *data, Legend *legend)
{
    const Recording *recording = &data->recording;
    size_t seen[BAND_FIRST] = {0};
    for (size_t i = 0; i < recording->count && i < 100000; i++)
        if (recording->photons[i].at.colour < BAND_FIRST)
            seen[recording->photons[i].at.colour]++;
    for (int c = RED; c <= BLUE; c++)
        if (seen[c] > 0)
            legend_add(legend, rgba_of_power(colour(c == RED, c == GREEN, c == BLUE), 1.0f), "a %s photon",
                       photon_colour_name(c));
    if (recording->play.loop == LOOP_WAVELENGTH)
        list_wavelengths(legend);
}

static void list_power(const ViewData *data, Legend *legend)
{
    static const float PARTS[3] = {1.0f, 0.3f, 0.1f};
    for (int i = 0; i < 3 && data->recording.count > 0; i++) {
        float power = PARTS[i] * data->power;
        legend_add(legend, rgba_of_power(colour_grey(power), data->power), "%.2g W%s", (double)power,
                   i == 0 ? " or more" : "");
    }
    list_hues(data, legend);
}

static void list_colours(const View *view, const ViewData *data, bool all_materials, Legend *legend)
{
    switch (view->colour) {
    case COLOUR_POWER:
        list_power(data, legend);
        return;
    case COLOUR_PHOTON:
        if (data->recording.play.loop == LOOP_WAVELENGTH) {
            list_wavelengths(legend);
            return;
        }
        for (int i = 0; i < 4; i++)
            legend_add(legend, palette_photon(i), "%s", photon_colour_name(i));
        return;
    case COLOUR_BOUNCE:
        for (int i = 0; i < BOUNCE_COLOURS; i++)
            legend_add(legend, palette_bounce(i), "%s%d%s", i == 0 ? "bounces " : "", i,
                       i == BOUNCE_COLOURS - 1 ? " or more" : "");
        return;
    case COLOUR_MATERIAL:
        list_materials(data->scene, all_materials, legend);
    }
}

void legend_of_photons(const View *view, const ViewData *data, Legend *legend)
{
    list_colours(view, data, false, legend);
}

void legend_of_legs(const View *view, const ViewData *data, Legend *legend)
{
    list_colours(view, data, true, legend);
}
