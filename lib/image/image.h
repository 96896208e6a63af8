// Images: linear RGB floats (radiance, W/(m²·sr)), row 0 at the top. PNG is for looking (sRGB, clipped to 0…1), PFM
// for measuring (linear floats, nothing lost), EXR the same for other programs.
#pragma once

#include "base/error.h"
#include "math/colour.h"

#include <stdbool.h>
#include <stddef.h>

#define IMAGE_MAX_SIDE   65536      // pixels; a larger width or height in a file is taken for damage
#define IMAGE_MAX_PIXELS (1L << 28) // in all: 3 GiB of floats

typedef struct {
    int width, height;
    Colour *pixels; // width·height, row by row from the top; owned by the image
} Image;

// A black image. False when a side is not in 1…IMAGE_MAX_SIDE, there are more than IMAGE_MAX_PIXELS, or memory is
// short.
bool image_create(Image *image, int width, int height, Error *error);

// Frees the pixels; safe on an image that was zeroed or already freed.
void image_free(Image *image);

static inline Colour *image_at(const Image *image, int column, int row)
{
    return &image->pixels[(size_t)row * (size_t)image->width + (size_t)column];
}

// sRGB transfer curve (IEC 61966-2-1) from linear 0…1 to encoded 0…1 and back; values outside are clipped, NaN gives
// 0.
float srgb_encode(float linear);
float srgb_decode(float encoded);

// Reads or writes by the file's ending (any case): .png, .pfm or, where OpenEXR was there to build with, .exr. Reading: PNG of 8 or 16 bits, grey or colour, alpha
// dropped, its values taken for sRGB whatever colour space it names; PFM of one or three channels, either byte order,
// its scale's magnitude ignored; EXR of scan lines with R, G and B, or Y. A file that is truncated, too large or holds NaN or infinity is an error, and leaves
// the image empty. Reading does not free what the image held before. Writing goes to a file beside, then renames it:
// a failed write leaves the old file as it was. An image that holds NaN or infinity is not written.
bool image_read(Image *image, const char *path, Error *error);
bool image_write(const Image *image, const char *path, Error *error);
bool image_write_bits(const Image *image, const char *path, int bits, Error *error); // of a PNG's channels: 8 or 16

// As above with the format chosen, whatever the ending. bits: 8 or 16.
bool image_write_png(const Image *image, const char *path, int bits, Error *error);
bool image_write_pfm(const Image *image, const char *path, Error *error);

// Pixels with NaN or infinity become magenta, so that the rest can be written; false, naming the first, if there were any.
bool image_mark_unsound(Image *image, const char *name, Error *error);

// True if image_write knows the path's ending; otherwise an error that names the endings it knows.
bool image_path_is_known(const char *path, Error *error);
