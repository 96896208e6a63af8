#include "cli/cli.h"
#include "scene/export/export.h"

#include <stdio.h>

static const char help[] =
    "usage: photonlab export SCENE -o OUT.xml|OUT.pbrt [flags]\n"
    "\n"
    "Writes a scene for another renderer, to check a picture from outside: .xml for Mitsuba 3, .pbrt for pbrt-v4. Meshes are written\n"
    "beside it, OUT_….ply. What the other cannot do, or does otherwise, is told. Compare with `photonlab render --integrator path`,\n"
    "and `photonlab diff`, which reads the others' .exr.\n"
    "\n"
    "  -o FILE       where to\n"
    "  --size WxH    pixels\n"
    "  --samples N   eye rays per pixel\n"
    "  --depth N     bounces after which a path is cut\n"
    "  --quiet       nothing is told\n";

static const char *file, *out;
static int size[2], samples, depth; // 0: as the scene says
static bool quiet;
static const Flag flags[] = {
    {"o", FLAG_TEXT, &out, 0, 0},
    {"size", FLAG_SIZE, size, 1, MOST_SIDE},
    {"samples", FLAG_INT, &samples, 1, MOST_SAMPLES},
    {"depth", FLAG_INT, &depth, 1, MOST_DEPTH},
    {"quiet", FLAG_PRESENT, &quiet, 0, 0},
};

static void print_note(const char *words)
{
    fprintf(stderr, "  %s\n", words);
}

static int run(void)
{
    Error error = {""};
    if (!out)
        return report_usage("photonlab export", "say where to write the scene: -o OUT.xml");
    if (!export_format(out, &error))
        return report_usage("photonlab export", "%s", error.message);
    Scene *scene = scene_load(file, &error);
    if (!scene)
        return report_error(&error);
    RenderSettings *s = &scene->settings;
    *s = (RenderSettings){.width = size[0] ? size[0] : s->width,
                          .height = size[1] ? size[1] : s->height,
                          .samples = samples ? samples : s->samples,
                          .depth = depth ? depth : s->depth};
    bool ok = export_write(scene, s, out, quiet ? NULL : print_note, &error);
    scene_free(scene);
    return ok ? 0 : report_error(&error);
}

const Command command_export = {
    .words = "write a scene for Mitsuba 3 or pbrt-v4",
    .line = {"photonlab export", help, "one scene file", flags, FLAG_COUNT(flags), 1, 1},
    .files = &file,
    .run = run,
};
