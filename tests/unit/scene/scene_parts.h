// What the tests of the scene loader share: the small parts of a scene, and a folder that is there while they run.
#pragma once

#include "unit/test_common.h"

#include <unistd.h>

#define CAMERA "camera: {position: [0, 0, 3.9], target: [0, 0, 0], vertical_fov: 39.3077}\n"
#define LIGHT  "lights:\n  - {type: point, position: [0, 1, 0], power: [1, 2, 3]}\n"
#define WHITE  "materials:\n  - {name: white, type: diffuse, reflectance: [0.7, 0.6, 0.5]}\n"

static inline void assert_vector(Vec3 v, float x, float y, float z)
{
    assert_near(v.x, x, 1e-5);
    assert_near(v.y, y, 1e-5);
    assert_near(v.z, z, 1e-5);
}

static char temporary[] = "/tmp/photonlab_test_XXXXXX";

FIXTURE(make_folder)
{
    return mkdtemp(temporary) ? 0 : -1;
}

FIXTURE(remove_folder)
{
    return rmdir(temporary);
}

AROUND_TESTS(make_folder, remove_folder)
