#include "image/codec.h"
#include "base/file.h"
#include "base/text.h"

#include <math.h>
#include <stdlib.h>

// No image that we read is longer: the most pixels as PFM, and 4 kB for its header.
#define MAX_FILE_BYTES (12ull * IMAGE_MAX_PIXELS + 4096)

bool image_check_size(long width, long height, const char *name, Error *error)
{
    if (width < 1 || height < 1 || width > IMAGE_MAX_SIDE || height > IMAGE_MAX_SIDE)
        return error_set(error, "%s: the size is %ld×%ld pixels; expected 1 to %d on each side", name, width, height,
                         IMAGE_MAX_SIDE);
    if ((long long)width * height > IMAGE_MAX_PIXELS)
        return error_set(error, "%s: the size is %ld×%ld pixels; expected at most %ld in all", name, width, height,
                         IMAGE_MAX_PIXELS);
    return true;
}

bool image_create(Image *image, int width, int height, Error *error)
{
    *image = (Image){0};
    if (!image_check_size(width, height, "image", error))
        return false;
    Colour *pixels = calloc((size_t)width * (size_t)height, sizeof *pixels);
    if (!pixels)
        return error_set(error, "image: no memory for %d×%d pixels", width, height);
    *image = (Image){width, height, pixels};
    return true;
}

void image_free(Image *image)
{
    free(image->pixels);
    *image = (Image){0};
}

bool image_check_finite(const Image *image, const char *name, Error *error)
{
    if (!image->pixels)
        return error_set(error, "%s: the image has no pixels", name);
    for (int row = 0; row < image->height; row++)
        for (int column = 0; column < image->width; column++) {
            Colour c = *image_at(image, column, row);
            if (!isfinite(c.r) || !isfinite(c.g) || !isfinite(c.b))
                return error_set(error,
                                 "%s: the pixel in column %d, row %d (counted from 0, top left) is (%g, %g, %g); "
                                 "expected finite numbers",
                                 name, column, row, (double)c.r, (double)c.g, (double)c.b);
        }
    return true;
}

bool image_mark_unsound(Image *image, const char *name, Error *error)
{
    Error first = {""};
    if (image_check_finite(image, name, &first))
        return true;
    for (size_t i = 0; i < (size_t)image->width * (size_t)image->height; i++) {
        Colour *c = &image->pixels[i];
        if (!isfinite(c->r) || !isfinite(c->g) || !isfinite(c->b))
            *c = colour(1.0f, 0.0f, 1.0f);
    }
    return error_set(error, "%s; in the picture such pixels are magenta", first.message);
}

// `!(x > 0)`, not `x <= 0`: it holds for NaN as well, which so becomes 0.
float srgb_encode(float linear)
{
    if (!(linear > 0.0f))
        return 0.0f;
    if (linear >= 1.0f)
        return 1.0f;
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * powf(linear, 1.0f / 2.4f) - 0.055f;
}

float srgb_decode(float encoded)
{
    if (!(encoded > 0.0f))
        return 0.0f;
    if (encoded >= 1.0f)
        return 1.0f;
    return encoded <= 0.04045f ? encoded / 12.92f : powf((encoded + 0.055f) / 1.055f, 2.4f);
}

#define IMAGE_FORMAT(name) &image_format_##name,
static const ImageFormat *const formats[] = {
#include "image/formats.def"
};
#define FORMAT_COUNT (sizeof formats / sizeof formats[0])

// By the path's ending; NULL with the error where there is none, or not in this build.
static const ImageFormat *format_of(const char *path, Error *error)
{
    char known[200] = "";
    for (size_t i = 0; i < FORMAT_COUNT; i++) {
        const ImageFormat *format = formats[i];
        if (file_ends_in(path, format->ending)) {
            if (format->missing)
                error_set(error, "%s: no %s files here: %s", path, format->ending, format->missing);
            return format->missing ? NULL : format;
        }
        const char *joint = i == 0 ? "" : i + 1 < FORMAT_COUNT ? ", " : " or ";
        text_append(known, sizeof known, "%s%s (%s)", joint, format->ending, format->use);
    }
    const char *ending = file_ending(path);
    error_set(error, "%s: the name %s%s; expected %s", path, *ending ? "ends in " : "has no ending", ending, known);
    return NULL;
}

bool image_path_is_known(const char *path, Error *error)
{
    return format_of(path, error) != NULL;
}

bool image_read(Image *image, const char *path, Error *error)
{
    *image = (Image){0};
    size_t size;
    const ImageFormat *format = format_of(path, error);
    char *bytes = format ? file_read(path, MAX_FILE_BYTES, &size, error) : NULL;
    if (!bytes)
        return false;
    bool good = format->decode(image, (unsigned char *)bytes, size, path, error);
    free(bytes);
    return good;
}

static bool write_as(const ImageFormat *format, const Image *image, const char *path, int bits, Error *error)
{
    FileWriter writer;
    if (!image_check_finite(image, path, error) || !file_write_begin(&writer, path, error))
        return false;
    return file_write_end(&writer, format->encode(image, writer.stream, path, bits, error), error);
}

bool image_write_png(const Image *image, const char *path, int bits, Error *error)
{
    if (bits != 8 && bits != 16)
        return error_set(error, "%s: a PNG file of %d bits was asked for; expected 8 or 16", path, bits);
    return write_as(&image_format_png, image, path, bits, error);
}

bool image_write_pfm(const Image *image, const char *path, Error *error)
{
    return write_as(&image_format_pfm, image, path, 0, error);
}

bool image_write(const Image *image, const char *path, Error *error)
{
    return image_write_bits(image, path, 8, error);
}

bool image_write_bits(const Image *image, const char *path, int bits, Error *error)
{
    const ImageFormat *format = format_of(path, error);
    return format && write_as(format, image, path, bits, error);
}
