// Mitsuba 3: XML. To be rendered by the variant scalar_rgb or llvm_ad_rgb, whose colours are three numbers like ours.
#include "scene/export/export.h"
#include "scene/material_kind.h"

#include <math.h>

static void put_three(const Export *e, const char *type, const char *name, Vec3 v)
{
    fprintf(e->stream, "<%s name=\"%s\" value=\"%.7g, %.7g, %.7g\"/>", type, name, v.x, v.y, v.z);
}

static void put_colour(const Export *e, const char *name, Colour c)
{
    put_three(e, "rgb", name, vec3(c.r, c.g, c.b));
}

static void put_float(const Export *e, const char *name, float value)
{
    fprintf(e->stream, "<float name=\"%s\" value=\"%.7g\"/>", name, value);
}

static void put_look(const Export *e, Vec3 from, Vec3 direction, Vec3 up)
{
    Vec3 to = vec3_add(from, direction);
    fprintf(
        e->stream,
        "<transform name=\"to_world\"><lookat origin=\"%.7g, %.7g, %.7g\" target=\"%.7g, %.7g, %.7g\" up=\"%.7g, %.7g, "
        "%.7g\"/></transform>",
        from.x, from.y, from.z, to.x, to.y, to.z, up.x, up.y, up.z);
}

// Its depth counts the lamp, and the way to the first surface, too.
static void begin(const Export *e, const RenderSettings *settings)
{
    const Camera *camera = &e->scene->camera;
    fprintf(
        e->stream,
        "<scene version=\"3.0.0\">\n<integrator type=\"path\"><integer name=\"max_depth\" value=\"%d\"/></integrator>\n",
        settings->depth + 2);
    fprintf(e->stream, "<sensor type=\"perspective\">\n<string name=\"fov_axis\" value=\"y\"/>");
    put_float(e, "fov", 2.0f * atanf(camera->tan_half_fov) * (180.0f / PI));
    put_float(e, "near_clip", 1e-4f * box_diagonal(bvh_bounds(e->scene->bvh)));
    put_look(e, camera->position, camera->forward, camera->up);
    fprintf(e->stream,
            "\n<sampler type=\"independent\"><integer name=\"sample_count\" value=\"%d\"/></sampler>\n"
            "<film type=\"hdrfilm\"><integer name=\"width\" value=\"%d\"/><integer name=\"height\" value=\"%d\"/>"
            "<string name=\"pixel_format\" value=\"rgb\"/><string name=\"component_format\" value=\"float32\"/>"
            "<rfilter type=\"box\"/></film>\n</sensor>\n",
            settings->samples, settings->width, settings->height);
}

static void put_matt(const Export *e, Colour reflectance)
{
    fprintf(e->stream, "<bsdf type=\"diffuse\">");
    put_colour(e, "reflectance", reflectance);
    fprintf(e->stream, "</bsdf>");
}

static void begin_twosided(const Export *e, const char *name)
{
    fprintf(e->stream, "<bsdf type=\"twosided\" id=\"%s\">", name);
}

static void put_diffuse(const Export *e, const char *name, Colour reflectance)
{
    begin_twosided(e, name);
    put_matt(e, reflectance);
    fprintf(e->stream, "</bsdf>\n");
}

static void put_glossy(const Export *e, const char *name, ExportGlossy glossy)
{
    begin_twosided(e, name);
    fprintf(e->stream, "<bsdf type=\"blendbsdf\">");
    put_float(e, "weight", glossy.share);
    put_matt(e, glossy.diffuse);
    fprintf(e->stream, "<bsdf type=\"roughconductor\"><string name=\"material\" value=\"none\"/>");
    put_float(e, "alpha", glossy.roughness);
    put_colour(e, "specular_reflectance", glossy.specular);
    fprintf(e->stream, "</bsdf></bsdf></bsdf>\n");
}

static void put_mirror(const Export *e, const char *name, const Material *material)
{
    begin_twosided(e, name);
    fprintf(e->stream, "<bsdf type=\"conductor\"><string name=\"material\" value=\"none\"/>");
    put_colour(e, "specular_reflectance", material->specular);
    fprintf(e->stream, "</bsdf></bsdf>\n");
}

static void put_glass(const Export *e, const char *name, const Material *material)
{
    if (material->disperses)
        export_note(e, "%s: %s's glass has one index: it has that for green, and does not disperse", material->name,
                    e->format->renderer);
    fprintf(e->stream, "<bsdf type=\"dielectric\" id=\"%s\">", name);
    put_float(e, "ext_ior", 1.0f);
    put_float(e, "int_ior", material->index[1]);
    fprintf(e->stream, "</bsdf>\n");
}

static void note_spectrum(const Export *e, const Light *light)
{
    if (light->spectrum)
        export_note(
            e, "a lamp's spectrum becomes its red, green and blue: so walls have more of their colours in its light");
}

static void end_shape(const Export *e, const char *name, const Light *lamp)
{
    if (lamp) {
        note_spectrum(e, lamp);
        put_matt(e, colour_grey(0.0f)); // which is black from behind, as a lamp is
        fprintf(e->stream, "<emitter type=\"area\">");
        put_colour(e, "radiance", lamp->radiance);
        fprintf(e->stream, "</emitter></shape>\n");
    } else {
        fprintf(e->stream, "<ref id=\"%s\"/></shape>\n", name);
    }
}

static void put_mesh(const Export *e, const char *file, bool has_normals, const char *name, const Light *lamp)
{
    fprintf(e->stream,
            "<shape type=\"ply\"><string name=\"filename\" value=\"%s\"/><boolean name=\"face_normals\" value=\"%s\"/>",
            file, has_normals ? "false" : "true");
    end_shape(e, name, lamp);
}

static void put_sphere(const Export *e, const Sphere *sphere, const char *name, const Light *lamp)
{
    fprintf(e->stream, "<shape type=\"sphere\">");
    put_three(e, "point", "center", sphere->centre);
    put_float(e, "radius", sphere->radius);
    end_shape(e, name, lamp);
}

static void put_light(const Export *e, const Light *light, Colour intensity)
{
    Vec3 d = light->direction;
    bool is_spot = light->type == LIGHT_SPOT;
    note_spectrum(e, light);
    fprintf(e->stream, "<emitter type=\"%s\">", is_spot ? "spot" : "point");
    if (is_spot) {
        put_float(e, "cutoff_angle", acosf(light->cos_cone) * (180.0f / PI));
        put_float(e, "beam_width", acosf(light->cos_cone) * (180.0f / PI)); // it does not fade towards its edge
        put_look(e, light->position, d, fabsf(d.y) < 0.9f ? vec3(0, 1, 0) : vec3(1, 0, 0));
    } else {
        put_three(e, "point", "position", light->position);
    }
    put_colour(e, "intensity", intensity);
    fprintf(e->stream, "</emitter>\n");
}

const ExportFormat export_mitsuba = {".xml",     "Mitsuba 3", "</scene>\n", begin,      put_diffuse, put_glossy,
                                     put_mirror, put_glass,   put_mesh,     put_sphere, put_light};
