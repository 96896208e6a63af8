// A scene, loaded and ready for rays.
#pragma once

#include "base/error.h"
#include "scene/bvh/bvh.h"
#include "scene/camera.h"
#include "scene/light.h"
#include "scene/material.h"
#include "scene/bvh/shape.h"

#include <stddef.h>

// How a picture is made of a scene.
typedef enum {
    INTEGRATOR_PHOTONS,      // lamps by shadow rays; caustics (from k/4 photons) and indirect light from two maps
    INTEGRATOR_PHOTONS_ONLY, // everything from one map, looked up at the first rough surface, as the source text does
    INTEGRATOR_GATHER,       // as PHOTONS, but indirect light by gather rays, whose estimates are shared
    INTEGRATOR_PATH          // no photons: a plain path tracer, to check against
} Integrator;
#define INTEGRATOR_NAMES "photons, photons-only, gather or path"
extern const char *const integrator_names[]; // "photons", …, NULL: as files and --integrator have them

// False when there is none of this name.
bool integrator_parse(const char *name, Integrator *integrator);

// What the scene file asks for; flags of the command line go before.
typedef struct {
    int width, height; // pixels
    int samples;       // eye rays per pixel
    long photons;      // to emit
    int k;             // photons in an estimate
    float radius;      // largest radius of an estimate, m; 0: no limit (k alone decides)
    int depth;         // bounces after which a path is cut
    Integrator integrator;
    bool spectral; // photons of single wavelengths (step 6.4)
} RenderSettings;

typedef struct {
    Camera camera;
    RenderSettings settings;
    Material *materials;
    size_t material_count;
    Light *lights;
    size_t light_count;
    Flat *flats;
    size_t flat_count;
    Sphere *spheres;
    size_t sphere_count;
    Vec3 *normals; // corner normals of meshes that have them
    size_t normal_count;
    Bvh *bvh;
    char *mesh_files; // their paths, a line each; NULL: there are none
} Scene;

// Where a ray meets the scene.
typedef struct {
    Vec3 position;
    Vec3 normal;      // unit, on the side the ray came from; on mirrors and glass of a mesh with normals: interpolated
    Vec3 face_normal; // unit, on the same side; never interpolated
    float distance;
    bool entering; // the ray came from outside (the side the surface's own normal points to)
    const Material *material;
    uint32_t primitive;
} Hit;

// Reads a YAML scene and the meshes it names (paths are relative to the scene file). NULL on any fault, with
// "file:line:column: …" in the error.
Scene *scene_load(const char *path, Error *error);
// The same from memory. `file` names the text in messages; meshes are looked for in `folder`, which ends in a slash; NULL
// refuses them.
Scene *scene_load_text(const char *text, size_t size, const char *file, const char *folder, Error *error);
void scene_free(Scene *scene);

// The closest surface along the ray.
bool scene_intersect(const Scene *scene, const Ray *ray, Hit *hit);

// Is anything between the ray's origin and `distance`? The light's own surface does not count.
bool scene_occluded(const Scene *scene, const Ray *ray, float distance, const Light *light);
