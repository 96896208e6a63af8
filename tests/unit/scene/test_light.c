// Light sources: what the eye pass reckons from them (light_sample) is what their photons bring (light_emit).
#include "unit/test_common.h"

// The lights come behind it.
#define BLACK_BALL                                                                                                     \
    "camera: {position: [0, 0, 3], target: [0, 0, 0], vertical_fov: 40}\n"                                             \
    "materials: [{name: black, type: diffuse, reflectance: [0, 0, 0]}]\n"                                              \
    "shapes: [{type: sphere, centre: [9, 9, 9], radius: 1, material: black}]\n"                                        \
    "lights:\n"

static const char five_lights[] =
    BLACK_BALL "  - {type: rectangle, corner: [-0.3, 0.1, 1], edge_u: [0.1, 0.5, 0.1], edge_v: [0.6, 0, 0], radiance: "
               "[2, 4, 8]}\n"
               "  - {type: sphere, centre: [0.1, 0.2, 1], radius: 0.4, radiance: [2, 4, 8]}\n"
               "  - {type: point, position: [0.1, 0.2, 1], power: [2, 4, 8]}\n"
               "  - {type: spot, position: [0.1, 0.2, 1], target: [0.1, 0, 0], angle: 25, power: [2, 4, 8]}\n"
               "  - {type: beam, position: [0.1, 0.2, 1], target: [0, 0, 0], radius: 0.4, power: [2, 4, 8]}\n";

// A round window that light falls through.
typedef struct {
    Vec3 centre, normal;
    float radius;
} Window;

static Mean sampled_irradiance(const Light *light, const Window *window, Rng *rng, long count)
{
    Frame frame = frame_about(window->normal);
    Mean mean = {0};
    for (long i = 0; i < count; i++) {
        float r = window->radius * sqrtf(rng_float(rng));
        float phi = 2.0f * PI * rng_float(rng);
        Vec3 point = vec3_along(window->centre, frame.tangent, r * cosf(phi));
        point = vec3_along(point, frame.bitangent, r * sinf(phi));
        float u = rng_float(rng);
        float v = rng_float(rng);
        LightSample sample;
        double irradiance = 0.0;
        if (light_sample(light, point, u, v, &sample))
            irradiance = (double)(sample.arriving.r * fmaxf(0.0f, vec3_dot(sample.wi, window->normal)));
        mean_add(&mean, irradiance);
    }
    return mean;
}

static Mean emitted_irradiance(const Light *light, const Window *window, Rng *rng, long count)
{
    Mean mean = {0};
    double area = M_PI * (double)(window->radius * window->radius);
    for (long i = 0; i < count; i++) {
        Photon photon = light_emit(light, rng);
        float towards = -vec3_dot(photon.direction, window->normal);
        float t = vec3_dot(vec3_sub(photon.position, window->centre), window->normal) / towards;
        Vec3 at = vec3_along(photon.position, photon.direction, t);
        bool through = towards > 0.0f && t > 0.0f && vec3_length(vec3_sub(at, window->centre)) < window->radius;
        mean_add(&mean, through ? (double)photon.power.r / area : 0.0);
    }
    return mean;
}

// Windows in full light, aslant, at the edge of spot and beam, and with rectangle and sphere partly below the horizon.
TEST(photons_and_samples_agree)
{
    const Window windows[] = {
        {{0, 0, 0}, {0, 0, 1}, 0.3f},
        {{0.1f, -0.3f, 0.2f}, {0.6f, 0, 0.8f}, 0.3f},
        {{0.5f, 0.1f, 0}, {0, 0.6f, 0.8f}, 0.3f},
        {{0.7f, 0.2f, 0.9f}, {-0.28f, 0.96f, 0}, 0.2f},
    };
    Scene *scene = scene_from_text(five_lights);
    for (int l = 0; l < 5; l++) {
        for (int w = 0; w < 4; w++) {
            const Light *light = &scene->lights[l];
            Rng rng = rng_create(41, (uint64_t)(4 * l + w));
            Mean sampled = sampled_irradiance(light, &windows[w], &rng, 100000);
            Mean emitted = emitted_irradiance(light, &windows[w], &rng, 400000);
            double error = hypot(mean_error(&sampled), mean_error(&emitted));
            assert_within(mean_value(&emitted), mean_value(&sampled), 3.0 * error + 1e-6,
                          words("light %d through window %d, by photons", l, w));
            assert_true(w == 3 || mean_value(&sampled) > 0.1);
        }
    }
}

