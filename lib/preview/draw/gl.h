// The part of OpenGL 3.3 that the canvas uses, found at run time. No header and no library of OpenGL is needed to build;
// and each context gets its own table, since functions linked from libGL draw silently nothing in an OSMesa context.
#ifndef PHOTONLAB_PREVIEW_GL_H
#define PHOTONLAB_PREVIEW_GL_H

#include "preview/draw/canvas.h"

// X(result, name, parameters). GLenum, GLbitfield and names of objects are unsigned; GLsizei, GLint are int;
// GLsizeiptr is ptrdiff_t.
#define GL_FUNCTIONS(X)                                                                                                \
    X(void, ActiveTexture, (unsigned unit))                                                                            \
    X(void, AttachShader, (unsigned program, unsigned shader))                                                         \
    X(void, BindBuffer, (unsigned target, unsigned buffer))                                                            \
    X(void, BindFramebuffer, (unsigned target, unsigned framebuffer))                                                  \
    X(void, BindRenderbuffer, (unsigned target, unsigned renderbuffer))                                                \
    X(void, BindTexture, (unsigned target, unsigned texture))                                                          \
    X(void, BindVertexArray, (unsigned array))                                                                         \
    X(void, BlendFuncSeparate, (unsigned source, unsigned target, unsigned source_alpha, unsigned target_alpha))       \
    X(void, BlitFramebuffer,                                                                                           \
      (int from_x0, int from_y0, int from_x1, int from_y1, int x0, int y0, int x1, int y1, unsigned mask,              \
       unsigned filter))                                                                                               \
    X(void, BufferData, (unsigned target, ptrdiff_t size, const void *data, unsigned usage))                           \
    X(unsigned, CheckFramebufferStatus, (unsigned target))                                                             \
    X(void, Clear, (unsigned mask))                                                                                    \
    X(void, ClearColor, (float r, float g, float b, float a))                                                          \
    X(void, CompileShader, (unsigned shader))                                                                          \
    X(unsigned, CreateProgram, (void))                                                                                 \
    X(unsigned, CreateShader, (unsigned kind))                                                                         \
    X(void, DeleteBuffers, (int count, const unsigned *buffers))                                                       \
    X(void, DeleteFramebuffers, (int count, const unsigned *framebuffers))                                             \
    X(void, DeleteProgram, (unsigned program))                                                                         \
    X(void, DeleteRenderbuffers, (int count, const unsigned *renderbuffers))                                           \
    X(void, DeleteShader, (unsigned shader))                                                                           \
    X(void, DeleteTextures, (int count, const unsigned *textures))                                                     \
    X(void, DeleteVertexArrays, (int count, const unsigned *arrays))                                                   \
    X(void, DepthFunc, (unsigned function))                                                                            \
    X(void, DepthMask, (unsigned char on))                                                                             \
    X(void, Disable, (unsigned what))                                                                                  \
    X(void, DrawArrays, (unsigned kind, int first, int count))                                                         \
    X(void, Enable, (unsigned what))                                                                                   \
    X(void, EnableVertexAttribArray, (unsigned place))                                                                 \
    X(void, Finish, (void))                                                                                            \
    X(void, FramebufferRenderbuffer, (unsigned target, unsigned attachment, unsigned kind, unsigned renderbuffer))     \
    X(void, GenBuffers, (int count, unsigned *buffers))                                                                \
    X(void, GenFramebuffers, (int count, unsigned *framebuffers))                                                      \
    X(void, GenRenderbuffers, (int count, unsigned *renderbuffers))                                                    \
    X(void, GenTextures, (int count, unsigned *textures))                                                              \
    X(void, GenVertexArrays, (int count, unsigned *arrays))                                                            \
    X(unsigned, GetError, (void))                                                                                      \
    X(void, GetIntegerv, (unsigned what, int *values))                                                                 \
    X(void, GetProgramInfoLog, (unsigned program, int size, int *length, char *log))                                   \
    X(void, GetProgramiv, (unsigned program, unsigned what, int *values))                                              \
    X(const unsigned char *, GetString, (unsigned what))                                                               \
    X(int, GetUniformLocation, (unsigned program, const char *name))                                                   \
    X(void, LinkProgram, (unsigned program))                                                                           \
    X(void, PixelStorei, (unsigned what, int value))                                                                   \
    X(void, PointSize, (float size))                                                                                   \
    X(void, ReadPixels, (int x, int y, int width, int height, unsigned format, unsigned type, void *pixels))           \
    X(void, RenderbufferStorage, (unsigned target, unsigned format, int width, int height))                            \
    X(void, Scissor, (int x, int y, int width, int height))                                                            \
    X(void, ShaderSource, (unsigned shader, int count, const char *const *strings, const int *lengths))                \
    X(void, TexImage2D,                                                                                                \
      (unsigned target, int level, int inner, int width, int height, int border, unsigned format, unsigned type,       \
       const void *pixels))                                                                                            \
    X(void, TexParameteri, (unsigned target, unsigned what, int value))                                                \
    X(void, Uniform1f, (int place, float value))                                                                       \
    X(void, Uniform4f, (int place, float x, float y, float z, float w))                                                \
    X(void, UniformMatrix4fv, (int place, int count, unsigned char transpose, const float *values))                    \
    X(void, UseProgram, (unsigned program))                                                                            \
    X(void, VertexAttribPointer,                                                                                       \
      (unsigned place, int size, unsigned type, unsigned char normalised, int stride, const void *offset))             \
    X(void, Viewport, (int x, int y, int width, int height))

