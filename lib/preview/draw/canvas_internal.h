// What the files of the canvas share.
#pragma once

#include "preview/draw/canvas.h"

// The part of OpenGL 3.3 that the canvas uses. Types and constants are the header's; the functions are found at run time,
// a table for each context, since functions linked from libGL draw silently nothing in an OSMesa context.
#define GL_GLEXT_PROTOTYPES // declared for their types, and never called
#ifdef __APPLE__
#include <OpenGL/gl3.h>
#else
#include <GL/glcorearb.h>
#endif

// clang-format off
#define GL_FUNCTIONS(X) \
    X(AttachShader) X(BindBuffer) X(BindFramebuffer) X(BindRenderbuffer) X(BindTexture) X(BindVertexArray) \
    X(BlendFuncSeparate) X(BlitFramebuffer) X(BufferData) X(CheckFramebufferStatus) X(Clear) X(ClearColor) \
    X(CompileShader) X(CreateProgram) X(CreateShader) X(DeleteBuffers) X(DeleteFramebuffers) X(DeleteProgram) \
    X(DeleteRenderbuffers) X(DeleteShader) X(DeleteTextures) X(DeleteVertexArrays) X(Disable) X(DrawArrays) \
    X(Enable) X(EnableVertexAttribArray) X(Finish) X(FramebufferRenderbuffer) X(FramebufferTexture2D) \
    X(GenBuffers) X(GenFramebuffers) X(GenRenderbuffers) X(GenTextures) X(GenVertexArrays) X(GetError) \
    X(GetIntegerv) X(GetProgramInfoLog) X(GetProgramiv) X(GetString) X(GetUniformLocation) X(LinkProgram) \
    X(PixelStorei) X(PointSize) X(ReadPixels) X(RenderbufferStorage) X(Scissor) X(ShaderSource) X(TexImage2D) \
    X(TexParameteri) X(Uniform1f) X(UniformMatrix4fv) X(UseProgram) X(VertexAttribPointer) X(Viewport)
// clang-format on

#define GL_MEMBER(name) __typeof__(&gl##name) name;
typedef struct {
    GL_FUNCTIONS(GL_MEMBER)
} Gl;
#undef GL_MEMBER

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

// A program of two shaders, which begin behind the line `#version`; 0 with the compiler's words.
unsigned gl_program(const Gl *gl, const char *vertex_shader, const char *fragment_shader, Error *error);

// Sets viewport, scissor and projection.
void canvas_use_view(Canvas *canvas, const CanvasView *view);
// Pixels from the top left, over the whole canvas.
CanvasView canvas_flat_view(const Canvas *canvas);

// Pixels that the text's letters cover, its top left at (x, y); to be freed.
Vertex *text_vertices(float x, float y, float scale, Rgba colour, const char *text, size_t *count);
