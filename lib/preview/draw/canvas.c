#include "preview/draw/canvas_internal.h"

#include <stdlib.h>
#include <string.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

static const char VERTEX_SHADER[] = "layout(location = 0) in vec3 position;\n"
                                    "layout(location = 1) in vec4 colour;\n"
                                    "uniform mat4 projection;\n"
                                    "uniform float exposure, opacity, point_size;\n" // WebGL has no glPointSize
                                    "out vec4 shade;\n"
                                    "void main() {\n"
                                    "    gl_PointSize = point_size;\n"
                                    "    gl_Position = projection * vec4(position, 1.0);\n"
                                    "    shade = vec4(colour.rgb * exposure, colour.a * opacity);\n"
                                    "}\n";
static const char FRAGMENT_SHADER[] = "in vec4 shade;\n"
                                      "layout(location = 0) out vec4 result;\n"
                                      "void main() { result = shade; }\n";

// Fills the table from the present context. False, with what is missing, below OpenGL 3.3.
static bool gl_load(Gl *gl, GlLoader loader, Error *error)
{
    void *address;
#define LOAD(name)                                                                                                     \
    if (!(address = loader("gl" #name)))                                                                               \
        return error_set(error, "this OpenGL has no gl" #name "; the preview needs OpenGL 3.3");                       \
    memcpy(&gl->name, &address, sizeof address); // C99 has no cast to a function
    GL_FUNCTIONS(LOAD)
#undef LOAD
    int major = 0, minor = 0;
    gl->GetIntegerv(GL_MAJOR_VERSION, &major);
    gl->GetIntegerv(GL_MINOR_VERSION, &minor);
    if (10 * major + minor >= 33)
        return true;
    const unsigned char *version = gl->GetString(GL_VERSION);
    return error_set(error, "this is OpenGL %s; the preview needs 3.3",
                     version ? (const char *)version : "without a context");
}

// WebGL 2 is OpenGL ES 3.0: its shaders differ in their first lines only.
#ifdef __wasm__
static const char HEADER[] = "#version 300 es\nprecision highp float;\n";
#else
static const char HEADER[] = "#version 330 core\n";
#endif

unsigned gl_program(const Gl *gl, const char *vertex_shader, const char *fragment_shader, Error *error)
{
    unsigned program = gl->CreateProgram();
    for (int i = 0; i < 2; i++) {
        unsigned shader = gl->CreateShader(i == 0 ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
        gl->ShaderSource(shader, 2, (const char *const[]){HEADER, i == 0 ? vertex_shader : fragment_shader}, NULL);
        gl->CompileShader(shader);
        gl->AttachShader(program, shader);
        gl->DeleteShader(shader); // when the program goes
    }
    gl->LinkProgram(program);
    int linked = 0;
    gl->GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked)
        return program;
    char log[400] = "";
    gl->GetProgramInfoLog(program, sizeof log, NULL, log);
    gl->DeleteProgram(program);
    error_set(error, "OpenGL does not take the preview's shaders: %s", log);
    return 0;
}

// Software OpenGL takes and frees tens of megabytes with every frame. Handed back to the system, they would come again
// page by page, zeroed: a quarter of the time of a frame.
static void keep_freed_memory(void)
{
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
    mallopt(M_TRIM_THRESHOLD, 256 << 20);
    mallopt(M_TOP_PAD, 16 << 20);
#endif
}

Canvas *canvas_create(GlLoader loader, int width, int height, Error *error)
{
    Canvas *canvas = calloc(1, sizeof *canvas);
    if (!canvas) {
        error_set(error, "not enough memory");
        return NULL;
    }
    if (!gl_load(&canvas->gl, loader, error)) {
        free(canvas); // nothing was made, and nothing could be deleted
        return NULL;
    }
    keep_freed_memory();
    const Gl *gl = &canvas->gl;
#ifndef __wasm__ // a page's context has but one user, and a copy would take software WebGL half a frame's time
    gl->GenFramebuffers(1, &canvas->framebuffer);
    gl->GenRenderbuffers(1, &canvas->colour);
#endif
    gl->GenFramebuffers(1, &canvas->picture);
    gl->GenTextures(1, &canvas->texture);
    canvas->program = gl_program(gl, VERTEX_SHADER, FRAGMENT_SHADER, error);
    if (!canvas->program || !canvas_resize(canvas, width, height, error)) {
        canvas_free(canvas);
        return NULL;
    }
    canvas->projection = gl->GetUniformLocation(canvas->program, "projection");
    canvas->exposure = gl->GetUniformLocation(canvas->program, "exposure");
    canvas->opacity = gl->GetUniformLocation(canvas->program, "opacity");
    gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl->Disable(GL_DITHER);
    gl->Disable(GL_MULTISAMPLE);
    gl->Enable(GL_BLEND);
    canvas_begin(canvas, (Rgba){0, 0, 0, 255});
    return canvas;
}

void canvas_free(Canvas *canvas)
{
    if (!canvas)
        return;
    const Gl *gl = &canvas->gl;
    vertex_buffer_free(canvas, &canvas->stream);
    gl->DeleteFramebuffers(1, &canvas->framebuffer);
    gl->DeleteRenderbuffers(1, &canvas->colour);
    gl->DeleteFramebuffers(1, &canvas->picture);
    gl->DeleteTextures(1, &canvas->texture);
    gl->DeleteProgram(canvas->program);
    free(canvas);
}

// True when OpenGL has such a framebuffer and the memory for it.
static bool size_framebuffer(Canvas *canvas, int width, int height)
{
    const Gl *gl = &canvas->gl;
    if (!canvas->framebuffer)
        return true;
    while (gl->GetError()) // of earlier days
        ;
    gl->BindFramebuffer(GL_FRAMEBUFFER, canvas->framebuffer);
    gl->BindRenderbuffer(GL_RENDERBUFFER, canvas->colour);
    gl->RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
    gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, canvas->colour);
    return gl->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE && gl->GetError() == 0;
}

bool canvas_resize(Canvas *canvas, int width, int height, Error *error)
{
    if (width == canvas->width && height == canvas->height)
        return true;
    int most = 0;
    canvas->gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
    if (width < 1 || height < 1 || width > most || height > most)
        return error_set(error, "a picture of %d x %d pixels: this OpenGL draws 1 to %d each way", width, height, most);
    if (!size_framebuffer(canvas, width, height)) {
        if (canvas->width)
            size_framebuffer(canvas, canvas->width, canvas->height);
        return error_set(error, "OpenGL has no memory for a picture of %d x %d pixels", width, height);
    }
    canvas->width = width;
    canvas->height = height;
    return true;
}

void canvas_begin(Canvas *canvas, Rgba colour)
{
    const Gl *gl = &canvas->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, canvas->framebuffer);
    gl->Disable(GL_SCISSOR_TEST);
    gl->ClearColor((float)colour.r / 255.0f, (float)colour.g / 255.0f, (float)colour.b / 255.0f,
                   (float)colour.a / 255.0f);
    gl->Clear(GL_COLOR_BUFFER_BIT);
    gl->Enable(GL_SCISSOR_TEST);
    gl->UseProgram(canvas->program);
    canvas->view = canvas_flat_view(canvas);
    canvas_use_view(canvas, &canvas->view);
}

CanvasView canvas_flat_view(const Canvas *canvas)
{
    CanvasView view = {0, 0, canvas->width, canvas->height, {0}};
    view.projection[0] = 2.0f / (float)canvas->width;
    view.projection[5] = -2.0f / (float)canvas->height;
    view.projection[12] = -1.0f;
    view.projection[13] = view.projection[15] = 1.0f;
    return view;
}

void canvas_use_view(Canvas *canvas, const CanvasView *view)
{
    const Gl *gl = &canvas->gl;
    gl->Viewport(view->x, view->y, view->width, view->height);
    gl->Scissor(view->x, view->y, view->width, view->height);
    gl->UniformMatrix4fv(canvas->projection, 1, 0, view->projection);
}

void canvas_view(Canvas *canvas, int left, int top, int width, int height, const float projection[16])
{
    width = width > 0 ? width : 0;
    height = height > 0 ? height : 0;
    canvas->view = (CanvasView){left, canvas->height - top - height, width, height, {0}};
    memcpy(canvas->view.projection, projection, sizeof canvas->view.projection);
    canvas_use_view(canvas, &canvas->view);
}

void canvas_finish(Canvas *canvas)
{
    canvas->gl.Finish();
}

void canvas_read(Canvas *canvas, uint8_t *rgba)
{
    const Gl *gl = &canvas->gl;
    gl->Finish(); // OSMesa reads what is there, not what will be
    gl->BindFramebuffer(GL_FRAMEBUFFER, canvas->framebuffer);
    size_t row = (size_t)canvas->width * 4;
    // OpenGL's rows begin at the bottom.
    for (int y = 0; y < canvas->height; y++)
        gl->ReadPixels(0, canvas->height - 1 - y, canvas->width, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba + (size_t)y * row);
}

void canvas_present(Canvas *canvas, int window_width, int window_height)
{
    const Gl *gl = &canvas->gl;
    if (!canvas->framebuffer)
        return;
    gl->Disable(GL_SCISSOR_TEST); // which cuts blits, too
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, canvas->framebuffer);
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl->BlitFramebuffer(0, 0, canvas->width, canvas->height, 0, 0, window_width, window_height, GL_COLOR_BUFFER_BIT,
                        GL_NEAREST);
    gl->BindFramebuffer(GL_FRAMEBUFFER, canvas->framebuffer);
    gl->Enable(GL_SCISSOR_TEST);
}

int canvas_width(const Canvas *canvas)
{
    return canvas->width;
}

int canvas_height(const Canvas *canvas)
{
    return canvas->height;
}
