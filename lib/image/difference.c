#include "image/difference.h"
#include "image/codec.h"

#include <math.h>
#include <stdlib.h>

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static bool check_pair(const Image *image, const Image *reference, Error *error)
{
    if (image->width != reference->width || image->height != reference->height)
        return error_set(error, "the image is %d×%d pixels, the reference %d×%d; expected the same size", image->width,
                         image->height, reference->width, reference->height);
    return image_check_finite(image, "image", error) && image_check_finite(reference, "reference", error);
}

static bool is_masked(ImageMask mask, int column, int row)
{
    return column >= mask.x0 && column < mask.x1 && row >= mask.y0 && row < mask.y1;
}

// Adds one pixel to sums over all that are compared, mean_ratio's to that over the image and to that over the
// reference; returns its relative error, summed over the channels.
static double add_pixel(ImageDifference *sums, double reference[3], Colour x, Colour r)
{
    double all = 0.0;
    for (int c = 0; c < 3; c++) {
        double value = colour_channel(x, c), truth = colour_channel(r, c);
        double square = (value - truth) * (value - truth);
        double relative = square / (truth * truth + 0.01);
        sums->rmse[c] += square;
        sums->relative_mse[c] += relative;
        sums->mean_ratio[c] += value;
        reference[c] += truth;
        all += relative;
    }
    return all;
}

// From sums to means.
static void divide(ImageDifference *result, const double reference[3])
{
    double count = (double)result->pixels;
    for (int c = 0; c < 3; c++) {
        result->rmse[c] = sqrt(result->rmse[c] / count);
        result->relative_mse[c] /= count;
        result->mean_ratio[c] = result->mean_ratio[c] == reference[c] ? 1.0 : result->mean_ratio[c] / reference[c];
        result->relative_mse_all += result->relative_mse[c] / 3.0;
    }
}

// The mean of the smallest errors: added in ascending order, it does not depend on where in the image they are.
static double trimmed_mean(double *errors, size_t pixels)
{
    qsort(errors, pixels, sizeof *errors, ascending);
    size_t kept = pixels - pixels / 1000;
    double sum = 0.0;
    for (size_t i = 0; i < kept; i++)
        sum += errors[i];
    return sum / (3.0 * (double)kept);
}

bool image_difference(const Image *image, const Image *reference, ImageMask mask, ImageDifference *result, Error *error)
{
    *result = (ImageDifference){0};
    if (!check_pair(image, reference, error))
        return false;
    double *errors = malloc((size_t)image->width * (size_t)image->height * sizeof *errors);
    if (!errors)
        return error_set(error, "no memory to compare %d×%d pixels", image->width, image->height);
    double sums[3] = {0.0};
    for (int row = 0; row < image->height; row++)
        for (int column = 0; column < image->width; column++)
            if (!is_masked(mask, column, row))
                errors[result->pixels++] =
                    add_pixel(result, sums, *image_at(image, column, row), *image_at(reference, column, row));
    if (result->pixels > 0) {
        divide(result, sums);
        result->relative_mse_trimmed = trimmed_mean(errors, result->pixels);
    } else {
        error_set(error, "nothing to compare: the mask (columns %d to %d, rows %d to %d) covers the image of %d×%d",
                  mask.x0, mask.x1, mask.y0, mask.y1, image->width, image->height);
    }
    free(errors);
    return result->pixels > 0;
}

// How much brighter the image is at pixel i, as the mean over the channels.
static double brighter(const Image *image, const Image *reference, size_t i)
{
    Colour x = image->pixels[i], r = reference->pixels[i];
    return (((double)x.r - r.r) + ((double)x.g - r.g) + ((double)x.b - r.b)) / 3.0;
}

// The 99th percentile of the absolute differences; where that is 0, the largest. Negative when memory is
// short.
static double choose_scale(const Image *image, const Image *reference)
{
    size_t pixels = (size_t)image->width * (size_t)image->height;
    double *sizes = malloc(pixels * sizeof *sizes);
    if (!sizes)
        return -1.0;
    for (size_t i = 0; i < pixels; i++)
        sizes[i] = fabs(brighter(image, reference, i));
    qsort(sizes, pixels, sizeof *sizes, ascending);
    double percentile = sizes[(size_t)((pixels - 1) * 99ull / 100)];
    double scale = percentile > 0.0 ? percentile : sizes[pixels - 1];
    free(sizes);
    return scale;
}

bool image_difference_picture(const Image *image, const Image *reference, float scale, Image *picture, Error *error)
{
    *picture = (Image){0};
    if (!check_pair(image, reference, error))
        return false;
    if (!(scale >= 0.0f))
        return error_set(error, "the scale of the picture is %g; expected 0 (chosen for you) or more", (double)scale);
    double full = scale > 0.0f ? (double)scale : choose_scale(image, reference);
    if (full < 0.0)
        return error_set(error, "no memory to compare %d×%d pixels", image->width, image->height);
    if (!image_create(picture, image->width, image->height, error))
        return false;
    size_t pixels = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; i < pixels; i++) {
        double d = brighter(image, reference, i);
        float t = fabs(d) < full ? (float)(fabs(d) / full) : d != 0.0;
        picture->pixels[i] = d > 0.0 ? colour(1.0f, 1.0f - t, 1.0f - t) : colour(1.0f - t, 1.0f - t, 1.0f);
    }
    return true;
}

bool image_blocks(const Image *image, int side, ImageMask mask, Image *blocks, Error *error)
{
    int across = image->width / side, down = image->height / side;
    if (across < 1 || down < 1)
        return error_set(error, "the image is %d×%d pixels; expected at least one block of %d", image->width,
                         image->height, side);
    if (!image_create(blocks, across, down, error))
        return false;
    for (int row = 0; row < down * side; row++)
        for (int column = 0; column < across * side; column++) {
            Colour *mean = image_at(blocks, column / side, row / side);
            if (!is_masked(mask, column, row))
                *mean = colour_add(*mean, colour_scale(*image_at(image, column, row), 1.0f / (float)(side * side)));
        }
    return true;
}
