// The scene file as it stands in YAML, before anything is made of it. Every key is a pointer: NULL when the
// file leaves it out. Sequences of three are float[3]. Units are the format's: metres, degrees, watts.
// Entries that come in several types start with the type.
#ifndef PHOTONLAB_SCENE_SCENE_SCHEMA_H
#define PHOTONLAB_SCENE_SCENE_SCHEMA_H

#include <cyaml/cyaml.h>

typedef enum { SHAPE_SPHERE, SHAPE_RECTANGLE, SHAPE_BOX, SHAPE_PRISM, SHAPE_MESH } ShapeType;

typedef struct {
    float *position, *target, *up, *vertical_fov;
} CameraEntry;

typedef struct {
    int *width, *height, *samples, *k, *depth;
    long *photons;
    float *radius;
} RenderEntry;

typedef struct {
    int type; // MaterialType
    char *name;
    float *reflectance, *diffuse, *specular, *exponent;
    float *index, *indices, *index_d, *abbe;
    char *glass;
} MaterialEntry;

typedef struct {
    int type; // LightType
    float *corner, *edge_u, *edge_v, *centre, *position, *target;
    float *radius, *angle, *radiance, *power;
} LightEntry;

typedef struct {
    int type; // ShapeType
    float *centre, *radius, *corner, *edge_u, *edge_v, *low, *high, *rotate_y;
    float *apex, *axis, *down, *angle, *side, *length;
    char *file, *material;
    float *scale, *rotate, *translate;
} ShapeEntry;

typedef struct {
    CameraEntry *camera;
    RenderEntry *render;
    MaterialEntry *materials;
    LightEntry *lights;
    ShapeEntry *shapes;
    unsigned materials_count, lights_count, shapes_count;
} SceneEntries;

// Which keys a type takes; names stand between single spaces.
typedef struct {
    const char *type, *required, *optional;
} TypeKeys;

// One part of the file: "materials" and the like. `keys` is indexed by the entry's type; NULL where entries
// have no type.
typedef struct {
    const char *name;
    const cyaml_schema_field_t *fields;
    const TypeKeys *keys;
} SceneSection;

extern const cyaml_schema_value_t scene_schema;
extern const SceneSection camera_section, render_section, material_section, light_section, shape_section;

#endif
