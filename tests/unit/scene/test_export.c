// Scenes for other renderers: what is refused, what is told, what a mesh holds.
#include "unit/scene/scene_parts.h"
#include "scene/export/export.h"
#include "scene/material_kind.h"
#include "base/file.h"

static char told[4000];

static void take(const char *words)
{
    strncat(told, words, sizeof told - strlen(told) - 1);
}

static bool export_as(const Scene *scene, const char *path)
{
    told[0] = '\0';
    return export_write(scene, &scene->settings, path, take, &said);
}

static Vec3 any_turn(Vec3 direction, Vec3 normal)
{
    return vec3_sub(direction, normal);
}

static Colour any_lobe(const Material *material, GlossyModel model, Vec3 wi, Vec3 wo, Vec3 n)
{
    (void)model, (void)wi, (void)wo, (void)n;
    return material->diffuse;
}

// A kind that no renderer knows is taken for none.
TEST(own_rules_are_refused)
{
    static const MaterialKind kinds[] = {{.optics = OPTICS_MIRROR, .turn = any_turn},
                                         {.optics = OPTICS_ROUGH, .lobe = any_lobe},
                                         {.optics = OPTICS_LIGHT}};
    Scene *scene = scene_from_text(CAMERA LIGHT WHITE);
    for (int i = 0; i < 3; i++)
        for (int format = 0; format < 2; format++) {
            const char *path = words("%s/a.%s", temporary, format ? "xml" : "pbrt");
            scene->materials[0].kind = &kinds[i];
            assert_refused(export_as(scene, path), "'white' treats light by a rule of its own");
            assert_int_equal(access(path, F_OK), -1);
        }
}

TEST(what_differs_is_told)
{
    static const char text[] =
        CAMERA "materials:\n  - {name: flint, type: glass, glass: N-SF11}\n"
               "  - {name: satin, type: glossy, diffuse: [0.9, 0, 0], specular: [0, 0.9, 0], exponent: 50}\n"
               "lights:\n  - {type: beam, position: [0, 0, 0], target: [0, 0, 1], radius: 0.1, power: [1, 1, 1]}\n"
               "  - {type: point, spectrum: sodium, position: [0, 0, 0], power: [1, 1, 1]}\n";
    static const char *const expected[2][4] = {
        {"flint: Mitsuba 3's glass has one index", "satin: the cosine lobe of exponent 50", "a beam is left out",
         "a lamp's spectrum becomes"},
        {"satin: the cosine lobe", "roughness 0.1", "a beam is left out", "line at 589.3 nm becomes a band"}};
    Scene *scene = scene_from_text(text);
    for (int format = 0; format < 2; format++) {
        const char *path = words("%s/a.%s", temporary, format ? "pbrt" : "xml");
        assert_true(export_as(scene, path));
        for (int i = 0; i < 4; i++)
            if (!strstr(told, expected[format][i]))
                fail_msg("\"%s\" is not told, but: %s", expected[format][i], told);
        unlink(path);
    }
}

// A rectangle becomes two triangles with the same normal, and nothing of a name leaves the folder.
TEST(a_mesh_of_a_rectangle)
{
    Scene *scene =
        scene_from_text(CAMERA LIGHT "materials:\n  - {name: \"../a b\", type: mirror}\n"
                                     "shapes:\n  - {type: rectangle, material: \"../a b\", corner: [1, 2, 3], "
                                     "edge_u: [1, 0, 0], edge_v: [0, 2, 0]}\n");
    const char *path = words("%s/a.xml", temporary), *mesh = words("%s/a_1_.._a_b.ply", temporary);
    assert_true(export_as(scene, path));
    size_t size;
    char *bytes = file_read(mesh, 10000, &size, &said);
    assert_non_null(bytes);
    at_end(free, bytes);
    const char *body = strstr(bytes, "end_header\n");
    assert_non_null(body);
    body += strlen("end_header\n");
    assert_int_equal(size - (size_t)(body - bytes), 6 * 12 + 2 * 13);
    static const float corners[6][2] = {{1, 2}, {2, 2}, {1, 4}, {2, 2}, {2, 4}, {1, 4}};
    for (int i = 0; i < 6; i++) {
        unsigned char expected[12];
        file_put_float(file_put_float(file_put_float(expected, corners[i][0]), corners[i][1]), 3.0f);
        assert_memory_equal(body + 12 * i, expected, 12);
    }
    unlink(path);
    unlink(mesh);
}
