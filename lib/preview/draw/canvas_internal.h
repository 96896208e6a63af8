// What the files of the canvas share.
#ifndef PHOTONLAB_PREVIEW_CANVAS_INTERNAL_H
#define PHOTONLAB_PREVIEW_CANVAS_INTERNAL_H

#include "preview/draw/gl.h"

// A rectangle of the framebuffer from its bottom left, and the projection into it.
typedef struct {
    int x, y, width, height;
    float projection[16];
} CanvasView;

// False: OpenGL shall do it.
typedef bool PointDrawer(Canvas *canvas, const Vertex *vertices, size_t count, const DrawStyle *style);

struct Canvas {
    Gl gl;
    PointDrawer *draw_points; // NULL: OpenGL does
    int width, height;
    unsigned framebuffer, colour; // 0: the context's own framebuffer, which somebody else sizes
    unsigned program;
    int projection, exposure, opacity; // its uniforms
    unsigned picture, texture;         // canvas_picture's: a framebuffer, and what it shows
    VertexBuffer stream;               // canvas_draw's
    CanvasView view;                   // as canvas_view set it
};

// Sets viewport, scissor and projection.
void canvas_use_view(Canvas *canvas, const CanvasView *view);
// Pixels from the top left, over the whole canvas.
CanvasView canvas_flat_view(const Canvas *canvas);

// Pixels that the text's letters cover, its top left at (x, y); to be freed.
Vertex *text_vertices(float x, float y, float scale, Rgba colour, const char *text, size_t *count);

#endif
