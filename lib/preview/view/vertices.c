// Lists of vertices.
#include "preview/view/view_internal.h"

#include "base/array.h"

#include <stdlib.h>

#define CIRCLE_PARTS 64

void vertices_free(Vertices *list)
{
    free(list->items);
    *list = (Vertices){.items = NULL};
}

static bool reserve(Vertices *list, size_t more)
{
    return array_reserve(&list->items, list->count + more, &list->capacity, sizeof *list->items);
}

void vertices_point(Vertices *list, Vec3 at, Rgba colour)
{
    if (reserve(list, 1))
        list->items[list->count++] = (Vertex){at.x, at.y, at.z, colour.r, colour.g, colour.b, colour.a};
}

void vertices_fading(Vertices *list, Vec3 from, Vec3 to, Rgba start, Rgba end)
{
    if (!reserve(list, 2))
        return;
    vertices_point(list, from, start);
    vertices_point(list, to, end);
}

void vertices_line(Vertices *list, Vec3 from, Vec3 to, Rgba colour)
{
    vertices_fading(list, from, to, colour, colour);
}

void vertices_circle(Vertices *list, Vec3 centre, Vec3 across, Vec3 along, float radius, Rgba colour)
{
    Vec3 last = vec3_along(centre, across, radius);
    for (int i = 1; i <= CIRCLE_PARTS; i++) {
        float angle = 2.0f * PI * (float)i / CIRCLE_PARTS;
        Vec3 next = vec3_along(vec3_along(centre, across, radius * cosf(angle)), along, radius * sinf(angle));
        vertices_line(list, last, next, colour);
        last = next;
    }
}

void vertices_box(Vertices *list, Box box, Rgba colour)
{
    for (int i = 0; i < 8; i++)
        for (int axis = 1; axis < 8; axis *= 2)
            if (!(i & axis))
                vertices_line(list, box_corner(box, i), box_corner(box, i | axis), colour);
}

void vertices_upload(Vertices *list, Canvas *canvas, VertexBuffer *buffer)
{
    vertex_buffer_upload(canvas, buffer, list->items, list->count);
    vertices_free(list);
}
