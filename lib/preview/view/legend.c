// What the colours mean, at the right.
#include "preview/view/view_internal.h"

#include <stdio.h>
#include <string.h>

static int list_bounces(LegendEntry *entries)
{
    for (int i = 0; i < BOUNCE_COLOURS; i++) {
        entries[i].colour = palette_bounce(i);
        snprintf(entries[i].text, sizeof entries[i].text, "%s%d%s", i == 0 ? "bounces " : "", i,
                 i == BOUNCE_COLOURS - 1 ? " or more" : "");
    }
    return BOUNCE_COLOURS;
}

static int list_photons(LegendEntry *entries)
{
    for (int i = 0; i < 4; i++) {
        entries[i].colour = palette_photon(i);
        snprintf(entries[i].text, sizeof entries[i].text, "%s", photon_colour_name(i));
    }
    return 4;
}

// Rough ones where photons are stored; all where they fly to.
static int list_materials(const Scene *scene, bool all, LegendEntry *entries)
{
    int count = 0;
    for (size_t i = 0; i < scene->material_count && count < MOST_ENTRIES; i++) {
        const Material *material = &scene->materials[i];
        if (!all && !material_is_rough(material))
            continue;
        entries[count].colour = palette_material((int)i);
        snprintf(entries[count].text, sizeof entries[count].text, "%.24s", material->name);
        count++;
    }
    return count;
}

static int list_power(const ViewData *data, LegendEntry *entries)
{
    static const float PARTS[3] = {1.0f, 0.3f, 0.1f};
    if (data->recording.count == 0)
        return 0;
    for (int i = 0; i < 3; i++) {
        float power = PARTS[i] * data->power;
        entries[i].colour = rgba_of_power(colour_grey(power), data->power);
        snprintf(entries[i].text, sizeof entries[i].text, "%.2g W%s", (double)power, i == 0 ? " or more" : "");
    }
    return 3;
}

static int list_colours(const View *view, const ViewData *data, bool all_materials, LegendEntry *entries)
{
    switch (view->colour) {
    case COLOUR_POWER:
        return list_power(data, entries);
    case COLOUR_PHOTON:
        return list_photons(entries);
    case COLOUR_BOUNCE:
        return list_bounces(entries);
    case COLOUR_MATERIAL:
        return list_materials(data->scene, all_materials, entries);
    }
    return 0;
}

int legend_of_photons(const View *view, const ViewData *data, LegendEntry *entries)
{
    return list_colours(view, data, false, entries);
}

int legend_of_legs(const View *view, const ViewData *data, LegendEntry *entries)
{
    return list_colours(view, data, true, entries);
}

void legend_draw(Canvas *canvas, const View *view, const ViewData *data, float top)
{
    LegendEntry entries[MOST_ENTRIES];
    int (*list)(const View *, const ViewData *, LegendEntry *) = view_type(view)->legend;
    int count = list ? list(view, data, entries) : 0;
    if (count == 0)
        return;
    float scale = overlay_scale(canvas), line = 12.0f * scale, margin = 6.0f * scale, width = 0.0f;
    for (int i = 0; i < count; i++)
        width = fmaxf(width, canvas_text_width(scale, entries[i].text));
    float left = (float)canvas_width(canvas) - width - 2.0f * margin - line;
    canvas_rectangle(canvas, left, top, (float)canvas_width(canvas) - left, (float)count * line + 1.6f * margin,
                     (const uint8_t[4]){12, 15, 22, 150});
    for (int i = 0; i < count; i++) {
        float y = top + margin + (float)i * line;
        Rgba colour = entries[i].colour;
        colour.a = 255;
        canvas_rectangle(canvas, left + margin, y, 7.0f * scale, 7.0f * scale, (const uint8_t *)&colour);
        canvas_text(canvas, left + margin + line, y, scale, (const uint8_t *)&COLOUR_OF_TEXT, entries[i].text);
    }
}
