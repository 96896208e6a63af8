// One half's data and what was made of it.
#include "preview/view/view_internal.h"

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

void view_data_free(ViewData *data)
{
    if (!data)
        return;
    vertex_buffer_free(data->canvas, &data->wires);
    for (int i = 0; i < VIEW_COUNT; i++) {
        Made *made = &data->made[i];
        for (int j = 0; j < MOST_LISTS; j++)
            vertex_buffer_free(data->canvas, &made->lists[j]);
        if (made->found && view_types[i]->free_found)
            view_types[i]->free_found(made->found);
        free(made->found);
    }
    recording_free(&data->recording);
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
    recording_free(&data->recording);
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
