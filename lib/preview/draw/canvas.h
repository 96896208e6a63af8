// Drawing: points, lines, triangles and text into a picture in the graphics memory. The same calls in a window and
// without a display, and the same bytes from OSMesa, EGL and GLFW under software OpenGL: everything goes into a
// framebuffer object of our own, RGBA8. What is drawn later covers what is there.
#pragma once

#include "base/error.h"
#include "preview/draw/orbit.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct {
    uint8_t r, g, b, a;
} Rgba;

typedef struct {
    float x, y, z;
    uint8_t r, g, b, a;
} Vertex; // 16 bytes, as the graphics card reads them

typedef struct Canvas Canvas;

// A function of the present GL context, NULL when it has none of this name.
typedef void *(*GlLoader)(const char *name);

// Needs a present context of GL 3.3 or later (core). False names what is missing.
Canvas *canvas_create(GlLoader loader, int width, int height, Error *error);
void canvas_free(Canvas *canvas);
bool canvas_resize(Canvas *canvas, int width, int height, Error *error);

void canvas_begin(Canvas *canvas, Rgba colour); // clears all to this
// What follows is drawn inside this rectangle (pixels, from the top left), seen by this camera.
void canvas_view(Canvas *canvas, int left, int top, int width, int height, const float projection[16]);

typedef enum { DRAW_POINTS = 0, DRAW_LINES = 1, DRAW_TRIANGLES = 4 } DrawKind; // OpenGL's numbers
typedef struct {
    DrawKind kind;
    bool additive;    // adds colour·alpha to what is there; otherwise covers (alpha blends)
    float exposure;   // factor on colours; 0 counts as 1
    float opacity;    // on alpha; 0 counts as 1
    float point_size; // pixels; 0 counts as 1
} DrawStyle;

// Vertices that stay in graphics memory from frame to frame.
typedef struct {
    unsigned array, buffer; // OpenGL's names; 0: nothing was uploaded yet
    size_t count;
    Vertex *kept; // a copy, where points are not drawn by OpenGL
} VertexBuffer;
void vertex_buffer_upload(Canvas *canvas, VertexBuffer *buffer, const Vertex *vertices, size_t count);
void vertex_buffer_free(Canvas *canvas, VertexBuffer *buffer);
// Vertices first … first+count−1, as many as there are.
void vertex_buffer_draw(Canvas *canvas, const VertexBuffer *buffer, size_t first, size_t count, const DrawStyle *style);
// For what changes with every frame.
void canvas_draw(Canvas *canvas, const Vertex *vertices, size_t count, const DrawStyle *style);

// UTF-8, line by line from the top left in pixels, in the system's DejaVu Sans; what it has no letter for shows as `?`, and a tab
// goes to the next column. Within the whole canvas, whatever canvas_view says. Scale 1, pixels:
#define EM          14.0f
#define LINE_HEIGHT 18.0f // from line to line
#define BASE_LINE   14.0f // from the top of a line to where its letters stand
void canvas_text(Canvas *canvas, float x, float y, float scale, Rgba colour, const char *text);
float canvas_text_width(float scale, const char *text); // of the widest line
// False: there is no such font here, and words are not drawn.
bool canvas_has_letters(void);
void canvas_rectangle(Canvas *canvas, float x, float y, float width, float height, Rgba colour);
// A picture of RGBA bytes, row 0 at the top, stretched over the rectangle.
void canvas_picture(Canvas *canvas, int x, int y, int width, int height, const uint8_t *rgba, int columns, int rows);

// Waits until all is drawn; RGBA rows from the top, width·height·4 bytes.
void canvas_read(Canvas *canvas, uint8_t *rgba);
// Waits until all is drawn.
void canvas_finish(Canvas *canvas);
// Copies the picture to the window's own framebuffer of this size.
void canvas_present(Canvas *canvas, int window_width, int window_height);
int canvas_width(const Canvas *canvas);
int canvas_height(const Canvas *canvas);
