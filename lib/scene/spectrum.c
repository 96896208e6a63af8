#include "scene/spectrum.h"
#include "base/text.h"

#include <math.h>
#include <string.h>

#define SODIUM_LINE 589.3f

// Tables have a row for every 10 nm, from WAVELENGTH_FIRST on.
#define STEP_NM 10.0f
#define ROWS    36

// CIE standard illuminant D65, relative energy (ISO/CIE 11664-2).
static const float daylight[ROWS] = {
    49.98f,  54.65f,  82.75f,  91.49f,  93.43f,  86.68f,  104.86f, 117.01f, 117.81f, 114.86f, 115.92f, 108.81f,
    109.35f, 107.80f, 104.79f, 107.69f, 104.41f, 104.05f, 100.00f, 96.33f,  95.79f,  88.69f,  90.01f,  89.60f,
    87.70f,  83.29f,  83.70f,  80.03f,  80.21f,  82.28f,  78.28f,  69.72f,  71.61f,  74.35f,  61.60f,  69.89f,
};

// What a red and a blue wall reflect; a green one has the rest to 1. build/reflectances computes them (make spectra).
static const float red_wall[ROWS] = {
    0.07068f, 0.07171f, 0.07520f, 0.07905f, 0.07545f, 0.06056f, 0.03965f, 0.01191f, 0.0f,
    0.0f,     0.0f,     0.0f,     0.0f,     0.0f,     0.0f,     0.0f,     0.0f,     0.0f,
    0.0f,     0.0f,     0.16159f, 0.57189f, 0.91172f, 1.00000f, 1.00000f, 1.00000f, 1.00000f,
    1.00000f, 1.00000f, 1.00000f, 1.00000f, 1.00000f, 0.99929f, 0.99800f, 0.99728f, 0.99709f,
};
static const float blue_wall[ROWS] = {
    0.92865f, 0.92791f, 0.92480f, 0.92095f, 0.92455f, 0.93944f, 0.96035f, 0.98809f, 0.97336f,
    0.86415f, 0.69377f, 0.49636f, 0.30223f, 0.13762f, 0.02863f, 0.0f,     0.0f,     0.0f,
    0.0f,     0.04209f, 0.06538f, 0.00531f, 0.0f,     0.0f,     0.0f,     0.0f,     0.0f,
    0.0f,     0.0f,     0.0f,     0.0f,     0.0f,     0.00008f, 0.00056f, 0.00085f, 0.00093f,
};

// Between the rows of a table.
static float table_at(const float table[ROWS], float wavelength)
{
    float place = fminf(fmaxf((wavelength - WAVELENGTH_FIRST) / STEP_NM, 0.0f), ROWS - 1.0f);
    int row = place < ROWS - 2.0f ? (int)place : ROWS - 2;
    float part = place - (float)row;
    return table[row] * (1.0f - part) + table[row + 1] * part;
}

float reflectance_at(Colour reflectance, float wavelength)
{
    float red = table_at(red_wall, wavelength);
    float blue = table_at(blue_wall, wavelength);
    return reflectance.r * red + reflectance.g * (1.0f - red - blue) + reflectance.b * blue;
}

static float lobe(float wavelength, float middle, float below, float above)
{
    float offset = (wavelength - middle) / (wavelength < middle ? below : above);
    return expf(-0.5f * offset * offset);
}

Colour spectral_colour(float w)
{
    float x = 1.056f * lobe(w, 599.8f, 37.9f, 31.0f) + 0.362f * lobe(w, 442.0f, 16.0f, 26.7f) -
              0.065f * lobe(w, 501.1f, 20.4f, 26.2f);
    float y = 0.821f * lobe(w, 568.8f, 46.9f, 40.5f) + 0.286f * lobe(w, 530.9f, 16.3f, 31.1f);
    float z = 1.217f * lobe(w, 437.0f, 11.8f, 36.0f) + 0.681f * lobe(w, 459.0f, 26.0f, 13.8f);
    return colour((3.2406f * x - 1.5372f * y - 0.4986f * z) / EQUAL_ENERGY_RED,
                  (-0.9689f * x + 1.8758f * y + 0.0415f * z) / EQUAL_ENERGY_GREEN,
                  (0.0557f * x - 0.2040f * y + 1.0570f * z) / EQUAL_ENERGY_BLUE);
}

