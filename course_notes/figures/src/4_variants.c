// The gathered picture, and what it would be without one of its parts:
//   4_variants SCENE PHOTONS SIZE VARIANT OUT [NUMBERS]
// VARIANT: right; dots (where the estimates lie, over the picture); once (no second gather ray near corners; for rooms that
// are matt throughout). NUMBERS gets the count of the estimates.
#include "render/final_gather.h"
#include "photonlab.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_PLACES = 100000 };
static Vec3 places[MOST_PLACES];
static int place_count;
static Colour (*sum_up)(GatherTrace *trace, const Hit *hit, Hemisphere *seen, Rng *rng);

// Step 4.3, looked over the shoulder.
static Colour note_place(GatherTrace *trace, const Hit *hit, Hemisphere *seen, Rng *rng)
{
    if (place_count < MOST_PLACES)
        places[place_count++] = hit->position;
    return sum_up(trace, hit, seen, rng);
}

// Step 4.2 in a room that is matt throughout, with what is kept at photons and no second ray.
static Colour bring_once(GatherTrace *trace, Ray ray, Rng *rng)
{
    (void)rng;
    Hit hit;
    LocalIrradiance local;
    if (!gather_meet(trace, &ray, &hit) || !material_is_rough(hit.material) ||
        !irradiance_map_find(trace->eye->final->ends, hit.position, hit.normal, &local))
        return colour_grey(0.0f);
    return colour_scale(colour_mul(gather_albedo(trace, &ray, &hit), local.irradiance), 1.0f / PI);
}

static void draw_dots(Image *image, const Camera *camera)
{
    for (int i = 0; i < image->width * image->height; i++)
        image->pixels[i] = colour_scale(image->pixels[i], 0.5f);
    for (int i = 0; i < place_count; i++) {
        Vec3 away = vec3_sub(places[i], camera->position);
        float scale = 0.5f * (float)image->height / (vec3_dot(away, camera->forward) * camera->tan_half_fov);
        int x = (int)(0.5f * (float)image->width + scale * vec3_dot(away, camera->right));
        int y = (int)(0.5f * (float)image->height - scale * vec3_dot(away, camera->up));
        if (x >= 0 && x < image->width && y >= 0 && y < image->height)
            *image_at(image, x, y) = colour(1.0f, 0.85f, 0.3f);
    }
}

int main(int count, char **names)
{
    Error error = {"usage: 4_variants SCENE PHOTONS SIZE right|dots|once OUT [NUMBERS]"};
    Scene *scene = count >= 6 && steps_load(NULL, &error) ? scene_load(names[1], &error) : NULL;
    if (!scene) {
        fprintf(stderr, "%s\n", error.message);
        return 1;
    }
    sum_up = steps.gather_hemisphere;
    if (strcmp(names[4], "dots") == 0)
        steps.gather_hemisphere = note_place;
    else if (strcmp(names[4], "once") == 0)
        steps.gather_radiance = bring_once;
    RenderOptions options = {.integrator = INTEGRATOR_GATHER,
                             .settings = scene->settings,
                             .seed = 1,
                             .threads = 1,
                             .glass_sides = 2,
                             .reuse = REUSE_DEFAULT};
    options.settings.photons = atol(names[2]);
    options.settings.width = options.settings.height = atoi(names[3]);
    options.settings.k = 60;
    options.settings.samples = 16;
    Image image;
    RenderStats stats;
    bool ok = render_image(scene, &options, &image, &stats, &error);
    if (ok && place_count > 0)
        draw_dots(&image, &scene->camera);
    ok = ok && image_write(&image, names[5], &error);
    FILE *numbers = count > 6 ? fopen(names[6], "w") : NULL;
    if (numbers) {
        fprintf(numbers, "estimates %zu\npixels_an_estimate %.1f\n", stats.estimates,
                (double)image.width * image.height / (double)stats.estimates);
        fclose(numbers);
    }
    if (!ok)
        fprintf(stderr, "%s\n", error.message);
    scene_free(scene);
    return ok ? 0 : 1;
}
