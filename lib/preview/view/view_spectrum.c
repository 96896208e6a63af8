// The light that lands on a material, by its wavelength.
#include "preview/view/view_internal.h"

#include "scene/limits.h"

#include <stdio.h>

enum { MATERIAL }; // settings: its number, −1: all
enum { BARS };     // lists

#define BANDS_OF_BIN  3 // as photons keep their wavelengths
#define BINS          ((256 - BAND_FIRST) / BANDS_OF_BIN)
#define BIN_WIDTH     (double)(BANDS_OF_BIN * BAND_WIDTH) // nm
#define LINES_OF_BIN  8
#define HEIGHT_TO_ONE 0.5f // of the highest bin, where the range of wavelengths is 1 across

typedef struct {
    double flux[BINS]; // W
    size_t photons;
    double highest; // W/nm
} Found;

// W that the photon carried, by its stored colour: the least squares over the three channels, backwards through what
// colour_of_flux in photons/pass/trace.c does.
static double flux_of(const Scene *scene, const StoredPhoton *photon, float wavelength)
{
    const Material *material = &scene->materials[photon->material];
    Colour wall = colour_add(material->diffuse, material->specular), hue = spectral_colour(wavelength);
    if (colour_max(wall) <= 0.0f)
        wall = colour_grey(1.0f);
    float share = reflectance_at(wall, wavelength);
    float along = colour_sum(colour_mul(colour_mul(photon->power, wall), hue));
    float square = colour_sum(colour_mul(hue, hue));
    return share > 0.0f && square > 0.0f ? (double)(along / (share * square)) : 0.0;
}

static void measure(const ViewData *data, int material, Found *found)
{
    *found = (Found){.photons = 0};
    for (size_t i = 0; i < data->recording.count; i++) {
        const StoredPhoton *photon = &data->recording.photons[i].at;
        float wavelength = wavelength_of_band(photon->colour);
        if (wavelength <= 0.0f || (material >= 0 && photon->material != material))
            continue;
        found->flux[(photon->colour - BAND_FIRST) / BANDS_OF_BIN] += flux_of(data->scene, photon, wavelength);
        found->photons++;
    }
    for (int bin = 0; bin < BINS; bin++)
        found->highest = fmax(found->highest, found->flux[bin] / BIN_WIDTH);
}

static void build(const View *view, ViewData *data, Vertices *lists)
{
    Found *found = data->made[VIEW_SPECTRUM].found;
    Vertices *bars = &lists[BARS];
    Rgba edge = {150, 160, 180, 255};
    measure(data, (int)view->settings[VIEW_SPECTRUM][MATERIAL], found);
    vertices_line(bars, vec3(-0.5f, 0, 0), vec3(0.5f, 0, 0), edge);
    for (int nm = 400; nm <= 700; nm += 50) { // marks below the bars
        float x = ((float)nm - WAVELENGTH_FIRST) / WAVELENGTH_RANGE - 0.5f;
        vertices_line(bars, vec3(x, 0, 0), vec3(x, -0.02f, 0), edge);
    }
    for (int i = 0; i < BINS * LINES_OF_BIN && found->highest > 0.0; i++) {
        float place = ((float)i + 0.5f) / (BINS * LINES_OF_BIN);
        double density = found->flux[i / LINES_OF_BIN] / BIN_WIDTH;
        float height = HEIGHT_TO_ONE * (float)fmax(density / found->highest, 0.0);
        Rgba hue = palette_photon(band_of_wavelength(WAVELENGTH_FIRST + place * WAVELENGTH_RANGE));
        vertices_line(bars, vec3(place - 0.5f, 0, 0), vec3(place - 0.5f, height, 0), hue);
    }
}

static void draw(const Pane *pane)
{
    pane_look_at_sheet(pane, (Box){{-0.5f, -0.05f, 0}, {0.5f, HEIGHT_TO_ONE, 0}});
    pane_draw(pane, BARS, (DrawStyle){.kind = DRAW_LINES});
}

static void describe(const View *view, const ViewData *data, char *text, size_t size)
{
    const Found *found = data->made[VIEW_SPECTRUM].found;
    int material = (int)view->settings[VIEW_SPECTRUM][MATERIAL];
    bool known = material >= 0 && (size_t)material < data->scene->material_count;
    if (found->photons == 0)
        snprintf(text, size, "no photon here has a single wavelength: --spectral gives them one");
    else
        snprintf(text, size, "light by wavelength on %s: %zu photons, at most %.3g W/nm; a mark every 50 nm from 400",
                 known ? data->scene->materials[material].name : "everything", found->photons, found->highest);
}

static void choose(View *view, const ViewData *data, bool sideways, int step)
{
    double *material = &view->settings[VIEW_SPECTRUM][MATERIAL];
    if (sideways)
        *material = wrap(*material + step, -1.0, (double)data->scene->material_count - 1.0);
}

const ViewType view_spectrum = {
    .help = "light by wavelength, with --spectral; --lands-on I, a material's number\n",
    .arrows = "material",
    .place = ON_A_SHEET,
    .settings = {{.flag = "lands-on", .kind = SETTING_WHOLE, .start = -1, .low = 0, .high = MAX_MATERIALS}},
    .build = build,
    .draw = draw,
    .describe = describe,
    .legend = legend_of_wavelengths,
    .choose = choose,
    .found_size = sizeof(Found),
};
