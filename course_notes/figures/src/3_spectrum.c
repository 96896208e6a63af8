// The prism of scenes/prism.yaml throws its beam on a screen 0.5 m behind: by three photons, and by a spectrum.
//   3_spectrum OUT.png
// Four strips: a beam of 6 mm by three indices and by all wavelengths, a beam of 0.6 mm the same. Each strip is exposed
// by itself. Both kinds of beam have the same white: the channels of the whole beam are equal.
#include "3_matching.h"
#include "3_prism.h"

enum { WIDTH = 512, STRIP = 72, GAP = 8, STRIPS = 4, FIRST_NM = 380, LAST_NM = 720 };

#define SCREEN_MM 500.0
#define LEFT_MM   (-24.0)
#define RIGHT_MM  64.0

// Where on the screen, mm from green; towards the base is to the right.
static double place(double wavelength_nm)
{
    double green = prism_deviation(index_of("N-SF11", WAVELENGTH_GREEN), 63.5935);
    double turned = prism_deviation(index_of("N-SF11", wavelength_nm), 63.5935);
    return SCREEN_MM * tan((turned - green) / DEGREES);
}

// Adds a round spot of this colour about x to the strip's rows.
static void add_spot(Image *image, int strip, double x, double radius, const double rgb[3])
{
    double mm = (RIGHT_MM - LEFT_MM) / WIDTH; // of a pixel
    for (int row = 0; row < STRIP; row++)
        for (int column = 0; column < WIDTH; column++) {
            double dx = LEFT_MM + (column + 0.5) * mm - x, dy = (row + 0.5 - STRIP / 2) * mm;
            // A soft edge of one pixel, so that thin beams do not fall between pixels; thin ones are drawn as lines.
            double away = radius < 1.0 ? fabs(dx) : hypot(dx, dy);
            double cover = fmin(fmax((radius - away) / mm + 0.5, 0.0), 1.0);
            Colour *pixel = image_at(image, column, strip * (STRIP + GAP) + row);
            *pixel =
                colour_add(*pixel, colour((float)(cover * rgb[0]), (float)(cover * rgb[1]), (float)(cover * rgb[2])));
        }
}

static void draw_three(Image *image, int strip, double radius)
{
    const double bands[3] = {WAVELENGTH_RED, WAVELENGTH_GREEN, WAVELENGTH_BLUE};
    for (int c = 0; c < 3; c++) {
        double rgb[3] = {c == 0, c == 1, c == 2};
        add_spot(image, strip, place(bands[c]), radius, rgb);
    }
}

static void draw_spectrum(Image *image, int strip, double radius)
{
    double sum[3] = {0, 0, 0}, xyz[3], rgb[3];
    for (double nm = FIRST_NM; nm <= LAST_NM; nm += 0.25) {
        matching_xyz(nm, xyz);
        xyz_to_srgb(xyz, rgb);
        for (int c = 0; c < 3; c++)
            sum[c] += rgb[c];
    }
    for (double nm = FIRST_NM; nm <= LAST_NM; nm += 0.25) {
        matching_xyz(nm, xyz);
        xyz_to_srgb(xyz, rgb);
        for (int c = 0; c < 3; c++)
            rgb[c] /= sum[c];
        add_spot(image, strip, place(nm), radius, rgb);
    }
}

// Negative channels are colours that no sRGB screen can show: cut. Then the strip's brightest channel becomes 1.
static void expose(Image *image, int strip)
{
    float brightest = 0.0f;
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < STRIP * WIDTH; i++) {
            Colour *pixel = &image->pixels[strip * (STRIP + GAP) * WIDTH + i];
            if (pass == 0)
                brightest = fmaxf(brightest, colour_max(*pixel));
            else
                *pixel = colour(fmaxf(pixel->r, 0.0f) / brightest, fmaxf(pixel->g, 0.0f) / brightest,
                                fmaxf(pixel->b, 0.0f) / brightest);
        }
}

int main(int count, char **arguments)
{
    Error error = {""};
    Image image;
    load_reference_steps();
    if (count != 2 || !image_create(&image, WIDTH, STRIPS * (STRIP + GAP) - GAP, &error))
        return fprintf(stderr, "usage: 3_spectrum OUT.png\n"), 2;
    for (int strip = 0; strip < STRIPS; strip++) {
        double radius = strip < 2 ? 3.0 : 0.3;
        if (strip % 2 == 0)
            draw_three(&image, strip, radius);
        else
            draw_spectrum(&image, strip, radius);
        expose(&image, strip);
        for (int i = 0; i < GAP * WIDTH && strip + 1 < STRIPS; i++)
            image.pixels[(strip * (STRIP + GAP) + STRIP) * WIDTH + i] = colour_grey(1.0f);
    }
    if (image_write(&image, arguments[1], &error))
        return 0;
    fprintf(stderr, "%s\n", error.message);
    return 1;
}
