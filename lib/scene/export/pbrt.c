// pbrt-v4: its own text. It renders by wavelength, so glass gets its index over wavelength, and lamps their spectra.
#include "scene/export/export.h"
#include "scene/material_kind.h"

#include <math.h>

// Wavelengths that pbrt draws from, nm; its tables are 0 beyond their ends.
#define FIRST_NM 360
#define LAST_NM  830

static void put_float(const Export *e, const char *name, float value)
{
    fprintf(e->stream, " \"float %s\" [%.7g]", name, value);
}

static void put_colour(const Export *e, const char *name, Colour c)
{
    fprintf(e->stream, " \"rgb %s\" [%.7g %.7g %.7g]", name, c.r, c.g, c.b);
}

static void put_point(const Export *e, const char *name, Vec3 p)
{
    fprintf(e->stream, " \"point3 %s\" [%.7g %.7g %.7g]", name, p.x, p.y, p.z);
}

// Its camera looks along +z with x to the right and y up, which is left-handed: hence the first line. Its field of view is that of
// the shorter side.
static void begin(const Export *e, const RenderSettings *settings)
{
    const Camera *camera = &e->scene->camera;
    Vec3 from = camera->position, to = vec3_add(from, camera->forward), up = camera->up;
    float aspect = (float)settings->width / (float)settings->height;
    float tangent = camera->tan_half_fov * fminf(1.0f, aspect);
    fprintf(e->stream, "Scale -1 1 1\nLookAt %.7g %.7g %.7g  %.7g %.7g %.7g  %.7g %.7g %.7g\nCamera \"perspective\"",
            from.x, from.y, from.z, to.x, to.y, to.z, up.x, up.y, up.z);
    put_float(e, "fov", 2.0f * atanf(tangent) * (180.0f / PI));
    fprintf(
        e->stream,
        "\nFilm \"rgb\" \"integer xresolution\" [%d] \"integer yresolution\" [%d] \"string filename\" [\"pbrt.exr\"]\n"
        "PixelFilter \"box\" \"float xradius\" [0.5] \"float yradius\" [0.5]\n"
        "Sampler \"independent\" \"integer pixelsamples\" [%d]\nIntegrator \"path\" \"integer maxdepth\" [%d]\nWorldBegin\n",
        settings->width, settings->height, settings->samples, settings->depth + 1);
    export_note(
        e,
        "%s renders by wavelength, and its white is daylight: colours differ a little, the more often light is reflected",
        e->format->renderer);
}

static void name_material(const Export *e, const char *name, const char *type)
{
    fprintf(e->stream, "MakeNamedMaterial \"%s\" \"string type\" [\"%s\"]", name, type);
}

static void put_diffuse(const Export *e, const char *name, Colour reflectance)
{
    name_material(e, name, "diffuse");
    put_colour(e, "reflectance", reflectance);
    fprintf(e->stream, "\n");
}

static void put_conductor(const Export *e, const char *name, Colour reflectance, float roughness)
{
    name_material(e, name, "conductor");
    put_colour(e, "reflectance", reflectance);
    put_float(e, "roughness", roughness);
    fprintf(e->stream, " \"bool remaproughness\" [false]\n");
}

static void put_glossy(const Export *e, const char *name, ExportGlossy glossy)
{
    char matt[120], lobe[120];
    snprintf(matt, sizeof matt, "%s.matt", name);
    snprintf(lobe, sizeof lobe, "%s.lobe", name);
    put_diffuse(e, matt, glossy.diffuse);
    put_conductor(e, lobe, glossy.specular, glossy.roughness);
    name_material(e, name, "mix");
    fprintf(e->stream, " \"string materials\" [\"%s\" \"%s\"]", matt, lobe);
    put_float(e, "amount", glossy.share); // of the second
    fprintf(e->stream, "\n");
}

static void put_mirror(const Export *e, const char *name, const Material *material)
{
    export_note(e, "%s: %s's mirrors are metals, which reflect more at grazing angles", material->name,
                e->format->renderer);
    put_conductor(e, name, material->specular, 0.0f);
}

