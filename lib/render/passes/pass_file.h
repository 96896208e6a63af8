// Files of passes (.part): what an interrupted picture goes on from, and what machines that share its passes hand in. Lines of
// text that say what it is, then floats, little-endian on every machine.
#pragma once

#include "render/passes/passes.h"

#define PASS_FILE_ENDING ".part"
#define MOST_PASSES      1000000

// Two files belong to one picture if `made` and `all` are the same.
typedef struct {
    char scene[300], settings[600], code[200]; // lines: what decides about the bytes. settings: as flags of `render`
    int part, parts, all;                      // part number `part`, from 1, of `parts`, of `all` passes
} PassOrigin;

// The passes of the part, counted from 0: first … last−1.
void pass_origin_range(const PassOrigin *origin, int *first, int *last);

// In words, what is different; false: nothing is.
bool pass_origin_differs(const PassOrigin *origin, const PassOrigin *other, char *text, size_t size);

// The scene's line: the name of its file, and a number that is another where the file or a mesh is another.
bool pass_origin_scene(const char *path, const Scene *scene, PassOrigin *origin, Error *error);

// The settings' line.
void pass_origin_settings(const RenderOptions *options, const Passes *passes, PassOrigin *origin);

// passes->done may be less than the part asks for. Reading: fills in both; passes->heard stays as it is. False, saying why, when
// it cannot be read, or is damaged.
bool pass_file_write(const char *path, const PassOrigin *origin, const Passes *passes, Error *error);
bool pass_file_read(const char *path, PassOrigin *origin, Passes *passes, Error *error);
