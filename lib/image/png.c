// PNG by libpng's full interface: the simplified one has 16 bits only for linear values. libpng leaves by
// longjmp when something is wrong. So what has to be freed lives in a struct of the caller, and the functions
// which libpng jumps out of have no locals that matter.
#include "image/codec.h"

#include <png.h>
#include <stdlib.h>
#include <string.h>

// The most that deflate can shrink (a run of 258 bytes in 2 bits); a file that promises more pixels is
// damaged.
#define MAX_COMPRESSION 1032ull
#define MAX_CHUNK_BYTES 1000000 // for one piece of metadata
#define SIGNATURE_BYTES 8
#define ENCODED_BYTES   6 // of a pixel, at the most

typedef struct {
    png_structp png;
    png_infop info;
    const char *name;
    Error *error;
    char warning[128]; // libpng's last one; it says what is wrong, the error that follows only where

    const unsigned char *bytes; // reading: the file, and how far we are
    size_t size, at;
} Codec;

static void on_warning(png_structp png, png_const_charp message)
{
    Codec *codec = png_get_error_ptr(png);
    snprintf(codec->warning, sizeof codec->warning, "%s", message);
}

static void on_error(png_structp png, png_const_charp message)
{
    Codec *codec = png_get_error_ptr(png);
    const char *warning = codec->warning;
    error_set(codec->error, "%s: PNG: %s%s%s%s", codec->name, message, *warning ? " (" : "", warning,
              *warning ? ")" : "");
    png_longjmp(png, 1);
}

static void on_read(png_structp png, png_bytep target, size_t count)
{
    Codec *codec = png_get_io_ptr(png);
    if (count > codec->size - codec->at)
        png_error(png, "truncated: the file ends too early");
    memcpy(target, codec->bytes + codec->at, count);
    codec->at += count;
}

// That the stream takes no more shows when the file is closed.
static void on_write(png_structp png, png_bytep bytes, size_t count)
{
    fwrite(bytes, 1, count, png_get_io_ptr(png));
}

// One row from encoded bytes, which stand where its pixels belong, to linear floats. From the right to the
// left: a pixel's 12 bytes cover only encoded bytes that are used up.
static void decode_row(Colour *pixels, int width)
{
    for (int column = width - 1; column >= 0; column--) {
        const unsigned char *bytes = (const unsigned char *)pixels + ENCODED_BYTES * (size_t)column;
        Colour linear;
        for (int channel = 0; channel < 3; channel++, bytes += 2)
            colour_set_channel(&linear, channel, srgb_decode((float)(bytes[0] << 8 | bytes[1]) / 65535.0f));
        pixels[column] = linear;
    }
}

static bool read_all(Codec *codec, Image *image)
{
    if (setjmp(png_jmpbuf(codec->png)))
        return false;
    // Our own check names the size; libpng's would only call it invalid. Metadata is skipped: none is used.
    png_set_user_limits(codec->png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_chunk_malloc_max(codec->png, MAX_CHUNK_BYTES);
    png_set_keep_unknown_chunks(codec->png, PNG_HANDLE_CHUNK_NEVER, NULL, -1);
    png_set_read_fn(codec->png, codec, on_read);
    png_read_info(codec->png, codec->info);
    long width = png_get_image_width(codec->png, codec->info);
    long height = png_get_image_height(codec->png, codec->info);
    if (!image_check_size(width, height, codec->name, codec->error))
        return false;
    if (1ull * png_get_rowbytes(codec->png, codec->info) * (unsigned long)height > codec->size * MAX_COMPRESSION)
        png_error(codec->png, "truncated: the file is too short for its number of pixels");
    // Whatever the file holds, libpng hands out rows of red, green and blue with 16 bits each.
    png_set_expand_16(codec->png); // palettes to colours, too
    png_set_gray_to_rgb(codec->png);
    png_set_strip_alpha(codec->png);
    int passes = png_set_interlace_handling(codec->png);
    png_read_update_info(codec->png, codec->info);
    if (png_get_rowbytes(codec->png, codec->info) != ENCODED_BYTES * (size_t)width)
        png_error(codec->png, "the rows are not red, green and blue");
    if (!image_create(image, (int)width, (int)height, codec->error))
        return false;
    for (; passes > 0; passes--)
        for (int row = 0; row < image->height; row++)
            png_read_row(codec->png, (png_bytep)image_at(image, 0, row), NULL);
    png_read_end(codec->png, NULL);
    for (int row = 0; row < image->height; row++)
        decode_row(image_at(image, 0, row), image->width);
    return true;
}

bool image_read_png_memory(Image *image, const unsigned char *bytes, size_t size, const char *name, Error *error)
{
    *image = (Image){0};
    if (size < SIGNATURE_BYTES || png_sig_cmp((png_bytep)bytes, 0, SIGNATURE_BYTES) != 0)
        return error_set(error, "%s: is not a PNG file: its first 8 bytes are not PNG's signature", name);
    Codec codec = {.name = name, .error = error, .bytes = bytes, .size = size};
    codec.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &codec, on_error, on_warning);
    codec.info = codec.png ? png_create_info_struct(codec.png) : NULL;
    bool good = codec.info ? read_all(&codec, image) : error_set(error, "%s: no memory to read a PNG file", name);
    png_destroy_read_struct(&codec.png, &codec.info, NULL);
    if (!good)
        image_free(image);
    return good;
}

static void encode_row(png_bytep bytes, const Colour *pixels, int width, int bits)
{
    float most = bits == 8 ? 255.0f : 65535.0f;
    for (int column = 0; column < width; column++)
        for (int channel = 0; channel < 3; channel++) {
            float encoded = srgb_encode(colour_channel(pixels[column], channel));
            unsigned value = (unsigned)(encoded * most + 0.5f);
            if (bits == 16)
                *bytes++ = (png_byte)(value >> 8);
            *bytes++ = (png_byte)(value & 255);
        }
}

// `row`: room for an encoded one.
static bool write_all(const Codec *codec, const Image *image, FILE *stream, png_bytep row, int bits)
{
    if (setjmp(png_jmpbuf(codec->png)))
        return false;
    png_set_write_fn(codec->png, stream, on_write, NULL);
    png_set_IHDR(codec->png, codec->info, (png_uint_32)image->width, (png_uint_32)image->height, bits,
                 PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(codec->png, codec->info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(codec->png, codec->info);
    for (int y = 0; y < image->height; y++) {
        encode_row(row, image_at(image, 0, y), image->width, bits);
        png_write_row(codec->png, row);
    }
    png_write_end(codec->png, NULL);
    return true;
}

static bool encode(const Image *image, FILE *stream, const char *name, int bits, Error *error)
{
    Codec codec = {.name = name, .error = error};
    png_bytep row = malloc(ENCODED_BYTES * (size_t)image->width);
    codec.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &codec, on_error, on_warning);
    codec.info = codec.png ? png_create_info_struct(codec.png) : NULL;
    bool good = row && codec.info ? write_all(&codec, image, stream, row, bits)
                                  : error_set(error, "%s: no memory to write a PNG file", name);
    png_destroy_write_struct(&codec.png, &codec.info);
    free(row);
    return good;
}

const ImageFormat image_format_png = {".png", "to look at", image_read_png_memory, encode, NULL};
