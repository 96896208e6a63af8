// Chapters 3 and 6: rays through glass, in a plane, and the colours of wavelengths.
#include "scene/glass_catalogue.h"
#include "web/figures/numbers.h"

#define DEGREES (180.0 / (double)PI)

static Vec3 at_angle(double degrees)
{
    return vec3((float)cos(degrees / DEGREES), (float)sin(degrees / DEGREES), 0.0f);
}

static double turned(Vec3 a, Vec3 b) // from a to b, counter-clockwise positive
{
    return DEGREES * atan2((double)(a.x * b.y - a.y * b.x), (double)(a.x * b.x + a.y * b.y));
}

static void add_vector(Vec3 v)
{
    numbers_add_two((double)v.x, (double)v.y);
}

static float index_of(const char *glass, double nm)
{
    const SellmeierGlass *found = glass_find(glass);
    return found ? (float)glass_index(found, nm) : 1.5f;
}

// ---- one surface ----

// Reflectance at 0, 1, … 90 degrees to the normal by step 3.2; then at this angle; then the direction of what gets through
// by step 3.1 (0, 0: nothing does). The light comes from above, and the normal is +y; `inside`: out of the glass.
int EXPORT(web_surface)(float index, float angle, bool inside)
{
    float eta = inside ? index : 1.0f / index;
    numbers_begin();
    for (int i = 0; i <= 91; i++) {
        double at = i <= 90 ? i : (double)angle;
        numbers_add((double)steps.fresnel((float)cos(at / DEGREES), eta));
    }
    Vec3 through = vec3(0, 0, 0);
    if (!steps.refract(at_angle((double)angle - 90.0), vec3(0, 1, 0), eta, &through))
        through = vec3(0, 0, 0);
    add_vector(through);
    return numbers_count();
}

// ---- the prism ----

// Where a ray from `from` meets the line through `on` with this normal: how far away, 0 or less: it does not.
static float meets(Vec3 from, Vec3 direction, Vec3 on, Vec3 normal)
{
    float toward = vec3_dot(direction, normal);
    return toward == 0.0f ? -1.0f : vec3_dot(vec3_sub(on, from), normal) / toward;
}

// One ray through a prism whose apex is at (0, 0), the base below: index, where it comes in, where it comes to the second
// face, its direction behind it (0, 0: total reflection, or the base is in the way), and by how much it is turned, degrees.
static void add_ray(float index, double apex, double incidence)
{
    Vec3 left = at_angle(180.0 - 0.5 * apex), right = at_angle(0.5 * apex);
    Vec3 along = at_angle(270.0 - 0.5 * apex), enters = vec3_scale(along, 0.5f); // down the left face, of length 1
    Vec3 coming = at_angle(incidence - 0.5 * apex), inside = vec3(0, 0, 0), out = vec3(0, 0, 0);
    steps.refract(coming, left, 1.0f / index, &inside);
    float far = meets(enters, inside, vec3(0, 0, 0), right);
    Vec3 leaves = vec3_along(enters, inside, far);
    bool through =
        far > 0.0f && vec3_dot(leaves, leaves) <= 1.0f && steps.refract(inside, vec3_negate(right), index, &out);
    if (!through && !(far > 0.0f && vec3_dot(leaves, leaves) <= 1.0f)) { // to the base
        far = meets(enters, inside, along, vec3(0, -1, 0));
        leaves = vec3_along(enters, inside, far);
    }
    numbers_add((double)index);
    add_vector(enters);
    add_vector(leaves);
    add_vector(through ? out : vec3(0, 0, 0));
    numbers_add(through ? fabs(turned(coming, out)) : (double)NAN);
}

// Angles in degrees. Three rays at the wavelengths of red, green and blue, then `lines` from 700 to 400 nm: eight numbers each.
int EXPORT(web_prism)(const char *glass, float apex, float incidence, int lines)
{
    static const double bands[] = {WAVELENGTH_RED, WAVELENGTH_GREEN, WAVELENGTH_BLUE};
    numbers_begin();
    for (int i = 0; i < 3 + lines; i++) {
        double nm = i < 3 ? bands[i] : 700.0 - 300.0 * (i - 3) / (lines > 1 ? lines - 1 : 1);
        add_ray(index_of(glass, nm), (double)apex, (double)incidence);
    }
    return numbers_count();
}

// ---- a drop ----

// A ray into a ball of radius 1 about (0, 0), flying along +x at height b: where it enters, is reflected and leaves, its
// direction then, by how much that is down from straight back (degrees), and the share of light that goes this way.
static void add_drop(float index, float b)
{
    Vec3 coming = vec3(1, 0, 0), enters = vec3(-sqrtf(1.0f - b * b), b, 0), inside, out;
    steps.refract(coming, enters, 1.0f / index, &inside);
    Vec3 back = vec3_along(enters, inside, -2.0f * vec3_dot(inside, enters));
    Vec3 returning = steps.reflect(inside, vec3_negate(back));
    Vec3 leaves = vec3_along(back, returning, -2.0f * vec3_dot(returning, back));
    float in = -vec3_dot(coming, enters), through = vec3_dot(returning, leaves);
    float share = (1.0f - steps.fresnel(in, 1.0f / index)) * steps.fresnel(vec3_dot(inside, back), index) *
                  (1.0f - steps.fresnel(through, index));
    if (!steps.refract(returning, vec3_negate(leaves), index, &out))
        out = returning;
    add_vector(enters);
    add_vector(back);
    add_vector(leaves);
    add_vector(out);
    numbers_add(turned(vec3(-1, 0, 0), out));
    numbers_add((double)share);
}

// Ten numbers each: rays of this wavelength at heights 0, 0.01, … 0.99, then the one at b.
int EXPORT(web_drop)(double nm, float b)
{
    float index = index_of("water_20C", nm);
    numbers_begin();
    for (int i = 0; i <= 100; i++)
        add_drop(index, i < 100 ? 0.01f * (float)i : b);
    return numbers_count();
}

// ---- wavelengths ----

// From 380 nm on, each nm to 730: red, green, blue of step 6.3, and the weight of step 6.2's draw there.
int EXPORT(web_wavelengths)(void)
{
    enum { LINES = SPECTRUM_SIZE, DRAWS = 8000 };
    static float weight_at[LINES];
    numbers_begin();
    for (int i = 0; i < DRAWS; i++) { // close enough that each nm gets some
        float weight, nm = steps.draw_wavelength((float)i / DRAWS, &weight);
        weight_at[(int)fminf(nm - WAVELENGTH_FIRST + 0.5f, LINES - 1)] = weight;
    }
    for (int i = 0; i < LINES; i++) {
        Colour seen = steps.wavelength_colour(WAVELENGTH_FIRST + (float)i);
        numbers_add_two((double)seen.r, (double)seen.g);
        numbers_add_two((double)seen.b, (double)weight_at[i]);
    }
    return numbers_count();
}

// The index of a glass of the catalogue at 380, 381, … 730 nm.
int EXPORT(web_glass)(const char *glass)
{
    numbers_begin();
    for (int nm = (int)WAVELENGTH_FIRST; nm <= (int)WAVELENGTH_LAST; nm++)
        numbers_add((double)index_of(glass, nm));
    return numbers_count();
}