static double mean_irradiance(const Light *light, Vec3 point, Vec3 normal)
{
    double sum = 0.0;
    const int side = 400; // a regular grid of samples: an integral, nearly exact
    for (int i = 0; i < side * side; i++) {
        LightSample sample;
        float u = ((float)(i / side) + 0.5f) / (float)side, v = ((float)(i % side) + 0.5f) / (float)side;
        if (light_sample(light, point, u, v, &sample))
            sum += (double)(sample.arriving.r * fmaxf(0.0f, vec3_dot(sample.wi, normal)));
    }
    return sum / (side * side);
}

// E = πL·sin²θ_max·cosθ for a sphere all above the horizon; sinθ_max = R/d, θ: its centre's angle to the normal.
TEST(sphere_light_irradiance)
{
    Light light = {.type = LIGHT_SPHERE, .position = vec3(1, 2, 4), .radius = 0.5f, .radiance = colour_grey(3)};
    const Vec3 points[] = {{1, 2, 3.4f}, {1, 2, 0}, {0, 0, 0}, {1, 2, -1000}};
    const Vec3 normals[] = {{0, 0, 1}, {0.6f, 0, 0.8f}, {0, 0, 1}, {0, 0, 1}};
    for (int i = 0; i < 4; i++) {
        Vec3 way = vec3_sub(light.position, points[i]);
        double d = vec3_length(way), cosine = vec3_dot(way, normals[i]) / d;
        double expected = M_PI * 3.0 * 0.25 / (d * d) * cosine;
        assert_within(mean_irradiance(&light, points[i], normals[i]), expected, 2e-4 * expected, "sphere light");
    }
    LightSample sample;
    assert_false(light_sample(&light, vec3(1, 2, 4.2f), 0.5f, 0.5f, &sample)); // inside it
}

// A rectangle a × b seen from straight below its corner at height h (A = a/h, B = b/h):
//   E = L/2·[A/√(1+A²)·atan(B/√(1+A²)) + B/√(1+B²)·atan(A/√(1+B²))]   (configuration factor of parallel
//   planes, Howell)
TEST(rectangle_light_irradiance)
{
    Light light = {.type = LIGHT_RECTANGLE,
                   .position = vec3(0, 0, 2),
                   .edge_u = vec3(0, 1, 0),
                   .edge_v = vec3(3, 0, 0),
                   .direction = vec3(0, 0, -1),
                   .area = 3,
                   .radiance = colour_grey(5)};
    double a = 1.0 / 2.0, b = 3.0 / 2.0, ra = sqrt(1.0 + a * a), rb = sqrt(1.0 + b * b);
    double expected = 5.0 / 2.0 * (a / ra * atan(b / ra) + b / rb * atan(a / rb));
    assert_within(mean_irradiance(&light, vec3(0, 0, 0), vec3(0, 0, 1)), expected, 1e-4 * expected, "rectangle");
    LightSample sample;
    assert_false(light_sample(&light, vec3(0.5f, 0.5f, 3), 0.5f, 0.5f, &sample)); // behind it
    assert_false(light_sample(&light, vec3(9, 9, 2), 0.5f, 0.5f, &sample));       // in its plane
}

