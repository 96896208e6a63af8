// Colours and what they stand for.
#include "preview/view/view_internal.h"

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
