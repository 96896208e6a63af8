// Buffers of vertices, and what is drawn flat over the picture.
#include "preview/draw/canvas_internal.h"

#include <stdlib.h>
#include <string.h>

void vertex_buffer_upload(Canvas *canvas, VertexBuffer *buffer, const Vertex *vertices, size_t count)
{
    const Gl *gl = &canvas->gl;
    if (!buffer->array) {
        gl->GenVertexArrays(1, &buffer->array);
        gl->GenBuffers(1, &buffer->buffer);
        gl->BindVertexArray(buffer->array);
        gl->BindBuffer(GL_ARRAY_BUFFER, buffer->buffer);
        gl->EnableVertexAttribArray(0);
        gl->EnableVertexAttribArray(1);
        gl->VertexAttribPointer(0, 3, GL_FLOAT, 0, sizeof(Vertex), NULL);
        gl->VertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, 1, sizeof(Vertex), (const void *)offsetof(Vertex, r));
    }
    gl->BindBuffer(GL_ARRAY_BUFFER, buffer->buffer);
    gl->BufferData(GL_ARRAY_BUFFER, (ptrdiff_t)(count * sizeof *vertices), vertices, GL_STATIC_DRAW);
    buffer->count = count;
    if (!canvas->draw_points)
        return;
    free(buffer->kept);
    if ((buffer->kept = malloc((count + 1) * sizeof *vertices)))
        memcpy(buffer->kept, vertices, count * sizeof *vertices);
}

void vertex_buffer_free(Canvas *canvas, VertexBuffer *buffer)
{
    canvas->gl.DeleteVertexArrays(1, &buffer->array); // 0 is no array, and nothing is done
    canvas->gl.DeleteBuffers(1, &buffer->buffer);
    free(buffer->kept);
    *buffer = (VertexBuffer){.array = 0};
}

void vertex_buffer_draw(Canvas *canvas, const VertexBuffer *buffer, size_t first, size_t count, const DrawStyle *style)
{
    if (first >= buffer->count || count == 0)
        return;
    if (count > buffer->count - first)
        count = buffer->count - first;
    if (style->kind == DRAW_POINTS && buffer->kept && canvas->draw_points(canvas, buffer->kept + first, count, style))
        return;
    const Gl *gl = &canvas->gl;
    // The picture itself stays opaque: alpha is kept at 1.
    gl->BlendFuncSeparate(GL_SRC_ALPHA, style->additive ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    gl->Uniform1f(canvas->exposure, style->exposure != 0 ? style->exposure : 1.0f);
    gl->Uniform1f(canvas->opacity, style->opacity != 0 ? style->opacity : 1.0f);
    if (style->kind == DRAW_POINTS)
        gl->PointSize(style->point_size != 0 ? style->point_size : 1.0f);
    gl->BindVertexArray(buffer->array);
    gl->DrawArrays(style->kind, (int)first, (int)count);
}

void canvas_draw(Canvas *canvas, const Vertex *vertices, size_t count, const DrawStyle *style)
{
    vertex_buffer_upload(canvas, &canvas->stream, vertices, count);
    vertex_buffer_draw(canvas, &canvas->stream, 0, count, style);
}

// In pixels, over all that was drawn.
static void draw_flat(Canvas *canvas, DrawKind kind, const Vertex *vertices, size_t count)
{
    CanvasView flat = canvas_flat_view(canvas);
    canvas_use_view(canvas, &flat);
    canvas_draw(canvas, vertices, count, &(DrawStyle){.kind = kind});
    canvas_use_view(canvas, &canvas->view);
}

void canvas_text(Canvas *canvas, float x, float y, float scale, Rgba colour, const char *text)
{
    size_t count;
    Vertex *vertices = text_vertices(x, y, scale, colour, text, &count);
    draw_flat(canvas, DRAW_POINTS, vertices, count);
    free(vertices);
}

void canvas_rectangle(Canvas *canvas, float x, float y, float width, float height, Rgba colour)
{
    static const int CORNERS[6] = {0, 1, 3, 0, 3, 2}; // bit 0: right, bit 1: bottom
    Vertex vertices[6];
    for (int i = 0; i < 6; i++) {
        float right = CORNERS[i] & 1 ? width : 0, down = CORNERS[i] & 2 ? height : 0;
        vertices[i] = (Vertex){x + right, y + down, 0, colour.r, colour.g, colour.b, colour.a};
    }
    draw_flat(canvas, DRAW_TRIANGLES, vertices, 6);
}

void canvas_picture(Canvas *canvas, int x, int y, int width, int height, const uint8_t *rgba, int columns, int rows)
{
    const Gl *gl = &canvas->gl;
    CanvasView flat = canvas_flat_view(canvas);
    canvas_use_view(canvas, &flat);
    gl->BindTexture(GL_TEXTURE_2D, canvas->texture);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, columns, rows, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, canvas->picture);
    gl->FramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, canvas->texture, 0);
    // OpenGL's rows begin at the bottom: upside down.
    gl->BlitFramebuffer(0, 0, columns, rows, x, canvas->height - y, x + width, canvas->height - y - height,
                        GL_COLOR_BUFFER_BIT, GL_LINEAR);
    gl->BindFramebuffer(GL_FRAMEBUFFER, canvas->framebuffer);
    canvas_use_view(canvas, &canvas->view);
}
