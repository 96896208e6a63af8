// What comes of a scene file that is right: settings, camera, materials, lights. Runs from the top folder.
#include "unit/scene/scene_parts.h"

TEST(test_settings)
{
    Scene *scene = scene_from_text(CAMERA LIGHT);
    RenderSettings s = scene->settings;
    assert_true(s.width == 512 && s.height == 512 && s.samples == 4 && s.photons == 500000 && s.k == 100 &&
                s.radius == 0 && s.depth == 32);
    scene = scene_from_text(
        CAMERA LIGHT "render: {width: 3, height: 4, samples: 5, photons: 600000000, k: 7, radius: 0.5, depth: 9}\n");
    s = scene->settings;
    assert_true(s.width == 3 && s.height == 4 && s.samples == 5 && s.photons == 600000000 && s.k == 7 &&
                s.radius == 0.5f && s.depth == 9);
}

TEST(test_camera)
{
    Scene *scene = scene_from_text(CAMERA LIGHT);
    // The formula of the reference images: ((2(i+½)/W − 1)·T, (1 − 2(j+½)/W)·T, −1) with T = tan(fov/2).
    double t = tan(39.3077 / 2 * 3.14159265358979 / 180);
    for (int j = 0; j < 8; j++)
        for (int i = 0; i < 8; i++) {
            Ray ray = camera_ray(&scene->camera, ((float)i + 0.5f) / 8, ((float)j + 0.5f) / 8, 1);
            double x = (2 * (i + 0.5) / 8 - 1) * t, y = (1 - 2 * (j + 0.5) / 8) * t, length = sqrt(x * x + y * y + 1);
            assert_vector(ray.direction, (float)(x / length), (float)(y / length), (float)(-1 / length));
            assert_vector(ray.origin, 0, 0, 3.9f);
            assert_int_equal(ray.from, NO_PRIMITIVE);
        }
    Ray wide = camera_ray(&scene->camera, 1, 0.5f, 2); // twice as wide as high: the vertical field stays
    assert_near(wide.direction.x / -wide.direction.z, 2 * t, 1e-5);
}

TEST(test_materials)
{
    Scene *scene = scene_from_text(
        CAMERA LIGHT "materials:\n"
                     "  - {name: a, type: diffuse, reflectance: [0.7, 0.6, 0.5]}\n"
                     "  - {name: b, type: glossy, diffuse: [0.3, 0.2, 0.1], specular: [0.7, 0.5, 0.5], exponent: 50}\n"
                     "  - {name: c, type: mirror}\n"
                     "  - {name: d, type: mirror, reflectance: [0.9, 0.8, 0.7]}\n"
                     "  - {name: e, type: glass, index: 1.5}\n"
                     "  - {name: f, type: glass, indices: [1.1, 1.1, 1.3]}\n"
                     "  - {name: g, type: glass, glass: n-sf11}\n"
                     "  - {name: h, type: glass, index_d: 1.5168, abbe: 64.17}\n");
    const Material *m = scene->materials;
    assert_int_equal(scene->material_count, 8);
    assert_true(m[0].type == MATERIAL_DIFFUSE && m[0].diffuse.g == 0.6f && !m[0].lobe);
    assert_true(m[1].type == MATERIAL_GLOSSY && m[1].diffuse.r == 0.3f && m[1].specular.r == 0.7f &&
                m[1].exponent == 50);
    assert_near(lobe_lookup(m[1].lobe->above, 1), 2 * 3.14159265 / 51, 1e-4); // the whole lobe: 2π/(n+1)
    assert_true(m[2].type == MATERIAL_MIRROR && m[2].specular.r == 1 && m[2].specular.b == 1);
    assert_true(m[3].specular.g == 0.8f);
    assert_true(m[4].type == MATERIAL_GLASS && m[4].index[0] == 1.5f && m[4].index[2] == 1.5f && !m[4].disperses);
    assert_true(m[5].index[2] == 1.3f && m[5].disperses);
    assert_near(m[6].index[0], 1.781326, 1e-6);
    assert_near(m[6].index[2], 1.813689, 1e-6);
    assert_near(m[7].index[1], 1.504583 + 0.0042176 / (0.54913 * 0.54913), 1e-5);
    assert_true(m[6].disperses && m[7].disperses);
}