#define GL_MEMBER(result, name, parameters) result(*name) parameters;
typedef struct {
    GL_FUNCTIONS(GL_MEMBER)
} Gl;
#undef GL_MEMBER

enum {
    GL_POINTS = 0x0000,
    GL_LINES = 0x0001,
    GL_TRIANGLES = 0x0004,
    GL_TRIANGLE_STRIP = 0x0005,

    GL_ZERO = 0,
    GL_ONE = 1,
    GL_SRC_ALPHA = 0x0302,
    GL_ONE_MINUS_SRC_ALPHA = 0x0303,
    GL_LEQUAL = 0x0203,
    GL_DEPTH_TEST = 0x0B71,
    GL_BLEND = 0x0BE2,
    GL_DITHER = 0x0BD0,
    GL_SCISSOR_TEST = 0x0C11,
    GL_MULTISAMPLE = 0x809D,

    GL_UNPACK_ALIGNMENT = 0x0CF5,
    GL_PACK_ALIGNMENT = 0x0D05,
    GL_UNSIGNED_BYTE = 0x1401,
    GL_FLOAT = 0x1406,
    GL_RGBA = 0x1908,
    GL_RGBA8 = 0x8058,
    GL_DEPTH_COMPONENT24 = 0x81A6,

    GL_RENDERER = 0x1F01,
    GL_VERSION = 0x1F02,
    GL_MAJOR_VERSION = 0x821B,
    GL_MINOR_VERSION = 0x821C,
    GL_MAX_RENDERBUFFER_SIZE = 0x84E8,

    GL_TEXTURE_2D = 0x0DE1,
    GL_NEAREST = 0x2600,
    GL_LINEAR = 0x2601,
    GL_TEXTURE_MAG_FILTER = 0x2800,
    GL_TEXTURE_MIN_FILTER = 0x2801,
    GL_TEXTURE_WRAP_S = 0x2802,
    GL_TEXTURE_WRAP_T = 0x2803,
    GL_CLAMP_TO_EDGE = 0x812F,
    GL_TEXTURE0 = 0x84C0,

    GL_ARRAY_BUFFER = 0x8892,
    GL_STREAM_DRAW = 0x88E0,
    GL_STATIC_DRAW = 0x88E4,
    GL_FRAGMENT_SHADER = 0x8B30,
    GL_VERTEX_SHADER = 0x8B31,
    GL_LINK_STATUS = 0x8B82,

    GL_READ_FRAMEBUFFER = 0x8CA8,
    GL_DRAW_FRAMEBUFFER = 0x8CA9,
    GL_FRAMEBUFFER = 0x8D40,
    GL_RENDERBUFFER = 0x8D41,
    GL_COLOR_ATTACHMENT0 = 0x8CE0,
    GL_DEPTH_ATTACHMENT = 0x8D00,
    GL_FRAMEBUFFER_COMPLETE = 0x8CD5,

    GL_DEPTH_BUFFER_BIT = 0x0100,
    GL_COLOR_BUFFER_BIT = 0x4000
};

// Fills the table from the present context. False, with what is missing, below OpenGL 3.3.
bool gl_load(Gl *gl, GlLoader loader, Error *error);

// A program of two shaders; 0 with the compiler's words.
unsigned gl_program(const Gl *gl, const char *vertex_shader, const char *fragment_shader, Error *error);

#endif
