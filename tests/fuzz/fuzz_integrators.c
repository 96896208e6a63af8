// From a scene to pictures, by every integrator and by passes, small ones: a picture or a message.
#include "fuzz/fuzz.h"
#include "render/passes/passes.h"
#include "scene/scene.h"

static void render(const Scene *scene, RenderOptions *options)
{
    Image image = {0, 0, NULL};
    RenderStats stats;
    Error error = {""};
    bool fine = render_image(scene, options, &image, &stats, &error);
    require(fine == !error.message[0] && fine == (image.pixels != NULL));
    image_free(&image);
}

static void render_by_passes(const Scene *scene, const RenderOptions *options, bool by_pixel)
{
    Passes passes = {.alpha = PASS_ALPHA, .last = 2, .by_pixel = by_pixel};
    RenderStats stats;
    Image image;
    Error error = {""};
    bool fine = passes_run(scene, options, &passes, &stats, &error);
    require(fine == !error.message[0]);
    if (fine && passes_picture(&passes, &image, &error))
        image_free(&image);
    passes_free(&passes);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static bool loaded;
    Error error = {""};
    if (!loaded)
        require(loaded = steps_load(NULL, &error));
    Scene *scene = size ? scene_load_text((const char *)data, size, "fuzz.yaml", NULL, &error) : NULL;
    if (!scene)
        return 0;
    RenderOptions options = {
        .settings = scene->settings, .seed = 1, .threads = 1, .glass_sides = 2, .reuse = REUSE_DEFAULT, .hero = true};
    options.settings.width = 4;
    options.settings.height = 3;
    options.settings.samples = 1;
    options.settings.photons = 50;
    options.settings.k = scene->settings.k < 20 ? scene->settings.k : 20;
    options.settings.depth = scene->settings.depth < 30 ? scene->settings.depth : 30;
    for (int i = 0; i <= INTEGRATOR_PATH; i++) {
        options.integrator = (Integrator)i;
        render(scene, &options);
    }
    options.integrator = INTEGRATOR_PHOTONS;
    options.play.loop = LOOP_WAVELENGTH;
    render(scene, &options);
    render_by_passes(scene, &options, false);
    render_by_passes(scene, &options, true);
    scene_free(scene);
    return 0;
}
