// Colours and what they stand for.
#include "preview/view/view_internal.h"

#include <stdarg.h>
#include <stdio.h>

const Rgba COLOUR_OF_LIGHTS = {255, 220, 80, 255};
const Rgba COLOUR_OF_TEXT = {232, 236, 242, 255};

Rgba palette_photon(int colour)
{
    // Pure, since points add up: a dense blue spot must not become cyan.
    static const Rgba OF[4] = {{205, 205, 200, 150}, {255, 0, 0, 255}, {0, 235, 0, 255}, {0, 0, 255, 255}};
    if (colour >= BAND_FIRST) {
        Colour hue = spectral_colour(wavelength_of_band(colour));
        return rgba_of_power(hue, fmaxf(colour_max(hue), 0.3f)); // the ends of the spectrum fade
    }
    return OF[colour >= 0 ? colour : 0];
}

const char *photon_colour_name(int colour)
{
    static const char *const NAMES[4] = {"white", "red", "green", "blue"};
    return colour >= 0 && colour < BAND_FIRST ? NAMES[colour] : "of one wavelength";
}

Rgba palette_bounce(int bounce)
{
    static const Rgba OF[BOUNCE_COLOURS] = {{255, 244, 190, 255}, {255, 176, 60, 255}, {255, 96, 80, 255},
                                            {225, 70, 170, 255},  {140, 90, 245, 255}, {70, 140, 255, 255},
                                            {50, 205, 215, 255},  {90, 225, 130, 255}};
    return OF[bounce < 0 ? 0 : bounce < BOUNCE_COLOURS ? bounce : BOUNCE_COLOURS - 1];
}

static uint8_t byte_of(float value)
{
    if (!(value > 0.0f)) // NaN as well
        return 0;
    return value < 1.0f ? (uint8_t)(value * 255.0f + 0.5f) : 255;
}

Rgba palette_hue(float hue)
{
    float six = 6.0f * (hue - floorf(hue));
    float red = fabsf(six - 3.0f) - 1.0f, green = 2.0f - fabsf(six - 2.0f), blue = 2.0f - fabsf(six - 4.0f);
    return (Rgba){byte_of(0.25f + 0.75f * fminf(red, 1.0f) * (red > 0)),
                  byte_of(0.25f + 0.75f * fminf(green, 1.0f) * (green > 0)),
                  byte_of(0.25f + 0.75f * fminf(blue, 1.0f) * (blue > 0)), 255};
}

Rgba palette_material(int material)
{
    static const Rgba OF[8] = {{110, 190, 255, 255}, {255, 120, 90, 255}, {130, 230, 110, 255}, {255, 205, 80, 255},
                               {205, 130, 255, 255}, {80, 225, 205, 255}, {255, 130, 195, 255}, {190, 190, 190, 255}};
    return material < 8 ? OF[material] : palette_hue(0.618034f * (float)material);
}

Rgba rgba_fade(Rgba colour, float alpha)
{
    colour.a = byte_of(alpha * (float)colour.a / 255.0f);
    return colour;
}

// x^0.6 for x of 0...1, from a table: powf takes a third of the time in which a million photons are coloured.
static float brightness(float x)
{
    enum { STEPS = 1024 };
    static float table[STEPS + 1];
    if (table[STEPS] == 0.0f)
        for (int i = 0; i <= STEPS; i++)
            table[i] = powf((float)i / STEPS, 0.6f);
    return table[(int)(x * STEPS + 0.5f)];
}

// Brightness as the eye has it: between linear light, where little would be seen of weak photons, and sRGB, where all
// would look pale.
Rgba rgba_of_power(Colour power, float full)
{
    float scale = full > 0.0f ? 1.0f / full : 0.0f;
    float highest = fmaxf(colour_max(power) * scale, 1e-6f);
    float bright = brightness(fminf(highest, 1.0f)) / highest;
    float red = power.r * scale * bright, green = power.g * scale * bright, blue = power.b * scale * bright;
    float more_blue = fmaxf(blue - fmaxf(red, green), 0.0f); // pure blue is too dark on a screen
    return (Rgba){byte_of(red + 0.2f * more_blue), byte_of(green + 0.32f * more_blue), byte_of(blue), 255};
}

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

void legend_of_wavelengths(const View *view, const ViewData *data, Legend *legend)
{
    (void)view, (void)data;
    for (int nm = 650; nm >= 450; nm -= 50)
        legend_add(legend, palette_photon(band_of_wavelength((float)nm)), "%d nm", nm);
}

// Photons may have colours of their own, which show, too.
static void list_power(const ViewData *data, Legend *legend)
{
    static const float PARTS[3] = {1.0f, 0.3f, 0.1f};
    const Recording *recording = &data->recording;
    for (int i = 0; i < 3 && recording->count > 0; i++) {
        float power = PARTS[i] * data->power;
        legend_add(legend, rgba_of_power(colour_grey(power), data->power), "%.2g W%s", (double)power,
                   i == 0 ? " or more" : "");
    }
    size_t seen[BAND_FIRST] = {0};
    for (size_t i = 0; i < recording->count && i < 100000; i++)
        if (recording->photons[i].at.colour < BAND_FIRST)
            seen[recording->photons[i].at.colour]++;
    for (int c = RED; c <= BLUE; c++)
        if (seen[c] > 0)
            legend_add(legend, rgba_of_power(colour(c == RED, c == GREEN, c == BLUE), 1.0f), "a %s photon",
                       photon_colour_name(c));
}

void legend_of_photons(const View *view, const ViewData *data, Legend *legend)
{
    bool spectral = data->recording.play.loop == LOOP_WAVELENGTH;
    const Scene *scene = data->scene;
    if (view->colour == COLOUR_POWER)
        list_power(data, legend);
    if (spectral && (view->colour == COLOUR_POWER || view->colour == COLOUR_PHOTON))
        legend_of_wavelengths(view, data, legend);
    for (int i = 0; view->colour == COLOUR_PHOTON && !spectral && i < 4; i++)
        legend_add(legend, palette_photon(i), "%s", photon_colour_name(i));
    for (int i = 0; view->colour == COLOUR_BOUNCE && i < BOUNCE_COLOURS; i++)
        legend_add(legend, palette_bounce(i), "%s%d%s", i == 0 ? "bounces " : "", i,
                   i == BOUNCE_COLOURS - 1 ? " or more" : "");
    // Rough ones where photons are stored; all where they fly to.
    for (size_t i = 0; view->colour == COLOUR_MATERIAL && i < scene->material_count; i++)
        if (view->kind == VIEW_PATHS || material_is_rough(&scene->materials[i]))
            legend_add(legend, palette_material((int)i), "%.24s", scene->materials[i].name);
}