// Point: E = Φ/(4πd²). Spot: Φ/(2π(1−cosθ_max)d²) inside its cone. Beam: Φ/(πR²) inside its tube.
TEST(lights_without_surface)
{
    const Vec3 down = {0, 0, -1};
    Light light = {.type = LIGHT_POINT,
                   .position = vec3(0, 0, 2),
                   .direction = down,
                   .power = colour_grey(10),
                   .radius = 0.5f,
                   .cos_cone = (float)cos(30.0 / DEGREES),
                   .primitive = NO_PRIMITIVE};
    LightSample sample;
    assert_true(light_sample(&light, vec3(0, 0, 0), 0.1f, 0.9f, &sample));
    assert_within(sample.arriving.r, 10.0 / (16.0 * M_PI), 1e-6, "point");
    assert_within(sample.distance, 2.0, 1e-6, "distance");
    light.type = LIGHT_SPOT;
    assert_true(light_sample(&light, vec3(1.15f, 0, 0), 0.1f, 0.9f, &sample)); // 29.9° off its axis
    double d2 = 4.0 + 1.15 * 1.15, cone = 2.0 * M_PI * (1.0 - cos(30.0 / DEGREES));
    assert_within(sample.arriving.r, 10.0 / (cone * d2), 1e-5, "spot");
    assert_false(light_sample(&light, vec3(1.16f, 0, 0), 0.1f, 0.9f, &sample)); // 30.1°
    assert_false(light_sample(&light, vec3(0, 0, 3), 0.1f, 0.9f, &sample));
    light.type = LIGHT_BEAM;
    assert_true(light_sample(&light, vec3(0.3f, 0.3f, -50), 0.1f, 0.9f, &sample));
    assert_within(sample.arriving.r, 10.0 / (0.25 * M_PI), 1e-5, "beam");
    assert_within(sample.distance, 52.0, 1e-4, "distance to the beam's disk");
    assert_within(angle_between(sample.wi, vec3(0, 0, 1)), 0.0, 1e-5, "against the beam");
    assert_false(light_sample(&light, vec3(0.4f, 0.4f, 0), 0.1f, 0.9f, &sample)); // beside it
    assert_false(light_sample(&light, vec3(0, 0, 2.1f), 0.1f, 0.9f, &sample));    // behind its disk
}

// The sampled spot lies on the light's surface: point + distance·wi is there.
TEST(samples_lie_on_the_light)
{
    Scene *scene = scene_from_text(five_lights);
    Rng rng = rng_create(42, 0);
    for (int i = 0; i < 4000; i++) {
        Vec3 point = vec3_scale(random_direction(&rng), 3.0f);
        const Light *light = &scene->lights[i % 2];
        float u = rng_float(&rng);
        float v = rng_float(&rng);
        LightSample sample;
        if (!light_sample(light, point, u, v, &sample))
            continue;
        assert_within(vec3_length(sample.wi), 1.0, 2e-6, "length");
        Vec3 at = vec3_sub(vec3_along(point, sample.wi, sample.distance), light->position);
        if (light->type == LIGHT_SPHERE)
            assert_within(vec3_length(at), light->radius, 2e-3,
                          "radius"); // a square root near the sphere's limb
        else
            assert_within(vec3_dot(at, light->direction), 0.0, 2e-6, "height over the rectangle");
    }
}

// Φ = πAL both ways; A of a rectangle |u × v|, of a sphere 4πR².
TEST(power_and_radiance)
{
    Scene *scene = scene_from_text(
        BLACK_BALL
        "  - {type: rectangle, corner: [0, 0, 0], edge_u: [2, 0, 0], edge_v: [1, 3, 0], radiance: [1, 2, 0]}\n"
        "  - {type: sphere, centre: [5, 0, 0], radius: 0.5, radiance: [1, 2, 0]}\n"
        "  - {type: rectangle, corner: [0, 0, 9], edge_u: [2, 0, 0], edge_v: [1, 3, 0], power: [1, 2, 0]}\n"
        "  - {type: sphere, centre: [5, 0, 9], radius: 0.5, power: [1, 2, 0]}\n");
    const double areas[4] = {6.0, M_PI, 6.0, M_PI};
    for (int i = 0; i < 4; i++) {
        const Light *light = &scene->lights[i];
        double ratio = M_PI * areas[i]; // of power to radiance
        assert_within(light->area, areas[i], 1e-6 * areas[i], "area");
        for (int c = 0; c < 3; c++) {
            double given = (c + 1) % 3; // 1, 2, 0
            double radiance = i < 2 ? given : given / ratio;
            assert_within(colour_channel(light->radiance, c), radiance, 1e-6 * radiance, "radiance");
            assert_within(colour_channel(light->power, c), ratio * radiance, 1e-6 * ratio * radiance, "power");
        }
    }
    assert_within(angle_between(scene->lights[0].direction, vec3(0, 0, 1)), 0.0, 1e-5, "u x v");
}
