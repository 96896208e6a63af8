// What the image formats share inside this folder, and the way in for the fuzzers: pixels from and to bytes
// on one side (png.c, pfm.c), bytes from and to files on the other (image.c).
#pragma once

#include "image/image.h"

#include <stdio.h>

// Reads an image out of the bytes of a file; `name` stands in front of the error. On failure the image is
// left empty.
typedef bool ImageDecoder(Image *image, const unsigned char *bytes, size_t size, const char *name, Error *error);
ImageDecoder image_read_png_memory;
ImageDecoder image_read_pfm_memory;

// Writes a checked image to the stream; whether that took it all shows when the file is closed. bits, of a PNG: 8 or 16.
typedef bool ImageEncoder(const Image *image, FILE *stream, const char *name, int bits, Error *error);

typedef struct {
    const char *ending, *use; // ".png", "to look at"
    ImageDecoder *decode;
    ImageEncoder *encode;
    const char *missing; // why this build has neither; NULL: it has both
} ImageFormat;

#define IMAGE_FORMAT(name) extern const ImageFormat image_format_##name;
#include "image/formats.def"
#undef IMAGE_FORMAT

// False when a side or the number of pixels is out of bounds.
bool image_check_size(long width, long height, const char *name, Error *error);

// False, naming the pixel, when one is NaN or infinite, or when there are none at all.
bool image_check_finite(const Image *image, const char *name, Error *error);
