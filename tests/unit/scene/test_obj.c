// What OBJ files may look like, and what comes of them. Faulty ones are in test_malformed.c.
#include "scene/file/obj.h"
#include "base/text.h"
#include "unit/test.h"

#define SQUARE "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"

FREED_AT_END(own_mesh, ObjMesh, obj_free)

static const char *material_at(const void *unused, size_t i)
{
    static const char *const names[] = {"white", "red wine", "b#"};
    (void)unused;
    return i < 3 ? names[i] : NULL;
}

static ObjMesh read_fine(const char *text)
{
    ObjMesh mesh;
    assert_works(
        obj_read_text(text, strlen(text), "test.obj", &(ObjNames){material_at, NULL, "test.yaml"}, &mesh, &said));
    return *own_mesh(kept(&mesh, sizeof mesh));
}

static void assert_triangle(const ObjMesh *mesh, size_t i, uint32_t a, uint32_t b, uint32_t c)
{
    assert_true(i < mesh->triangle_count);
    assert_int_equal(mesh->triangles[i].point[0], a);
    assert_int_equal(mesh->triangles[i].point[1], b);
    assert_int_equal(mesh->triangles[i].point[2], c);
}

TEST(test_kinds_of_corners)
{
    ObjMesh mesh = read_fine(SQUARE "vt 0 0\nvn 0 0 1\nvn 0 0 5\n"
                                    "f 1 2 3\nf 1/1 2/1 3/1\nf 1//1 2//2 3//1\nf 1/1/1 2/7/2 3/-1/-1\nf 1//1 2 3//1\n");
    assert_int_equal(mesh.triangle_count, 5);
    for (size_t i = 0; i < 5; i++)
        assert_triangle(&mesh, i, 0, 1, 2);
    const uint32_t second_normal[5] = {OBJ_NONE, OBJ_NONE, 1, 1, OBJ_NONE};
    for (size_t i = 0; i < 5; i++)
        assert_int_equal(mesh.triangles[i].normal[1], second_normal[i]);
    assert_int_equal(mesh.triangles[3].normal[2], 1);
    assert_int_equal(mesh.triangles[4].normal[0], OBJ_NONE); // one corner without: none at all
    assert_true(mesh.normals[1].z == 1.0f);                  // made unit
}

TEST(test_negative_indices)
{
    // They count back from the points above the face, not from the end of the file.
    ObjMesh mesh = read_fine(SQUARE "f -4 -3 -2\nv 9 9 9\nf -5 -4 -2\n");
    assert_triangle(&mesh, 0, 0, 1, 2);
    assert_triangle(&mesh, 1, 0, 1, 3);
}

TEST(test_polygons)
{
    ObjMesh mesh = read_fine(SQUARE "v -1 0.5 0\nf 1 2 3 4\nf 1 2 3 4 5\n");
    assert_int_equal(mesh.triangle_count, 5);
    assert_triangle(&mesh, 0, 0, 1, 2);
    assert_triangle(&mesh, 1, 0, 2, 3);
    assert_triangle(&mesh, 4, 0, 3, 4);
    // A corner in the middle of a side makes a triangle without area, which is left out.
    mesh = read_fine(SQUARE "v 0.5 0 0\nf 1 5 2 3 4\n");
    assert_int_equal(mesh.triangle_count, 2);
    assert_triangle(&mesh, 0, 0, 1, 2);
}

TEST(test_layout)
{
    const char *same[] = {
        SQUARE "f 1 2 3\n",
        "\xef\xbb\xbf# a mark before the text\n" SQUARE "f 1 2 3",
        "v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nf 1 2 3\r\n",
        "  v\t0  0 0 # a point\n v 1 0 0 1.0\nv 1 1 0 0.5 0.5 0.5\n\n\nf 1\t2 3   # done",
        "g a \\\n b\nv 0\\\n 0 \\\r\n 0# x\nv 1 0 0\nv 1 1 0\nf 1 2\\\n 3\n",
        "mtllib a.mtl\no x\ng a b\ns off\nv 0e5 -0 +0.\nv 1E0 .0 0\nv 100e-2 0.1e+1 0\nl 1 2\nf 1 2 3\n",
    };
    for (size_t i = 0; i < sizeof same / sizeof same[0]; i++) {
        ObjMesh mesh = read_fine(same[i]);
        assert_int_equal(mesh.triangle_count, 1);
        assert_triangle(&mesh, 0, 0, 1, 2);
        assert_true(mesh.points[2].x == 1.0f && mesh.points[2].y == 1.0f && mesh.points[2].z == 0.0f);
    }
}

TEST(test_materials)
{
    ObjMesh mesh = read_fine(
        SQUARE "f 1 2 3\nusemtl red wine  # white\nf 1 2 4\nusemtl b#\nf 1 3 4\nusemtl red wine\r\nf 2 3 4\n");
    const uint32_t materials[4] = {OBJ_NONE, 1, 2, 1};
    for (size_t i = 0; i < 4; i++)
        assert_int_equal(mesh.triangles[i].material, materials[i]);
}

// Numbers come out as the C library reads them, to the last bit of a float.
TEST(test_numbers)
{
    char words[] = "0 -0 1 -1.5 3.14159265358979323846264338327950288 16777217 1e-45 1.17549e-38 123456789 "
                   "0.000000000000000000000000000000123456789 9999999999e-5 1e22 1e23 4.35e-30 00012.50 "
                   "1234567890123456789012345 1e-400 0.1";
    for (const char *word = strtok(words, " "); word; word = strtok(NULL, " ")) {
        const char *at = word, *end = word + strlen(word);
        double value = 1;
        assert_true(text_number(&at, end, &value));
        assert_ptr_equal(at, end);
        float ours = (float)value, expected = strtof(word, NULL);
        assert_memory_equal(&ours, &expected, sizeof ours);
    }
    const char *none[] = {"", "-", ".", "e5", "nan", "inf", "+-1", "x"};
    for (size_t i = 0; i < sizeof none / sizeof none[0]; i++) {
        const char *at = none[i];
        double value;
        assert_false(text_number(&at, none[i] + strlen(none[i]), &value));
        assert_ptr_equal(at, none[i]);
    }
    const char *at = "2e";
    double value;
    assert_true(text_number(&at, at + 2, &value));
    assert_true(value == 2 && *at == 'e'); // an exponent needs digits
}

// A triangle strip, large enough that arrays move often.
TEST(test_many)
{
    enum { POINTS = 20000 };
    char *text = memory(POINTS, 60), *at = text;
    for (int i = 0; i < POINTS; i++)
        at += sprintf(at, "v %d.25 %d 0\n", i, i % 2);
    for (int i = 1; i + 2 <= POINTS; i++)
        at += sprintf(at, "f %d %d %d\n", i, i + 1, i + 2);
    ObjMesh mesh = read_fine(text);
    assert_int_equal(mesh.point_count, POINTS);
    assert_int_equal(mesh.triangle_count, POINTS - 2);
    assert_triangle(&mesh, POINTS - 3, POINTS - 3, POINTS - 2, POINTS - 1);
    assert_true(mesh.points[12345].x == 12345.25f);
}
