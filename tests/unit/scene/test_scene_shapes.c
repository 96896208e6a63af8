// Shapes and meshes as flats of a scene: closed, turned and placed as the file says.
#include "unit/scene/scene_parts.h"

static Scene *load_shape(const char *shape)
{
    return scene_from_text(words(CAMERA LIGHT WHITE "shapes:\n  - {%s, material: white}\n", shape));
}

// By Gauss: a third of the flux of the position vector through the surface. Positive when all normals point outside.
static double enclosed_volume(const Scene *scene)
{
    double six_volumes = 0;
    for (size_t i = 0; i < scene->flat_count; i++) {
        const Flat *flat = &scene->flats[i];
        Vec3 normal = vec3_cross(flat->edge_u, flat->edge_v);
        six_volumes += (flat->is_triangle ? 1.0 : 2.0) * vec3_dot(flat->origin, normal);
    }
    return six_volumes / 6;
}

TEST(test_shapes_are_closed)
{
    Scene *scene = load_shape("type: box, low: [-1, 2, 3], high: [1, 5, 7]");
    assert_int_equal(scene->flat_count, 6);
    assert_near(enclosed_volume(scene), 2 * 3 * 4, 1e-4);
    scene = load_shape("type: box, low: [-1, 2, 3], high: [1, 5, 7], rotate_y: 33");
    assert_near(enclosed_volume(scene), 2 * 3 * 4, 1e-4);
    scene =
        load_shape("type: prism, apex: [1, 2, 3], axis: [1, 2, 0], down: [0, -3, 1], angle: 60, side: 2, length: 5");
    assert_int_equal(scene->flat_count, 5);
    assert_near(enclosed_volume(scene), 0.5 * 2 * 2 * sin(3.14159265 / 3) * 5, 1e-4);
}

TEST(test_box_turns_counter_clockwise)
{
    // About y, +x goes towards −z: the box's low corner (−1, −1) in x and z comes to lie at −1, +1.
    Scene *scene = load_shape("type: box, low: [-1, 0, -1], high: [1, 1, 1], rotate_y: 90");
    assert_vector(scene->flats[0].origin, -1, 0, 1);
}

TEST(test_prism_place)
{
    Scene *scene = load_shape("type: prism, apex: [0, 1, 0], axis: [0, 0, 2], down: [0, -1, 5], angle: 90, "
                              "side: 1.41421356, length: 4");
    Vec3 lowest = vec3(0, 0, 0), highest = lowest;
    for (size_t i = 0; i < scene->flat_count; i++) {
        const Flat *flat = &scene->flats[i];
        Vec3 ends[2] = {flat->origin, vec3_add(flat->origin, flat->edge_u)};
        for (int e = 0; e < 2; e++) {
            lowest = vec3(fminf(lowest.x, ends[e].x), fminf(lowest.y, ends[e].y), fminf(lowest.z, ends[e].z));
            highest = vec3(fmaxf(highest.x, ends[e].x), fmaxf(highest.y, ends[e].y), fmaxf(highest.z, ends[e].z));
        }
    }
    assert_vector(lowest, -1, 0, -2);
    assert_vector(highest, 1, 1, 2);
}

// A scene with one mesh, whose text is `obj`; `keys` are put behind the file's name.
static Scene *load_mesh(const char *obj, const char *keys)
{
    const char *folder = words("%s/", temporary), *path = words("%smesh.obj", folder);
    write_text(path, obj);
    Scene *scene = scene_in_folder(
        words(CAMERA LIGHT WHITE "  - {name: shiny, type: mirror}\nshapes:\n  - {type: mesh, file: mesh.obj%s}\n",
              keys),
        folder);
    unlink(path);
    return scene;
}

TEST(test_mesh_place)
{
    const char *obj = "v 0 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n";
    Scene *scene = load_mesh(obj, ", material: white, scale: 2, rotate: [90, 90, 90], translate: [5, 6, 7]");
    const Flat *flat = &scene->flats[0];
    assert_vector(flat->origin, 5, 6, 7);
    assert_vector(flat->edge_u, 0, 2, 0); // y →(about x) z →(about y) x →(about z) y
    assert_vector(flat->edge_v, 2, 0, 0); // z →(about x) −y →(about y) −y →(about z) x
    assert_true(flat->is_triangle);
}

TEST(test_mesh_materials)
{
    const char *obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl shiny\nf 1 3 2\n";
    Scene *scene = load_mesh(obj, ", material: white");
    assert_int_equal(scene->flat_count, 2);
    assert_int_equal(scene->flats[0].material, 0);
    assert_int_equal(scene->flats[1].material, 1);
    scene = load_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl shiny\nf 1 3 2\n", "");
    assert_int_equal(scene->flats[0].material, 1);
}

TEST(test_mesh_normals)
{
    // The second face contradicts the normals, the third has none.
    const char *obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0.6 0 0.8\nvn 0 0.6 0.8\n"
                      "f 1//1 2//2 3//2\nf 1//1 3//1 2//1\nf 1 2 3\nf 1//2 2//2 3//2\n";
    Scene *scene = load_mesh(obj, ", material: white, scale: 3, rotate: [0, 0, 90]");
    assert_int_equal(scene->normal_count, 6);
    assert_int_equal(scene->flats[0].normals, 1);
    assert_int_equal(scene->flats[1].normals, 0);
    assert_int_equal(scene->flats[2].normals, 0);
    assert_int_equal(scene->flats[3].normals, 4);
    assert_vector(scene->normals[0], 0, 0.6f, 0.8f);
    assert_vector(scene->normals[1], -0.6f, 0, 0.8f);
}