static void put_glass(const Export *e, const char *name, const Material *material)
{
    name_material(e, name, "dielectric");
    if (!material->disperses) {
        put_float(e, "eta", material->index[1]);
    } else {
        fprintf(e->stream, " \"spectrum eta\" [");
        for (int nm = FIRST_NM; nm <= LAST_NM; nm += 10) {
            double micrometres = nm / 1000.0;
            double index = material->sellmeier ? glass_index(material->sellmeier, nm)
                                               : (double)material->cauchy[0] +
                                                     (double)material->cauchy[1] / (micrometres * micrometres);
            fprintf(e->stream, " %d %.7g", nm, index);
        }
        fprintf(e->stream, " ]");
    }
    fprintf(e->stream, "\n");
}

// pbrt scales a table to luminance 1, which `scale` then multiplies. A line becomes a band, or pbrt would hardly ever draw it.
static void put_emission(const Export *e, const char *name, const Light *light, Colour colour)
{
    const Spectrum *spectrum = light->spectrum;
    if (!spectrum) {
        put_colour(e, name, colour);
        return;
    }
    fprintf(e->stream, " \"spectrum %s\" [", name);
    if (spectrum->line > 0.0f) {
        double line = (double)spectrum->line;
        fprintf(e->stream, " %.7g 0 %.7g 1 %.7g 0", line - 3.0, line, line + 3.0);
        export_note(e, "a lamp's line at %.7g nm becomes a band of 6 nm", line);
    }
    for (int nm = (int)WAVELENGTH_FIRST; nm <= (int)WAVELENGTH_LAST && spectrum->line <= 0.0f; nm += 5)
        fprintf(e->stream, " %d %.6g", nm, light_power_at(light, (float)nm));
    fprintf(e->stream, " ]");
    put_float(e, "scale", 0.2126f * colour.r + 0.7152f * colour.g + 0.0722f * colour.b);
}

static void begin_shape(const Export *e, const char *name, const Light *lamp)
{
    fprintf(e->stream, "AttributeBegin\n");
    if (!lamp) {
        fprintf(e->stream, "NamedMaterial \"%s\"\n", name);
        return;
    }
    fprintf(e->stream, "Material \"diffuse\" \"rgb reflectance\" [0 0 0]\nAreaLightSource \"diffuse\"");
    put_emission(e, "L", lamp, lamp->radiance);
    fprintf(e->stream, "\n");
}

static void put_mesh(const Export *e, const char *file, bool has_normals, const char *name, const Light *lamp)
{
    (void)has_normals; // the file says
    begin_shape(e, name, lamp);
    fprintf(e->stream, "Shape \"plymesh\" \"string filename\" [\"%s\"]\nAttributeEnd\n", file);
}

static void put_sphere(const Export *e, const Sphere *sphere, const char *name, const Light *lamp)
{
    begin_shape(e, name, lamp);
    fprintf(e->stream, "Translate %.7g %.7g %.7g\nShape \"sphere\"", sphere->centre.x, sphere->centre.y,
            sphere->centre.z);
    put_float(e, "radius", sphere->radius);
    fprintf(e->stream, "\nAttributeEnd\n");
}

static void put_light(const Export *e, const Light *light, Colour intensity)
{
    bool is_spot = light->type == LIGHT_SPOT;
    fprintf(e->stream, "LightSource \"%s\"", is_spot ? "spot" : "point");
    if (is_spot) {
        put_float(e, "coneangle", acosf(light->cos_cone) * (180.0f / PI));
        put_float(e, "conedeltaangle", 0.0f); // it does not fade towards its edge
        put_point(e, "to", vec3_add(light->position, light->direction));
    }
    put_point(e, "from", light->position);
    put_emission(e, "I", light, intensity);
    fprintf(e->stream, "\n");
}

const ExportFormat export_pbrt = {".pbrt",    "pbrt-v4", "",       begin,      put_diffuse, put_glossy,
                                  put_mirror, put_glass, put_mesh, put_sphere, put_light};
