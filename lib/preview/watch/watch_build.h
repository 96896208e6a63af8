// One run of the compiler for the watch, in the background.
#ifndef PHOTONLAB_PREVIEW_WATCH_BUILD_H
#define PHOTONLAB_PREVIEW_WATCH_BUILD_H

#include "base/error.h"
#include "base/process.h"

typedef struct {
    Process compiler;
    double started;
    char text[16384];
    size_t size;
} Build;

// Runs `sh -c command sh source object` with LC_ALL=C, in a process group of its own. Makes the object's folder.
bool build_start(Build *build, const char *command, const char *source, const char *object, Error *error);
// Without waiting: has it ended? Then *ok tells how, and build->text what it printed.
bool build_poll(Build *build, bool *ok);
// The line of its text that tells most: the first with an error; with the path's folders cut off. Starts with the
// name of a file, `file` where the line has none.
void build_error_line(const Build *build, const char *file, char *line, size_t size);
// The same for the first warning. False: there is none, and the line stays.
bool build_warning_line(const Build *build, const char *file, char *line, size_t size);

#endif
