#include "scene/file/scene_schema.h"

#include "scene/light.h"
#include "scene/limits.h"
#include "scene/scene.h"

// Every key but `type` is held by pointer, so that a missing one can be told from a zero.
#define OPTIONAL                         CYAML_FLAG_OPTIONAL
#define NUMBER(entry, flags, key)        CYAML_FIELD_FLOAT_PTR(#key, flags, entry, key)
#define WHOLE(entry, key)                CYAML_FIELD_INT_PTR(#key, OPTIONAL, entry, key)
#define THREE(entry, flags, key)         CYAML_FIELD_SEQUENCE_FIXED(#key, CYAML_FLAG_POINTER | (flags), entry, key, &number, 3)
#define WORD(entry, flags, key, longest) CYAML_FIELD_STRING_PTR(#key, flags, entry, key, 1, longest)
#define TYPE(entry, names)               CYAML_FIELD_ENUM("type", CYAML_FLAG_STRICT, entry, type, names, CYAML_ARRAY_LEN(names))
#define LIST(key, value, most)                                                                                         \
    CYAML_FIELD_SEQUENCE(#key, CYAML_FLAG_POINTER | OPTIONAL, SceneEntries, key, &(value), 0, most)

static const cyaml_schema_value_t number = {CYAML_VALUE_FLOAT(CYAML_FLAG_DEFAULT, float)};

static const cyaml_strval_t material_types[] = {
    {"diffuse", MATERIAL_DIFFUSE},
    {"glossy", MATERIAL_GLOSSY},
    {"mirror", MATERIAL_MIRROR},
    {"glass", MATERIAL_GLASS},
};
static const TypeKeys material_keys[] = {
    [MATERIAL_DIFFUSE] = {"diffuse material", "reflectance", ""},
    [MATERIAL_GLOSSY] = {"glossy material", "diffuse specular exponent", ""},
    [MATERIAL_MIRROR] = {"mirror", "", "reflectance"},
    [MATERIAL_GLASS] = {"glass", "", "index indices glass index_d abbe"},
};
static const cyaml_schema_field_t material_fields[] = {
    WORD(MaterialEntry, CYAML_FLAG_DEFAULT, name, sizeof(((Material *)0)->name) - 1),
    TYPE(MaterialEntry, material_types),
    THREE(MaterialEntry, OPTIONAL, reflectance),
    THREE(MaterialEntry, OPTIONAL, diffuse),
    THREE(MaterialEntry, OPTIONAL, specular),
    NUMBER(MaterialEntry, OPTIONAL, exponent),
    NUMBER(MaterialEntry, OPTIONAL, index),
    THREE(MaterialEntry, OPTIONAL, indices),
    WORD(MaterialEntry, OPTIONAL, glass, 63),
    NUMBER(MaterialEntry, OPTIONAL, index_d),
    NUMBER(MaterialEntry, OPTIONAL, abbe),
    CYAML_FIELD_END,
};

static const cyaml_strval_t light_types[] = {
    {"rectangle", LIGHT_RECTANGLE}, {"sphere", LIGHT_SPHERE}, {"point", LIGHT_POINT},
    {"spot", LIGHT_SPOT},           {"beam", LIGHT_BEAM},
};
static const TypeKeys light_keys[] = {
    [LIGHT_RECTANGLE] = {"rectangle light", "corner edge_u edge_v", "radiance power"},
    [LIGHT_SPHERE] = {"sphere light", "centre radius", "radiance power"},
    [LIGHT_POINT] = {"point light", "position power", ""},
    [LIGHT_SPOT] = {"spot light", "position target angle power", ""},
    [LIGHT_BEAM] = {"beam light", "position target radius power", ""},
};
static const cyaml_schema_field_t light_fields[] = {
    TYPE(LightEntry, light_types),         THREE(LightEntry, OPTIONAL, corner),  THREE(LightEntry, OPTIONAL, edge_u),
    THREE(LightEntry, OPTIONAL, edge_v),   THREE(LightEntry, OPTIONAL, centre),  THREE(LightEntry, OPTIONAL, position),
    THREE(LightEntry, OPTIONAL, target),   NUMBER(LightEntry, OPTIONAL, radius), NUMBER(LightEntry, OPTIONAL, angle),
    THREE(LightEntry, OPTIONAL, radiance), THREE(LightEntry, OPTIONAL, power),   CYAML_FIELD_END,
};

static const cyaml_strval_t shape_types[] = {
    {"sphere", SHAPE_SPHERE}, {"rectangle", SHAPE_RECTANGLE}, {"box", SHAPE_BOX},
    {"prism", SHAPE_PRISM},   {"mesh", SHAPE_MESH},
};
static const TypeKeys shape_keys[] = {
    [SHAPE_SPHERE] = {"sphere", "centre radius material", ""},
    [SHAPE_RECTANGLE] = {"rectangle", "corner edge_u edge_v material", ""},
    [SHAPE_BOX] = {"box", "low high material", "rotate_y"},
    [SHAPE_PRISM] = {"prism", "apex axis down angle side length material", ""},
    [SHAPE_MESH] = {"mesh", "file", "material scale rotate translate"},
};
static const cyaml_schema_field_t shape_fields[] = {
    TYPE(ShapeEntry, shape_types),
    THREE(ShapeEntry, OPTIONAL, centre),
    NUMBER(ShapeEntry, OPTIONAL, radius),
    THREE(ShapeEntry, OPTIONAL, corner),
    THREE(ShapeEntry, OPTIONAL, edge_u),
    THREE(ShapeEntry, OPTIONAL, edge_v),
    THREE(ShapeEntry, OPTIONAL, low),
    THREE(ShapeEntry, OPTIONAL, high),
    NUMBER(ShapeEntry, OPTIONAL, rotate_y),
    THREE(ShapeEntry, OPTIONAL, apex),
    THREE(ShapeEntry, OPTIONAL, axis),
    THREE(ShapeEntry, OPTIONAL, down),
    NUMBER(ShapeEntry, OPTIONAL, angle),
    NUMBER(ShapeEntry, OPTIONAL, side),
    NUMBER(ShapeEntry, OPTIONAL, length),
    WORD(ShapeEntry, OPTIONAL, file, 1023),
    NUMBER(ShapeEntry, OPTIONAL, scale),
    THREE(ShapeEntry, OPTIONAL, rotate),
    THREE(ShapeEntry, OPTIONAL, translate),
    WORD(ShapeEntry, OPTIONAL, material, 63),
    CYAML_FIELD_END,
};

static const cyaml_schema_field_t camera_fields[] = {
    THREE(CameraEntry, CYAML_FLAG_DEFAULT, position),
    THREE(CameraEntry, CYAML_FLAG_DEFAULT, target),
    THREE(CameraEntry, OPTIONAL, up),
    NUMBER(CameraEntry, CYAML_FLAG_DEFAULT, vertical_fov),
    CYAML_FIELD_END,
};
static const cyaml_schema_field_t render_fields[] = {
    WHOLE(RenderEntry, width),   WHOLE(RenderEntry, height),
    WHOLE(RenderEntry, samples), WHOLE(RenderEntry, photons),
    WHOLE(RenderEntry, k),       NUMBER(RenderEntry, OPTIONAL, radius),
    WHOLE(RenderEntry, depth),   CYAML_FIELD_END,
};

static const cyaml_schema_value_t material_value = {
    CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, MaterialEntry, material_fields)};
static const cyaml_schema_value_t light_value = {CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, LightEntry, light_fields)};
static const cyaml_schema_value_t shape_value = {CYAML_VALUE_MAPPING(CYAML_FLAG_DEFAULT, ShapeEntry, shape_fields)};

static const cyaml_schema_field_t scene_fields[] = {
    CYAML_FIELD_MAPPING_PTR("camera", CYAML_FLAG_DEFAULT, SceneEntries, camera, camera_fields),
    CYAML_FIELD_MAPPING_PTR("render", OPTIONAL, SceneEntries, render, render_fields),
    LIST(materials, material_value, MAX_MATERIALS),
    LIST(lights, light_value, 1000),
    LIST(shapes, shape_value, 100000),
    CYAML_FIELD_END,
};
const cyaml_schema_value_t scene_schema = {CYAML_VALUE_MAPPING(CYAML_FLAG_POINTER, SceneEntries, scene_fields)};

const SceneSection camera_section = {"camera", camera_fields, NULL};
const SceneSection render_section = {"render", render_fields, NULL};
const SceneSection material_section = {"materials", material_fields, material_keys};
const SceneSection light_section = {"lights", light_fields, light_keys};
const SceneSection shape_section = {"shapes", shape_fields, shape_keys};
