// A small canvas without a display, and looking at its pixels.
#ifndef PHOTONLAB_TESTS_CANVAS_HELPERS_H
#define PHOTONLAB_TESTS_CANVAS_HELPERS_H

#include "unit/preview/canvas_leaks.h"
#include "preview/draw/context/context.h"
#include "unit/test.h"

enum { WIDTH = 160, HEIGHT = 120 };
static const Rgba BLACK = {0, 0, 0, 255};

static Context *context;
static uint8_t seen[4 * WIDTH * HEIGHT]; // what `look` read

static inline int start(void **state)
{
    (void)state;
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1); // the same on every machine
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    Error error = {""};
    context = context_create(CONTEXT_ANY, &error);
    if (!context)
        print_message("skipped: %s\n", error.message);
    return 0;
}

static inline int end(void **state)
{
    (void)state;
    context_free(context);
    return 0;
}

static inline void begin(Canvas *canvas)
{
    static const float PIXELS[16] = {2.0f / WIDTH, 0, 0, 0, 0, -2.0f / HEIGHT, 0, 0, 0, 0, 1, 0, -1, 1, 0, 1};
    canvas_begin(canvas, BLACK);
    canvas_view(canvas, 0, 0, WIDTH, HEIGHT, PIXELS);
}

FREED_AT_END(own_canvas, Canvas, canvas_free)

// An empty one, in pixels from the top left.
static inline Canvas *new_canvas(void)
{
    if (!context)
        skip();
    Error error = {""};
    Canvas *canvas = canvas_create(context_loader(context), WIDTH, HEIGHT, &error);
    if (!canvas)
        fail_msg("%s", error.message);
    begin(canvas);
    return own_canvas(canvas);
}

static inline void look(Canvas *canvas)
{
    memset(seen, 77, sizeof seen);
    canvas_read(canvas, seen);
}

static inline void assert_pixel(int x, int y, int r, int g, int b)
{
    const uint8_t *p = seen + 4 * (y * WIDTH + x);
    if (p[0] != r || p[1] != g || p[2] != b || p[3] != 255)
        fail_msg("pixel (%d, %d) is %d %d %d %d and should be %d %d %d 255", x, y, p[0], p[1], p[2], p[3], r, g, b);
}

static inline bool is_black(int x, int y)
{
    const uint8_t *p = seen + 4 * (y * WIDTH + x);
    return p[0] == 0 && p[1] == 0 && p[2] == 0;
}

static inline int count_lit(int left, int top, int width, int height)
{
    int count = 0;
    for (int y = top; y < top + height; y++)
        for (int x = left; x < left + width; x++)
            count += !is_black(x, y);
    return count;
}

static inline int count_all(void)
{
    return count_lit(0, 0, WIDTH, HEIGHT);
}

#endif
