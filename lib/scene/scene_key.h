// The keys of the scene file: each is one row of a type's table. Reading and checking a file, "did you mean",
// scenes/README.md and the fuzzer's words follow from the rows; what a key does is in its type's build function.
#pragma once

#include "base/error.h"
#include "math/colour.h"
#include "math/vec3.h"

#include <stdbool.h>

typedef enum {
    KEY_NUMBER,
    KEY_WHOLE,  // a whole number
    KEY_THREE,  // [x, y, z]
    KEY_COLOUR, // [red, green, blue]
    KEY_WORD,
    KEY_TYPE, // the name of a type
} SceneKeyKind;

typedef struct {
    double low, high;     // of a number, or of each of three; of a word: its length
    bool open;            // low and high themselves are refused
    const char *unit;     // NULL: a bare number
    const char *expected; // in messages; NULL: low, high and unit
} SceneRange;

typedef struct {
    const char *name;
    SceneKeyKind kind;
    const char *otherwise; // where a file leaves the key out: KEY_REQUIRED, KEY_OPTIONAL, or the value that holds then
    SceneRange range;
    const char *meaning; // for scenes/README.md
} SceneKey;

#define MOST_SCENE_KEYS 11
typedef SceneKey SceneKeys[MOST_SCENE_KEYS + 1]; // a table; behind its last row there is one without a name

#define KEY_REQUIRED NULL
#define KEY_OPTIONAL ""

#define RANGE(low, high, unit)                {low, high, false, unit, NULL}
#define RANGE_TOLD(low, high, unit, expected) {low, high, false, unit, expected}
#define RANGE_ANGLE                           {0, 180, true, "degrees", "an angle between 0 and 180 degrees"}

// Others that several keys have; their numbers stand in scene/limits.h.
#define RANGE_METRES  RANGE(-SCENE_LARGEST_NUMBER, SCENE_LARGEST_NUMBER, "m")
#define RANGE_DEGREES RANGE(-SCENE_LARGEST_NUMBER, SCENE_LARGEST_NUMBER, "degrees")
#define RANGE_ANY     RANGE(-SCENE_LARGEST_NUMBER, SCENE_LARGEST_NUMBER, NULL)
#define RANGE_LENGTH  RANGE_TOLD(SCENE_SMALLEST_LENGTH, SCENE_LARGEST_NUMBER, "m", "a number greater than 0 (from 1e-9)")
#define RANGE_FACTOR                                                                                                   \
    RANGE_TOLD(SCENE_SMALLEST_LENGTH, SCENE_LARGEST_NUMBER, NULL, "a number greater than 0 (from 1e-9)")
#define RANGE_SHARE RANGE(0, 1, NULL)
#define RANGE_NAME  RANGE(1, 63, "characters")

// One of the types of a section (materials, lights, shapes), or the section itself where it has no types (camera).
typedef struct {
    const char *name;    // as `type:` gives it
    const char *called;  // in messages: "glossy material"
    const char *meaning; // for scenes/README.md
    const SceneKey *keys;
    const char *example; // an entry, as YAML
} SceneType;

// What a file says of one material, light or shape: keys are those of its type, their values in range.
typedef struct SceneEntry SceneEntry;

// Does the file give this key?
bool scene_given(SceneEntry *entry, const char *key);

// The value of a key: the file's, or the one that holds otherwise. 0 and NULL where an optional key was left out. Asking
// for a key that has no row is a fault of the entry, and so is a key that nobody asks for.
float scene_number(SceneEntry *entry, const char *key);
long scene_whole(SceneEntry *entry, const char *key);
Vec3 scene_three(SceneEntry *entry, const char *key);
Colour scene_colour(SceneEntry *entry, const char *key);
const char *scene_word(SceneEntry *entry, const char *key);

// "file:line:column: …" with the place of a key's value, or of the entry itself (NULL, or a key that the file does not
// give). Always false.
bool scene_fault(const SceneEntry *entry, const char *key, const char *format, ...) PRINTF_LIKE(3, 4);
