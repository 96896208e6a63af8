// What is to be looked at: histograms as SVG, pictures as PNG, both inside the page.
#include "base/file.h"
#include "report.h"

#include "image/difference.h"
#include "image/image.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define WIDTH  480.0 // of a histogram, in the SVG's own units
#define HEIGHT 150.0

static double or_zero(double x)
{
    return x > 0.0 && x < 1e300 ? x : 0.0; // NaN and infinity draw nothing
}

static double tallest(const ReportHistogram *histogram)
{
    double most = 0.0;
    for (size_t i = 0; i < histogram->bins; i++)
        most = fmax(most, fmax(or_zero(histogram->observed[i]), or_zero(histogram->expected[i])));
    return most > 0.0 ? most : 1.0;
}

// The bars, then the density's steps over them.
static void draw_bins(const ReportHistogram *histogram, FILE *stream)
{
    double scale = (HEIGHT - 6.0) / tallest(histogram), step = WIDTH / (double)histogram->bins;
    for (size_t i = 0; i < histogram->bins; i++) {
        double height = or_zero(histogram->observed[i]) * scale;
        fprintf(stream, "<rect x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" height=\"%.2f\"/>", step * ((double)i + 0.06),
                HEIGHT - height, step * 0.88, height);
    }
    fputs("<path d=\"", stream);
    for (size_t i = 0; i < histogram->bins; i++) {
        double y = HEIGHT - or_zero(histogram->expected[i]) * scale;
        fprintf(stream, "%s%.2f %.2fH%.2f", i == 0 ? "M" : "L", step * (double)i, y, step * (double)(i + 1));
    }
    fputs("\"/>", stream);
}

void html_histogram(const ReportHistogram *histogram, FILE *stream)
{
    text_put(stream,
             "<figure class=\"histogram\"><figcaption>%s <span class=\"key\"><i class=\"bar\"></i> found "
             "<i class=\"line\"></i> expected</span></figcaption>\n",
             histogram->title);
    fprintf(stream, "<svg viewBox=\"0 0 %g %g\" role=\"img\" preserveAspectRatio=\"none\">", WIDTH, HEIGHT);
    text_put(stream, "<title>%s: what your code gave, and what the equation says</title>", histogram->title);
    draw_bins(histogram, stream);
    fputs("</svg>\n", stream);
    if (isfinite(histogram->low) && isfinite(histogram->high))
        fprintf(stream, "<div class=\"axis\"><span>%g</span><span>%g</span><span>%g</span></div>", histogram->low,
                0.5 * (histogram->low + histogram->high), histogram->high);
    fputs("</figure>\n", stream);
}

// An image's PNG, by way of a file of the report's own: the library writes no other. The caller frees it.
static char *png_of(const Report *report, const Image *image, size_t *size, Error *error)
{
    char path[MOST_PATH], *bytes = NULL;
    int file = mkstemp(report_path(report, ".picture-XXXXXX", path));
    if (file >= 0) {
        close(file);
        if (image_write_png(image, path, 8, error))
            bytes = file_read(path, (size_t)1 << 28, size, error);
        remove(path);
    } else {
        error_set(error, "%s: no space for a picture", report->directory);
    }
    return bytes;
}

static bool embed(const Report *report, const Image *image, const char *name, const char *alt, FILE *stream,
                  Error *error)
{
    size_t size;
    char *png = png_of(report, image, &size, error);
    if (!png)
        return false;
    fputs("<figure><img src=\"data:image/png;base64,", stream);
    text_base64(stream, (unsigned char *)png, size);
    fprintf(stream, "\" width=\"%d\" height=\"%d\" alt=\"%s\"/><figcaption>%s</figcaption></figure>\n", image->width,
            image->height, alt, name);
    free(png);
    return true;
}

void html_png(const Report *report, const char *name, const char *alt, FILE *stream)
{
    static const char magic[8] = {'\x89', 'P', 'N', 'G', '\r', '\n', '\x1a', '\n'};
    size_t size = 0;
    Error error = {""};
    char path[MOST_PATH], *png = file_read(report_path(report, name, path), (size_t)1 << 25, &size, &error);
    bool good = png && size > sizeof magic && memcmp(png, magic, sizeof magic) == 0;
    if (good) {
        fputs("<img src=\"data:image/png;base64,", stream);
        text_base64(stream, (unsigned char *)png, size);
        fprintf(stream, "\" alt=\"%s\"/>\n", alt);
    } else {
        text_put(stream, "<p class=\"note\">The picture is left out: %s</p>\n",
                 *error.message ? error.message : "it is no PNG file");
    }
    free(png);
}

static int ascending(const void *a, const void *b)
{
    float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

// The value below which a share of all channels lies; of |image − other| where another is given.
static double quantile(const Image *image, const Image *other, double share)
{
    size_t count = 3 * (size_t)image->width * (size_t)image->height;
    float *values = malloc(count * sizeof *values);
    if (!values)
        return 0.0;
    for (size_t i = 0; i < count; i++) {
        Colour c = image->pixels[i / 3], o = other ? other->pixels[i / 3] : colour(0.0f, 0.0f, 0.0f);
        values[i] = fabsf(colour_channel(c, (int)(i % 3)) - colour_channel(o, (int)(i % 3)));
    }
    qsort(values, count, sizeof *values, ascending);
    double value = (double)values[(size_t)(share * (double)(count - 1))];
    free(values);
    return value;
}

static void expose(Image *image, double white)
{
    size_t count = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; i < count; i++)
        image->pixels[i] = colour_scale(image->pixels[i], (float)(1.0 / white));
}

// Both under one exposure, which lights the reference well; a difference too small to see there stays pale.
static bool show(const Report *report, Image *yours, Image *reference, FILE *stream, Error *error)
{
    double white = 1.25 * quantile(reference, NULL, 0.97);
    white = white > 0.0 ? white : 1.0;
    double scale = fmax(quantile(yours, reference, 0.99), 0.05 * white);
    Image difference;
    if (!image_difference_picture(yours, reference, (float)scale, &difference, error))
        return false;
    expose(yours, white);
    expose(reference, white);
    fputs("<div class=\"pictures\">\n", stream);
    bool good = embed(report, yours, "yours", "the picture with your step", stream, error) &&
                embed(report, reference, "reference", "the picture with the reference", stream, error) &&
                embed(report, &difference, "<b class=\"red\">too bright</b> · <b class=\"blue\">too dark</b>",
                      "your picture minus the reference: red where yours is too bright, blue where it is too dark",
                      stream, error);
    fputs("</div>\n", stream);
    image_free(&difference);
    if (!good)
        return false;
    fprintf(stream,
            "<p class=\"scale\">White in the two pictures is a radiance of %.3g W/(m²·sr); full red or blue is a "
            "difference of %.3g, which is %.0f %% of that.</p>\n",
            white, scale, 100.0 * scale / white);
    return true;
}

void html_pictures(const Report *report, const ReportPicture *picture, FILE *stream)
{
    Error error = {""};
    Image yours = {0, 0, NULL}, reference = {0, 0, NULL};
    char path[MOST_PATH];
    bool good = image_read(&yours, report_path(report, picture->yours, path), &error) &&
                image_read(&reference, report_path(report, picture->reference, path), &error) &&
                show(report, &yours, &reference, stream, &error);
    if (!good)
        text_put(stream, "<p class=\"note\">The pictures are left out: %s</p>\n", error.message);
    image_free(&yours);
    image_free(&reference);
}
