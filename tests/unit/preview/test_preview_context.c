// Where the preview draws: the same bytes from OSMesa, EGL and a window, and what is said when they are missing.
#include "preview/window.h"
#include "unit/preview/canvas_helpers.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

// ---- The same bytes from everywhere ----

// Some of everything, with numbers that fall between pixels.
static bool draw_much(GlLoader loader, uint8_t *rgba)
{
    Canvas *canvas = canvas_create(loader, WIDTH, HEIGHT, &said);
    if (!canvas) {
        print_message("%s\n", said.message);
        return false;
    }
    static const float LENS[16] = {1.3f, 0.1f, 0, 0.2f, 0, 1.7f, 0, 0.1f, 0.2f, 0, 1, 0.3f, 0, 0, 0, 1.5f};
    static Vertex vertices[3000];
    uint32_t random = 1;
    for (size_t i = 0; i < 3000; i++) {
        float p[3];
        for (int k = 0; k < 3; k++)
            p[k] = (float)((random = random * 1664525u + 1013904223u) >> 8) / (float)(1 << 23) - 1.0f;
        vertices[i] = (Vertex){p[0], p[1], p[2], (uint8_t)random, (uint8_t)(random >> 8), (uint8_t)(random >> 16), 180};
    }
    canvas_begin(canvas, BLACK);
    canvas_view(canvas, 3, 5, 140, 101, LENS);
    canvas_draw(canvas, vertices, 60, &(DrawStyle){.kind = DRAW_TRIANGLES});
    canvas_draw(canvas, vertices + 60, 200, &(DrawStyle){.kind = DRAW_LINES});
    canvas_draw(canvas, vertices, 3000, &(DrawStyle){.kind = DRAW_POINTS, .additive = true, .exposure = 0.37f});
    canvas_draw(canvas, vertices, 100, &(DrawStyle){.kind = DRAW_POINTS, .point_size = 3});
    canvas_picture(canvas, 100, 70, 42, 33, (const uint8_t *)vertices, 13, 9);
    canvas_text(canvas, 5, 5, 1, (Rgba){255, 255, 255, 200}, "the same bytes");
    canvas_read(canvas, rgba);
    canvas_free(canvas);
    return true;
}

// In a process of its own, since two OpenGL libraries need not get along in one: draws and sends the bytes.
static bool draw_elsewhere(ContextKind kind, bool in_window, uint8_t *rgba)
{
    int ends[2];
    assert_int_equal(pipe(ends), 0);
    pid_t child = fork();
    if (child == 0) {
        static uint8_t bytes[4 * WIDTH * HEIGHT];
        Context *own = in_window ? NULL : context_create(kind, &said);
        Window *window = in_window ? window_create(NULL, 50, 50, &said) : NULL;
        if (!own && !window)
            print_message("skipped: %s\n", said.message);
        else if (draw_much(own ? context_loader(own) : window_loader(), bytes))
            for (size_t sent = 0; sent < sizeof bytes;)
                sent += (size_t)write(ends[1], bytes + sent, sizeof bytes - sent);
        context_free(own);
        window_free(window);
        _exit(0);
    }
    close(ends[1]);
    size_t got = 0;
    for (ssize_t n; got < sizeof seen && (n = read(ends[0], rgba + got, sizeof seen - got)) > 0;)
        got += (size_t)n;
    close(ends[0]);
    int status;
    waitpid(child, &status, 0);
    assert_int_equal(status, 0);
    return got == sizeof seen;
}

TEST(osmesa_and_egl_draw_the_same_bytes)
{
    static uint8_t other[sizeof seen];
    if (!draw_elsewhere(CONTEXT_OSMESA, false, seen) || !draw_elsewhere(CONTEXT_EGL, false, other))
        skip();
    assert_true(count_all() > 5000);
    assert_memory_equal(seen, other, sizeof seen);
}

// A display of our own where there is none, and its server; NULL when there is no Xvfb.
static FILE *start_display(long *server)
{
    int number;
    FILE *display = popen("echo $$; exec Xvfb -displayfd 1 -screen 0 320x240x24 -nolisten tcp 2>/dev/null", "r");
    assert_non_null(display);
    if (fscanf(display, "%ld %d", server, &number) != 2) {
        pclose(display);
        return NULL;
    }
    setenv("DISPLAY", words(":%d", number), 1);
    return display;
}

TEST(a_window_draws_the_same_bytes)
{
    static uint8_t other[sizeof seen];
    if (!draw_elsewhere(CONTEXT_ANY, false, seen))
        skip();
    long server;
    FILE *display = start_display(&server);
    bool drawn = (display || getenv("DISPLAY")) && draw_elsewhere(CONTEXT_ANY, true, other);
    if (display) {
        kill((pid_t)server, SIGTERM);
        pclose(display);
        unsetenv("DISPLAY");
    }
    if (!drawn) {
        print_message("skipped: neither Xvfb nor a display with OpenGL 3.3\n");
        skip();
    }
    assert_true(count_all() > 5000);
    assert_memory_equal(seen, other, sizeof seen);
}

// ---- What is missing ----

TEST(what_is_missing_is_named)
{
    setenv("PHOTONLAB_WITHOUT", "osmesa,egl,glfw", 1);
    assert_null(context_create(CONTEXT_ANY, &said));
    assert_non_null(strstr(said.message, "apt-get install libosmesa6"));
    assert_said("libegl1");
    assert_refused(context_create(CONTEXT_OSMESA, &said), "there is no libOSMesa");
    assert_null(window_create("", 100, 100, &said));
    assert_non_null(strstr(said.message, "GLFW"));
    assert_said("apt-get install");
    unsetenv("PHOTONLAB_WITHOUT");
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
#ifndef __APPLE__
    assert_null(window_create("", 100, 100, &said));
    assert_true(strstr(said.message, "no display") || strstr(said.message, "GLFW"));
#endif
}

TEST(egl_serves_without_osmesa)
{
    static uint8_t other[sizeof seen];
    bool have_egl = draw_elsewhere(CONTEXT_EGL, false, seen);
    setenv("PHOTONLAB_WITHOUT", "osmesa", 1);
    bool drawn = draw_elsewhere(CONTEXT_ANY, false, other);
    unsetenv("PHOTONLAB_WITHOUT");
    if (!have_egl)
        skip();
    assert_true(drawn);
    assert_memory_equal(seen, other, sizeof seen);
}

AROUND_TESTS(software_alone, NULL)
