// Points, where WebGL runs in software: it takes a microsecond for each, and this loop a hundredth of that. What they add up to
// comes into the picture as one rectangle with a texture.
#include "preview/draw/canvas_internal.h"
#include "web/module/web.h"

#include <stdlib.h>

static const char VERTEX_SHADER[] = "out vec2 place;\n"
                                    "void main() {\n" // a triangle with the rectangle in it
                                    "    place = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;\n"
                                    "    gl_Position = vec4(2.0 * place - 1.0, 0.0, 1.0);\n"
                                    "}\n";
static const char FRAGMENT_SHADER[] = "uniform sampler2D sums;\n"
                                      "in vec2 place;\n"
                                      "layout(location = 0) out vec4 result;\n"
                                      "void main() { result = texture(sums, place); }\n";

bool IMPORT(photonlab_software)(void);

static struct {
    unsigned program, texture;
    uint32_t *rgba; // a view's sums, from its bottom left
    size_t size;
    int left, bottom, right, top; // what of it is not black
} sums;

static int between(int low, int value, int high)
{
    return value < low ? low : value > high ? high : value;
}

// The sums of four bytes each, none above 255.
static uint32_t add_bytes(uint32_t a, uint32_t b)
{
    const uint32_t high = 0x80808080u;
    uint32_t sum = ((a & ~high) + (b & ~high)) ^ ((a ^ b) & high);
    uint32_t over = ((a & b) | ((a | b) & ~sum)) & high;
    return sum | ((over >> 7) * 255u);
}

// Red, green and blue as shaders and blending have them; four bytes.
static uint32_t light_of(const Vertex *v, const DrawStyle *style)
{
    float exposure = style->exposure != 0 ? style->exposure : 1.0f,
          opacity = style->opacity != 0 ? style->opacity : 1.0f;
    float alpha = (float)v->a / 255.0f * opacity, colour[3] = {(float)v->r, (float)v->g, (float)v->b};
    alpha = alpha < 1.0f ? alpha : 1.0f;
    uint32_t light = 0;
    for (int i = 0; i < 3; i++) {
        float exposed = colour[i] * exposure;
        light |= (uint32_t)((exposed < 255.0f ? exposed : 255.0f) * alpha + 0.5f) << 8 * i;
    }
    return light;
}

// To the pixels whose middles lie in the square about where it is seen; OpenGL's rules.
static void add_point(const CanvasView *view, const Vertex *v, const DrawStyle *style)
{
    const float *m = view->projection, half = 0.5f * (style->point_size != 0 ? style->point_size : 1.0f);
    float clip[4];
    for (int i = 0; i < 4; i++)
        clip[i] = m[i] * v->x + m[4 + i] * v->y + m[8 + i] * v->z + m[12 + i];
    float most = clip[3]; // of x, y and z, if it is to be seen
    if (!(most > 0.0f && fabsf(clip[0]) <= most && fabsf(clip[1]) <= most && fabsf(clip[2]) <= most))
        return;
    float x = (0.5f + 0.5f * clip[0] / most) * (float)view->width - 0.5f;
    float y = (0.5f + 0.5f * clip[1] / most) * (float)view->height - 0.5f;
    int left = between(0, (int)ceilf(x - half), view->width), right = between(0, (int)ceilf(x + half), view->width);
    int bottom = between(0, (int)ceilf(y - half), view->height), top = between(0, (int)ceilf(y + half), view->height);
    uint32_t light = light_of(v, style);
    for (int row = bottom; row < top; row++)
        for (int column = left; column < right; column++) {
            uint32_t *sum = &sums.rgba[row * view->width + column];
            *sum = add_bytes(*sum, light);
        }
    sums.left = left < sums.left ? left : sums.left;
    sums.bottom = bottom < sums.bottom ? bottom : sums.bottom;
    sums.right = right > sums.right ? right : sums.right;
    sums.top = top > sums.top ? top : sums.top;
}

// Into the picture, and all of OpenGL's state as it was.
static void add_to_picture(Canvas *canvas)
{
    const Gl *gl = &canvas->gl;
    const CanvasView *view = &canvas->view;
    int width = sums.right - sums.left, height = sums.top - sums.bottom;
    const uint32_t *first = &sums.rgba[sums.bottom * view->width + sums.left];
    gl->BindTexture(GL_TEXTURE_2D, sums.texture);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl->PixelStorei(GL_UNPACK_ROW_LENGTH, view->width);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, first);
    gl->PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    gl->BlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);
    gl->UseProgram(sums.program);
    gl->BindVertexArray(0);
    gl->Viewport(view->x + sums.left, view->y + sums.bottom, width, height);
    gl->DrawArrays(GL_TRIANGLES, 0, 3);
    gl->UseProgram(canvas->program);
    canvas_use_view(canvas, view);
}

static bool draw_points(Canvas *canvas, const Vertex *vertices, size_t count, const DrawStyle *style)
{
    const CanvasView *view = &canvas->view;
    size_t size = 4 * (size_t)view->width * (size_t)view->height;
    if (!style->additive)
        return false;
    if (size > sums.size) {
        free(sums.rgba);
        sums.rgba = malloc(size);
        sums.size = sums.rgba ? size : 0;
    }
    if (!sums.rgba)
        return false;
    memset(sums.rgba, 0, size);
    sums.left = view->width;
    sums.bottom = view->height;
    sums.right = sums.top = 0;
    for (size_t i = 0; i < count; i++)
        add_point(view, &vertices[i], style);
    if (sums.right > sums.left && sums.top > sums.bottom)
        add_to_picture(canvas);
    return true;
}

void web_draw_points(Canvas *canvas)
{
    Error error; // then OpenGL does it
    if (!photonlab_software())
        return;
    sums.program = gl_program(&canvas->gl, VERTEX_SHADER, FRAGMENT_SHADER, &error);
    canvas->gl.GenTextures(1, &sums.texture);
    canvas->draw_points = sums.program ? draw_points : NULL;
}
