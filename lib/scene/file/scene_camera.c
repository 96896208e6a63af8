// The two sections that are no lists: the camera, and what `render` asks for.
#include "scene/file/scene_section.h"

#include <string.h>

static const SceneKeys no_keys = {{.name = NULL}};

static const SceneKeys camera_keys = {
    {"position", KEY_THREE, KEY_REQUIRED, RANGE_METRES, "where the eye is"},
    {"target", KEY_THREE, KEY_REQUIRED, RANGE_METRES, "the point in the middle of the picture"},
    {"up", KEY_THREE, "[0, 1, 0]", RANGE_ANY, "what is up in the picture; not along the view"},
    {"vertical_fov", KEY_NUMBER, KEY_REQUIRED, RANGE_ANGLE,
     "field of view, from the picture's lower to its upper edge"},
};

static const SceneType camera_type = {
    .meaning = "A pinhole camera.",
    .keys = camera_keys,
    .example = "camera: {position: [0, 0, 3.9], target: [0, 0, 0], vertical_fov: 39.3}",
};

static bool build_camera(SceneEntry *entry)
{
    Vec3 position = scene_three(entry, "position"), target = scene_three(entry, "target");
    Vec3 up = scene_three(entry, "up"), view = vec3_sub(target, position);
    if (vec3_length(view) < SCENE_SMALLEST_LENGTH)
        return scene_fault(entry, "target", "the target is the camera's position; expected another point");
    if (flat_is_degenerate(view, up))
        return scene_fault(entry, "up", "up (%g, %g, %g) is zero or along the view; expected another direction", up.x,
                           up.y, up.z);
    Vec3 forward = vec3_normalize(view), right = vec3_normalize(vec3_cross(forward, up));
    entry->file->scene->camera = (Camera){
        .position = position,
        .forward = forward,
        .right = right,
        .up = vec3_cross(right, forward),
        .tan_half_fov = tanf(0.5f * scene_number(entry, "vertical_fov") * (PI / 180.0f)),
    };
    return true;
}

const SceneSection camera_section = {
    "camera", "Where the picture is taken from.", 0, true, no_keys, &camera_type, NULL, build_camera};

static const SceneKeys render_keys = {
    {"width", KEY_WHOLE, "512", RANGE(1, MOST_SIDE, "pixels"), "width of the picture"},
    {"height", KEY_WHOLE, "512", RANGE(1, MOST_SIDE, "pixels"), "height of the picture"},
    {"samples", KEY_WHOLE, "4", RANGE(1, MOST_SAMPLES, "rays per pixel"), "eye rays through each pixel"},
    {"photons", KEY_WHOLE, "500000", RANGE(1, MOST_PHOTONS, "photons"), "photons to emit"},
    {"k", KEY_WHOLE, "100", RANGE(1, MOST_K, "photons"), "photons in an estimate"},
    {"radius", KEY_NUMBER, "0", RANGE_TOLD(0, SCENE_LARGEST_NUMBER, "m", "a length in metres, or 0 for no limit"),
     "largest radius of an estimate; 0: k alone decides"},
    {"depth", KEY_WHOLE, "32", RANGE(1, MOST_DEPTH, "bounces"), "after so many bounces a path is cut"},
    {"integrator", KEY_WORD, "photons", RANGE_NAME, "how light is found: " INTEGRATOR_NAMES},
    {"spectral", KEY_WORD, "no", RANGE_NAME, "yes: photons of single wavelengths, not of red, green and blue"},
};

static const SceneType render_type = {
    .meaning = "What a picture of this scene takes. Flags of the command line go before.",
    .keys = render_keys,
    .example = "render: {width: 768, height: 432, samples: 16, photons: 2000000, k: 240, radius: 0.004}",
};

static bool build_render(SceneEntry *entry)
{
    Integrator integrator;
    if (!integrator_parse(scene_word(entry, "integrator"), &integrator))
        return scene_fault(entry, "integrator", "there is no integrator '%s'; expected " INTEGRATOR_NAMES,
                           scene_word(entry, "integrator"));
    const char *spectral = scene_word(entry, "spectral");
    if (strcmp(spectral, "yes") != 0 && strcmp(spectral, "no") != 0)
        return scene_fault(entry, "spectral", "spectral is '%s'; expected yes or no", spectral);
    entry->file->scene->settings = (RenderSettings){
        .integrator = integrator,
        .spectral = strcmp(spectral, "yes") == 0,
        .width = (int)scene_whole(entry, "width"),
        .height = (int)scene_whole(entry, "height"),
        .samples = (int)scene_whole(entry, "samples"),
        .photons = scene_whole(entry, "photons"),
        .k = (int)scene_whole(entry, "k"),
        .radius = scene_number(entry, "radius"),
        .depth = (int)scene_whole(entry, "depth"),
    };
    return true;
}

const SceneSection render_section = {"render", "How it is rendered.", 0,    false,
                                     no_keys,  &render_type,          NULL, build_render};
