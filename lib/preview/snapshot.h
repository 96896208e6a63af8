// Pictures of the preview in files.
#ifndef PHOTONLAB_PREVIEW_SNAPSHOT_H
#define PHOTONLAB_PREVIEW_SNAPSHOT_H

#include "preview/session.h"

// Writes what the canvas shows; the old file stays when that fails.
bool snapshot_write(Canvas *canvas, const char *path, Error *error);

// The flags that make the session's present picture again, to be typed.
void snapshot_command(const Session *session, char *text, size_t size);

#endif
