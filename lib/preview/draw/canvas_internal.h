// What the files of the canvas share.
#ifndef PHOTONLAB_PREVIEW_CANVAS_INTERNAL_H
#define PHOTONLAB_PREVIEW_CANVAS_INTERNAL_H

#include "preview/draw/gl.h"

// A rectangle of the framebuffer from its bottom left, and the projection into it.
typedef struct {
    int x, y, width, height;
    float projection[16];
} CanvasView;

struct Canvas {
    float background[3];
    Gl gl;
    int width, height;
    unsigned framebuffer, colour, depth;
    unsigned program; // of vertices
    int projection, exposure;
    unsigned picture_program; // of canvas_picture
    int place;
    unsigned texture, no_array; // a vertex array without vertices
    VertexBuffer stream;        // canvas_draw's
    CanvasView view;            // as canvas_view set it
    Vertex *text;               // canvas_text's triangles; grows
    size_t text_capacity;
};

// Sets viewport, scissor and projection.
void canvas_use_view(Canvas *canvas, const CanvasView *view);
// Pixels from the top left, over the whole canvas.
CanvasView canvas_flat_view(const Canvas *canvas);

// Triangles of the text's letters, at (x, y) in pixels; NULL for count 0. They stay until the next call.
const Vertex *text_vertices(Canvas *canvas, float x, float y, float scale, const uint8_t *rgba, const char *text,
                            size_t *count);

#endif
