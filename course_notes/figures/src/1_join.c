// Pictures side by side, with white between them: 1_join OUT.png LEFT … RIGHT
// A last argument that ends in x (2x) shows each pixel that many times larger.
#include "photonlab.h"

#include <stdio.h>
#include <stdlib.h>

enum { GAP = 8, MOST = 8 };

static void put(Image *all, int left, const Image *one, int zoom)
{
    for (int y = 0; y < one->height * zoom; y++)
        for (int x = 0; x < one->width * zoom; x++)
            all->pixels[(size_t)y * (size_t)all->width + (size_t)(left + x)] =
                one->pixels[(size_t)(y / zoom) * (size_t)one->width + (size_t)(x / zoom)];
}

int main(int count, char **names)
{
    Image parts[MOST];
    Error error = {{0}};
    int width = -GAP;
    int height = 0;
    char unit = ' ';
    int zoom = 1;
    if (count > 2 && sscanf(names[count - 1], "%d%c", &zoom, &unit) == 2 && unit == 'x')
        count--;
    for (int i = 2; i < count && i < MOST + 2; i++) {
        if (!image_read(&parts[i - 2], names[i], &error)) {
            fprintf(stderr, "%s\n", error.message);
            return 1;
        }
        width += parts[i - 2].width * zoom + GAP;
        height = parts[i - 2].height * zoom > height ? parts[i - 2].height * zoom : height;
    }
    Image all;
    if (count < 3 || count > MOST + 2 || !image_create(&all, width, height, &error)) {
        fprintf(stderr, "usage: 1_join OUT.png PICTURE … (%d at most) [2x]\n", MOST);
        return 2;
    }
    for (size_t i = 0; i < (size_t)width * (size_t)height; i++)
        all.pixels[i] = colour_grey(1.0f);
    int left = 0;
    for (int i = 0; i + 2 < count; i++) {
        put(&all, left, &parts[i], zoom);
        left += parts[i].width * zoom + GAP;
    }
    if (!image_write(&all, names[1], &error)) {
        fprintf(stderr, "%s\n", error.message);
        return 1;
    }
    return 0;
}
