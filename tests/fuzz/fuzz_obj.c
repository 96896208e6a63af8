// Feeds the OBJ reader with whatever libFuzzer thinks of: a mesh or a message, no crash, no leak.
#include "fuzz/fuzz.h"
#include "scene/bvh/shape.h"
#include "scene/file/obj.h"

static const char *name_at(const void *names, size_t i)
{
    return i < 2 ? ((const char *const *)names)[i] : NULL;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    // A copy without a byte behind it: reading on is seen.
    char *text = malloc(size ? size : 1);
    require(text != NULL);
    memcpy(text, data, size);
    Error error = {""};
    ObjMesh mesh;
    const char *materials[2] = {"red", "white"};
    ObjNames names = {name_at, materials, "fuzz.yaml"};
    bool fine = obj_read_text(text, size, "fuzz.obj", &names, &mesh, &error);
    require(fine ? error.message[0] == '\0' : error.message[0] != '\0');
    for (size_t i = 0; fine && i < mesh.triangle_count; i++) {
        const ObjTriangle *t = &mesh.triangles[i];
        for (int k = 0; k < 3; k++) {
            require(t->point[k] < mesh.point_count);
            require(t->normal[0] == OBJ_NONE ? t->normal[k] == OBJ_NONE : t->normal[k] < mesh.normal_count);
        }
        Vec3 origin = mesh.points[t->point[0]];
        require(!flat_is_degenerate(vec3_sub(mesh.points[t->point[1]], origin),
                                    vec3_sub(mesh.points[t->point[2]], origin)));
        require(t->material == OBJ_NONE || t->material < 2);
    }
    for (size_t i = 0; i < mesh.normal_count && fine; i++)
        require(fabsf(vec3_length(mesh.normals[i]) - 1.0f) < 1e-3f);
    obj_free(&mesh);
    free(text);
    return 0;
}