// What entry i counts in a mean over the range.
static float grid_share(int i)
{
    return (i == 0 || i == SPECTRUM_SIZE - 1 ? 0.5f : 1.0f) / (SPECTRUM_SIZE - 1);
}

float spectrum_at(const Spectrum *spectrum, float wavelength)
{
    if (!spectrum || spectrum->line > 0.0f)
        return 1.0f;
    float place = fminf(fmaxf(wavelength - WAVELENGTH_FIRST, 0.0f), SPECTRUM_SIZE - 1.0f);
    int i = place < SPECTRUM_SIZE - 2.0f ? (int)place : SPECTRUM_SIZE - 2;
    float part = place - (float)i;
    return spectrum->value[i] * (1.0f - part) + spectrum->value[i + 1] * part;
}

Colour spectrum_colour(const Spectrum *spectrum, Colour power, Colour filter)
{
    if (spectrum && spectrum->line > 0.0f)
        return colour_scale(spectral_colour(spectrum->line),
                            reflectance_at(power, spectrum->line) * reflectance_at(filter, spectrum->line));
    Colour sum = colour_grey(0.0f);
    for (int i = 0; i < SPECTRUM_SIZE; i++) {
        float wavelength = WAVELENGTH_FIRST + (float)i;
        float energy = spectrum_at(spectrum, wavelength) * reflectance_at(power, wavelength);
        float passed = energy * reflectance_at(filter, wavelength) * grid_share(i);
        sum = colour_add(sum, colour_scale(spectral_colour(wavelength), passed));
    }
    return sum;
}

static const char **skip_blanks(const char **at)
{
    *at += strspn(*at, " ");
    return at;
}

// "nm energy, nm energy, …"
static bool parse_pairs(const char *text, Spectrum *spectrum, const char **why)
{
    const char *end = text + strlen(text);
    double nm, energy, before_nm = 0.0, before = 0.0;
    int pairs = 0;
    for (; text_number(&text, end, &nm) && text_number(skip_blanks(&text), end, &energy); pairs++) {
        *why = "its wavelengths must rise from pair to pair, and energies be 0 or more";
        if (!(nm > before_nm && nm < 1e5 && energy >= 0.0 && energy < 1e9))
            return false;
        for (int i = 0; i < SPECTRUM_SIZE; i++) {
            double at = (double)WAVELENGTH_FIRST + i;
            if (pairs > 0 && at >= before_nm && at <= nm)
                spectrum->value[i] = (float)(before + (energy - before) * (at - before_nm) / (nm - before_nm));
        }
        before_nm = nm;
        before = energy;
        if (**skip_blanks(&text) == ',')
            text++;
        skip_blanks(&text);
    }
    *why = "expected daylight, sodium, one line's nm, or pairs as in 400 0, 700 1";
    return pairs >= 2 && *text == '\0';
}

// Divides by the mean.
static bool normalise(Spectrum *spectrum, const char **why)
{
    float mean = 0.0f;
    for (int i = 0; i < SPECTRUM_SIZE; i++)
        mean += spectrum->value[i] * grid_share(i);
    *why = "it has no energy between 380 and 730 nm";
    for (int i = 0; i < SPECTRUM_SIZE && mean > 0.0f; i++)
        spectrum->value[i] /= mean;
    return mean > 0.0f;
}

bool spectrum_parse(const char *text, Spectrum *spectrum, const char **why)
{
    *spectrum = (Spectrum){0};
    double line = (double)SODIUM_LINE;
    const char *at = text;
    if (strcmp(text, "sodium") == 0 || (text_number(&at, text + strlen(text), &line) && *at == '\0')) {
        spectrum->line = (float)line;
        *why = "a line lies between 380 and 730 nm";
        return line >= (double)WAVELENGTH_FIRST && line <= (double)WAVELENGTH_LAST;
    }
    if (strcmp(text, "daylight") != 0)
        return parse_pairs(text, spectrum, why) && normalise(spectrum, why);
    for (int i = 0; i < SPECTRUM_SIZE; i++)
        spectrum->value[i] = table_at(daylight, WAVELENGTH_FIRST + (float)i);
    return normalise(spectrum, why);
}
