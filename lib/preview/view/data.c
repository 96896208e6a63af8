// One half's data, and lists of the vertices made of it.
#include "preview/view/view_internal.h"

#include "base/array.h"

#include <stdlib.h>

ViewData *view_data_create(Canvas *canvas, const Scene *scene)
{
    ViewData *data = calloc(1, sizeof *data);
    if (!data)
        return NULL;
    data->canvas = canvas;
    data->scene = scene;
    for (int i = 0; i < VIEW_COUNT; i++)
        if (!(data->made[i].found = calloc(1, view_types[i]->found_size + 1))) {
            view_data_free(data);
            return NULL;
        }
    return data;
}

static void forget_recording(ViewData *data)
{
    recording_free(&data->recording);
    photon_map_free(data->map);
    data->map = NULL;
}

void view_data_free(ViewData *data)
{
    if (!data)
        return;
    vertex_buffer_free(data->canvas, &data->wires);
    for (int i = 0; i < VIEW_COUNT; i++) {
        Made *made = &data->made[i];
        for (int j = 0; j < MOST_LISTS; j++)
            vertex_buffer_free(data->canvas, &made->lists[j]);
        free(made->found);
    }
    forget_recording(data);
    for (int i = 0; i < RUN_RENDER; i++)
        findings_free(&data->findings[i]);
    free(data);
}

static int compare_floats(const void *a, const void *b)
{
    float x = *(const float *)a, y = *(const float *)b;
    return x < y ? -1 : x > y;
}

// The power that nine of ten photons do not exceed: 1/N of all, whatever N is.
static float bright_power(const Recording *recording)
{
    enum { MOST = 4096 };
    float powers[MOST];
    size_t count = 0;
    for (int legs = 0; legs < 2 && count == 0; legs++) { // of the legs where all have left
        size_t all = legs ? recording->leg_count : recording->count, stride = legs ? 1 : all / MOST + 1;
        for (size_t i = 0; i < all && count < MOST; i += stride) {
            float power = colour_max(legs ? recording->legs[i].power : recording->photons[i].at.power);
            if (power > 0.0f && isfinite(power))
                powers[count++] = power;
        }
    }
    if (count == 0)
        return 1.0f;
    qsort(powers, count, sizeof *powers, compare_floats);
    return powers[count * 9 / 10];
}

void view_data_record(ViewData *data, Recording recording)
{
    forget_recording(data);
    data->recording = recording;
    data->come[RUN_PHOTONS]++;
    data->power = bright_power(&recording);
}

const Recording *view_data_recording(const ViewData *data)
{
    return &data->recording;
}

void view_data_find(ViewData *data, RunKind kind, Findings findings)
{
    findings_free(&data->findings[kind]);
    data->findings[kind] = findings;
    data->come[kind]++;
}

#define CIRCLE_PARTS 64

void vertices_free(Vertices *list)
{
    free(list->items);
    *list = (Vertices){.items = NULL};
}

bool vertices_reserve(Vertices *list, size_t more)
{
    return array_reserve(&list->items, list->count + more, &list->capacity, sizeof *list->items);
}

void vertices_point(Vertices *list, Vec3 at, Rgba colour)
{
    if (vertices_reserve(list, 1))
        list->items[list->count++] = (Vertex){at.x, at.y, at.z, colour.r, colour.g, colour.b, colour.a};
}

void vertices_fading(Vertices *list, Vec3 from, Vec3 to, Rgba start, Rgba end)
{
    if (!vertices_reserve(list, 2))
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
