#include "preview/record/rendered.h"

#include <stdlib.h>
#include <string.h>

static void show_quick(Image *image, int width, int height, const Colour *pixels)
{
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++) {
            int column = (int)((long long)x * width / image->width), row = (int)((long long)y * height / image->height);
            *image_at(image, x, y) = pixels[(size_t)row * (size_t)width + (size_t)column];
        }
}

void rendered_add(Rendered *rendered, int width, int height, const Colour *pixels, bool quick, int mean_of)
{
    Image *image = &rendered->image;
    size_t count = (size_t)image->width * (size_t)image->height;
    bool whole = width == image->width && height == image->height;
    if (quick && rendered->passes == 0) {
        show_quick(image, width, height, pixels);
    } else if (mean_of && whole) {
        memcpy(image->pixels, pixels, count * sizeof *pixels);
        rendered->passes = mean_of;
    } else if (!quick && whole) {
        float share = 1.0f / (float)++rendered->passes;
        for (size_t i = 0; i < count; i++)
            image->pixels[i] =
                colour_add(image->pixels[i], colour_scale(colour_sub(pixels[i], image->pixels[i]), share));
    }
}

uint8_t *rendered_rgba(const Image *image, float brightness)
{
    size_t count = (size_t)image->width * (size_t)image->height;
    uint8_t *bytes = malloc(count * 4);
    for (size_t i = 0; bytes && i < count; i++) {
        for (int c = 0; c < 3; c++)
            bytes[4 * i + (size_t)c] =
                (uint8_t)(255.0f * srgb_encode(brightness * colour_channel(image->pixels[i], c)) + 0.5f);
        bytes[4 * i + 3] = 255;
    }
    return bytes;
}
