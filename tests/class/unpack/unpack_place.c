// What a path says about a file: whose step, in which folder, likely meant or not.
#include "class/unpack/unpack.h"

#include <string.h>
#include <strings.h>

// Is one of the folders above the file called so?
static bool is_below(const char *path, int folder, const char *name)
{
    size_t length = strlen(name);
    for (const char *at = path; at && at < path + folder; at = strchr(at, '/') ? strchr(at, '/') + 1 : NULL)
        if (strncmp(at, name, length) == 0 && (at[length] == '/' || name[length - 1] == '-'))
            return true;
    return false;
}

Place place_of(const char *path)
{
    Place place = {.name = strrchr(path, '/') ? strrchr(path, '/') + 1 : path};
    place.folder = place.name > path ? (int)(place.name - path - 1) : 0;
    for (size_t i = 0; i < STEP_COUNT; i++) {
        const char *file = step_table[i].file, *slash = strchr(file, '/');
        size_t length = strlen(slash + 1);
        int stage = (int)(slash - file), before = place.folder - stage;
        if (strncasecmp(place.name, slash + 1, length) == 0 && strcasecmp(place.name + length, ".c") == 0)
            place.step = &step_table[i];
        if (before >= 0 && strncmp(path + before, file, (size_t)stage) == 0 &&
            (before == 0 || path[before - 1] == '/')) {
            place.stage = file;
            place.stage_length = stage;
        }
    }
    place.root = place.folder;
    if (place.stage)
        place.root = place.folder > place.stage_length ? place.folder - place.stage_length - 1 : 0;
    static const char *const foreign[] = {"solutions", "tests", "prebuilt", "build", "lib", "scenes", "before-update-"};
    for (size_t i = 0; i < sizeof foreign / sizeof *foreign; i++)
        place.foreign = place.foreign || is_below(path, place.folder, foreign[i]);
    return place;
}

int place_rank(const Place *place, const char *path)
{
    const int word = (int)strlen("exercises");
    int rank = place->stage ? 1 : 0;
    if (place->root >= word && strncmp(path + place->root - word, "exercises", (size_t)word) == 0)
        rank += 1000;
    for (int i = 0; i < place->root; i++)
        rank -= path[i] == '/' ? 2 : 0;
    return rank;
}
