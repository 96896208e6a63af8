// A picture that comes pass by pass.
#pragma once

#include "image/image.h"

#include <stdint.h>

typedef struct {
    Image image; // the mean of the passes that have come
    int passes;  // 0: a quick look, of fewer pixels blown up
} Rendered;

// Takes one in: `quick`, which counts until the first pass is there; the mean of so many passes in place of what there was
// (`mean_of`); otherwise one more pass. All but a quick one must have the image's size, and passes come in their order.
void rendered_add(Rendered *rendered, int width, int height, const Colour *pixels, bool quick, int mean_of);

// As sRGB, opaque, so many times as bright, in memory of its own; NULL: memory is short.
uint8_t *rendered_rgba(const Image *image, float brightness);
