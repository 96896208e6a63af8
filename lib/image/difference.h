// How far one image is from another.
#pragma once

#include "image/image.h"

// Per channel (0 red, 1 green, 2 blue). "image" is judged against "reference".
typedef struct {
    double rmse[3];          // root of the mean of (x−r)²
    double relative_mse[3];  // mean of (x−r)²/(r²+0.01)
    double mean_ratio[3];    // mean(image)/mean(reference); 1 when both are black, infinite when only the reference is
    double relative_mse_all; // over all pixels and channels
    // The same without the worst 0.1 % of pixels, rounded down; a pixel's error is the sum over its channels.
    double relative_mse_trimmed;
    size_t pixels; // how many were compared
} ImageDifference;

// Pixels in columns [x0, x1) and rows [y0, y1) are left out when comparing (a visible light and its edges). An empty
// rectangle leaves out nothing.
typedef struct {
    int x0, y0, x1, y1;
} ImageMask;

// Means over blocks of `side` × `side` pixels, with black for what is masked; columns and rows that fill no block are left
// out. To compare pictures by errors that are wider than a pixel.
bool image_blocks(const Image *image, int side, ImageMask mask, Image *blocks, Error *error);

// False when the sizes differ, either image holds NaN or infinity, or nothing is left to compare.
bool image_difference(const Image *image, const Image *reference, ImageMask mask, ImageDifference *result,
                      Error *error);

// A picture of image − reference: red where the image is brighter, blue where it is darker, by the mean over channels;
// white where they agree; full colour at ±scale (scale 0: chosen from the picture, its 99th percentile).
// False as above, or when the scale is negative or NaN.
bool image_difference_picture(const Image *image, const Image *reference, float scale, Image *picture, Error *error);
