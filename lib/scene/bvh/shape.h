// What the scene's surfaces are made of, once loaded: flats (triangles and parallelograms) and spheres. A box becomes
// six flats, a prism five, a mesh one per triangle.
#ifndef PHOTONLAB_SCENE_SHAPE_H
#define PHOTONLAB_SCENE_SHAPE_H

#include "math/ray.h"

#include <stdbool.h>

// The points origin + u·edge_u + v·edge_v with u, v ≥ 0 and (triangle) u+v ≤ 1 or (parallelogram) u, v ≤ 1.
// The normal edge_u × edge_v points outside.
typedef struct {
    Vec3 origin, edge_u, edge_v;
    uint32_t material; // index into Scene.materials
    // 1 + index into Scene.normals of three corner normals (at origin, +edge_u, +edge_v); 0: it has none.
    uint32_t normals : 31;
    uint32_t is_triangle : 1;
} Flat;

// The normal points away from the centre.
typedef struct {
    Vec3 centre;
    float radius;
    uint32_t material;
} Sphere;

// A primitive's number: flats first (0 … flat_count−1), then spheres (flat_count …).

#endif
