// The low-frequency error of pictures: 4_blocks REFERENCE OUT.png NUMBERS PICTURE …
// A picture and its reference, which may be finer, are averaged over 32 × 32 equal squares; OUT.png shows, side by side, by
// how much each picture's squares are off: red too bright, blue too dark, full colour at 10 %. NUMBERS: for picture i,
// `low_i` the mean of (x−r)²/(r²+0.01) over squares and channels, `percent_i` its root, `all_i` the same error of single
// pixels, `gain` that of the first picture over that of the second.
#include "photonlab.h"

#include <stdio.h>
#include <stdlib.h>

enum { SQUARES = 32, ZOOM = 8, GAP = 8, MOST = 4 };

static void fail(const char *message)
{
    fprintf(stderr, "4_blocks: %s\n", message);
    exit(1);
}

// Averaged over side × side equal squares.
static Image shrink(const Image *image, int side)
{
    Image small;
    Error error = {""};
    if (image->width % side || image->height % side || !image_create(&small, side, side, &error))
        fail("a picture's sides are no multiple of what they are averaged to");
    int w = image->width / side, h = image->height / side;
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++) {
            Colour *into = image_at(&small, x / w, y / h);
            *into = colour_add(*into, colour_scale(*image_at(image, x, y), 1.0f / (float)(w * h)));
        }
    return small;
}

static double error_of(const Image *image, const Image *reference)
{
    ImageDifference difference;
    Error error = {""};
    if (!image_difference(image, reference, (ImageMask){0, 0, 0, 0}, &difference, &error))
        fail(error.message);
    return difference.relative_mse_all;
}

static void draw(Image *all, int left, const Image *squares, const Image *truth)
{
    for (int y = 0; y < SQUARES * ZOOM; y++)
        for (int x = 0; x < SQUARES * ZOOM; x++) {
            Colour found = *image_at(squares, x / ZOOM, y / ZOOM), right = *image_at(truth, x / ZOOM, y / ZOOM);
            float off = colour_sum(found) / colour_sum(right) - 1.0f;
            float pale = 1.0f - fminf(fabsf(off) / 0.1f, 1.0f);
            *image_at(all, left + x, y) = off > 0.0f ? colour(1.0f, pale, pale) : colour(pale, pale, 1.0f);
        }
}

int main(int count, char **names)
{
    Error error = {""};
    Image reference, all, picture;
    if (count < 5 || count > 4 + MOST || !image_read(&reference, names[1], &error))
        fail("usage: 4_blocks REFERENCE OUT.png NUMBERS PICTURE …");
    int parts = count - 4;
    FILE *numbers = fopen(names[3], "w");
    if (!numbers || !image_create(&all, parts * (SQUARES * ZOOM + GAP) - GAP, SQUARES * ZOOM, &error))
        fail("cannot write");
    for (int i = 0; i < all.width * all.height; i++)
        all.pixels[i] = colour_grey(1.0f);
    Image truth = shrink(&reference, SQUARES);
    double low[MOST];
    for (int i = 0; i < parts; i++) {
        if (!image_read(&picture, names[4 + i], &error))
            fail(error.message);
        Image fine = shrink(&reference, picture.width), squares = shrink(&picture, SQUARES);
        low[i] = error_of(&squares, &truth);
        fprintf(numbers, "low_%d %.3g\npercent_%d %.2f\nall_%d %.3g\n", i + 1, low[i], i + 1, 100.0 * sqrt(low[i]),
                i + 1, error_of(&picture, &fine));
        draw(&all, i * (SQUARES * ZOOM + GAP), &squares, &truth);
    }
    if (parts > 1)
        fprintf(numbers, "gain %.2f\n", low[0] / low[1]);
    if (fclose(numbers) != 0 || !image_write(&all, names[2], &error))
        fail(error.message);
    return 0;
}