TEST(test_lights)
{
    const double pi = 3.14159265358979;
    Scene *scene = scene_from_text(
        CAMERA WHITE
        "lights:\n"
        "  - {type: sphere, centre: [1, 2, 3], radius: 0.5, radiance: [1, 2, 3]}\n"
        "  - {type: rectangle, corner: [0, 1, 0], edge_u: [2, 0, 0], edge_v: [1, 0, 3], power: [6, 12, 18]}\n"
        "  - {type: point, position: [4, 5, 6], power: [1, 2, 3]}\n"
        "  - {type: spot, position: [0, 3, 0], target: [0, 1, 0], angle: 60, power: [1, 1, 1]}\n"
        "  - {type: beam, position: [0, 3, 4], target: [0, 0, 0], radius: 0.01, power: [1, 0, 0]}\n"
        "  - {type: sphere, centre: [1, 2, 3], radius: 2, power: [1, 1, 1]}\n"
        "shapes:\n"
        "  - {type: sphere, centre: [0, 0, 0], radius: 1, material: white}\n"
        "  - {type: rectangle, corner: [0, 0, 0], edge_u: [1, 0, 0], edge_v: [0, 1, 0], material: white}\n");
    const Light *l = scene->lights;
    assert_int_equal(scene->light_count, 6);
    assert_near(l[0].area, pi, 1e-6); // 4πr² with r = ½
    assert_near(l[0].power.g, pi * pi * 2, 1e-4);
    assert_near(l[1].area, 6, 1e-6);
    assert_near(l[1].radiance.b, 18 / (pi * 6), 1e-6);
    assert_vector(l[1].direction, 0, -1, 0);
    assert_true(l[2].power.b == 3 && l[2].position.z == 6 && l[2].primitive == NO_PRIMITIVE);
    assert_near(l[3].cos_cone, 0.5, 1e-6);
    assert_vector(l[3].direction, 0, -1, 0);
    assert_vector(l[4].direction, 0, -0.6f, -0.8f);
    assert_vector(vec3_cross(l[4].edge_u, l[4].edge_v), 0, -0.6f, -0.8f);
    assert_near(vec3_length(l[4].edge_u), 1, 1e-6);
    // Flats: the light's, then the shape's; spheres after both flats, the lights' first.
    assert_true(scene->flat_count == 2 && scene->sphere_count == 3);
    assert_true(l[1].primitive == 0 && l[0].primitive == 2 && l[5].primitive == 3);
    assert_int_equal(scene->material_count, 4);
    const Material *own = &scene->materials[scene->spheres[l[5].primitive - 2].material];
    assert_string_equal(own->name, "light 6");
    assert_true(own->type == MATERIAL_LIGHT && own->radiance.r == l[5].radiance.r);
    assert_string_equal(scene->materials[scene->flats[0].material].name, "light 2");
}

static const Material *seen_at(const Scene *scene, float x, float y, Hit *hit)
{
    Ray ray = camera_ray(&scene->camera, x, y, 1);
    return scene_intersect(scene, &ray, hit) ? hit->material : NULL;
}

TEST(test_box_scenes)
{
    const char *paths[] = {"scenes/box_diffuse.yaml", "scenes/box_glass.yaml"};
    const MaterialType left[] = {MATERIAL_DIFFUSE, MATERIAL_MIRROR}, right[] = {MATERIAL_DIFFUSE, MATERIAL_GLASS};
    for (int i = 0; i < 2; i++) {
        Scene *scene = scene_from_file(paths[i]);
        Hit hit;
        assert_near(scene->lights[0].power.g, 8.2373, 1e-4);
        // In the reference images at 512 pixels, columns 204 to 307 and rows 56 to 89 hold the light.
        assert_int_equal(seen_at(scene, 256 / 512.f, 70 / 512.f, &hit)->type, MATERIAL_LIGHT);
        assert_true(hit.entering);
        assert_string_equal(seen_at(scene, 0.05f, 0.5f, &hit)->name, "red");
        assert_string_equal(seen_at(scene, 0.95f, 0.5f, &hit)->name, "green");
        assert_int_equal(seen_at(scene, 0.36f, 0.72f, &hit)->type, left[i]);
        assert_int_equal(seen_at(scene, 0.65f, 0.75f, &hit)->type, right[i]);
        assert_int_equal(hit.primitive, scene->flat_count + 1);
    }
}

// No ray into the room gets out or meets a wall from behind; red is on the left, as in the photograph.
TEST(test_cornell_box)
{
    Scene *scene = scene_from_file("scenes/cornell_box.yaml");
    Hit hit;
    assert_string_equal(seen_at(scene, 0.05f, 0.5f, &hit)->name, "red");
    assert_string_equal(seen_at(scene, 0.95f, 0.5f, &hit)->name, "green");
    assert_int_equal(seen_at(scene, 0.5f, 0.13f, &hit)->type, MATERIAL_LIGHT);
    assert_near(scene->lights[0].area, 0.013650, 1e-7);
    for (int j = 0; j < 100; j++)
        for (int i = 0; i < 100; i++) {
            const Material *material = seen_at(scene, 0.03f + 0.0094f * (float)i, 0.03f + 0.0094f * (float)j, &hit);
            assert_non_null(material);
            assert_true(hit.entering);
        }
}
