// A small canvas without a display, and looking at its pixels.
#pragma once

#include "preview/draw/context/context.h"
#include "unit/test.h"

// Mesa keeps some hundred bytes of each context for ever. Read by AddressSanitizer, where there is one.
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void)
{
    return "leak:libOSMesa\nleak:libEGL\nleak:libLLVM\nleak:_dri.so\nleak:libgallium\n";
}

enum { WIDTH = 160, HEIGHT = 120 };
static const Rgba BLACK = {0, 0, 0, 255};

static Context *context;
static uint8_t seen[4 * WIDTH * HEIGHT]; // what `look` read

FIXTURE(software_alone) // the same on every machine
{
    return setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1) || setenv("GALLIUM_DRIVER", "llvmpipe", 1);
}

FIXTURE(start)
{
    software_alone(state);
    context = context_create(CONTEXT_ANY, &said);
    if (!context)
        print_message("skipped: %s\n", said.message);
    return 0;
}

FIXTURE(end)
{
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
    Canvas *canvas = canvas_create(context_loader(context), WIDTH, HEIGHT, &said);
    assert_works(canvas);
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

static inline int count_lit(int left, int top, int width, int height)
{
    int count = 0;
    for (int y = top; y < top + height; y++)
        for (int x = left; x < left + width; x++) {
            const uint8_t *p = seen + 4 * (y * WIDTH + x);
            count += p[0] || p[1] || p[2];
        }
    return count;
}

static inline int count_all(void)
{
    return count_lit(0, 0, WIDTH, HEIGHT);
}
