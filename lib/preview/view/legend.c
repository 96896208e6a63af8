// What the colours mean, at the right.
#include "preview/view/view_internal.h"

#include <stdio.h>
#include <string.h>

#define MOST_ENTRIES 12

typedef struct {
    Rgba colour;
    char text[40];
} Entry;

static int list_bounces(Entry *entries)
{
    for (int i = 0; i < BOUNCE_COLOURS; i++) {
        entries[i].colour = palette_bounce(i);
        snprintf(entries[i].text, sizeof entries[i].text, "%s%d%s", i == 0 ? "bounces " : "", i,
                 i == BOUNCE_COLOURS - 1 ? " or more" : "");
    }
    return BOUNCE_COLOURS;
}

static int list_photons(Entry *entries)
{
    for (int i = 0; i < 4; i++) {
        entries[i].colour = palette_photon(i);
        snprintf(entries[i].text, sizeof entries[i].text, "%s", photon_colour_name(i));
    }
    return 4;
}

// Rough ones where photons are stored; all where they fly to.
static int list_materials(const Scene *scene, bool all, Entry *entries)
{
    int count = 0;
    for (size_t i = 0; i < scene->material_count && count < MOST_ENTRIES; i++) {
        const Material *material = &scene->materials[i];
        if (!all && !material_is_rough(material))
            continue;
        entries[count].colour = palette_material((int)i);
        snprintf(entries[count].text, sizeof entries[count].text, "%.24s",
                 material->name[0]                  ? material->name
                 : material->type == MATERIAL_LIGHT ? "lamp"
                                                    : "(no name)");
        count++;
    }
    return count;
}

static int list_power(const Side *side, Entry *entries)
{
    static const float PARTS[3] = {1.0f, 0.3f, 0.1f};
    if (side->recording.count == 0)
        return 0;
    for (int i = 0; i < 3; i++) {
        float power = PARTS[i] * side->power;
        entries[i].colour = rgba_of_power(colour_grey(power), side->power);
        snprintf(entries[i].text, sizeof entries[i].text, "%.2g W%s", (double)power, i == 0 ? " or more" : "");
    }
    return 3;
}

static int list_lobe(Entry *entries)
{
    entries[0] = (Entry){{90, 200, 255, 255}, "the equation"};
    entries[1] = (Entry){{255, 205, 110, 255}, "samples"};
    entries[2] = (Entry){{235, 235, 245, 255}, "photon"};
    entries[3] = (Entry){{255, 130, 90, 255}, "mirror direction"};
    entries[4] = (Entry){{150, 235, 150, 255}, "normal"};
    return 5;
}

static int list_entries(const View *view, const Scene *scene, const Side *side, Entry *entries)
{
    if (view->kind == VIEW_LOBE)
        return list_lobe(entries);
    if (view->kind == VIEW_TREE)
        return 0; // one hue a cell
    switch (view->colour) {
    case COLOUR_POWER:
        return list_power(side, entries);
    case COLOUR_PHOTON:
        return list_photons(entries);
    case COLOUR_BOUNCE:
        return list_bounces(entries);
    case COLOUR_MATERIAL:
        return list_materials(scene, view->kind == VIEW_PATHS, entries);
    }
    return 0;
}

void legend_draw(Canvas *canvas, const View *view, const Scene *scene, const Side *side, float top)
{
    Entry entries[MOST_ENTRIES];
    int count = list_entries(view, scene, side, entries);
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
