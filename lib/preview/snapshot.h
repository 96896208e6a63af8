// Pictures of the preview in files.
#ifndef PHOTONLAB_PREVIEW_SNAPSHOT_H
#define PHOTONLAB_PREVIEW_SNAPSHOT_H

#include "preview/session.h"

// Writes what the canvas shows; the old file stays when that fails.
bool snapshot_write(Canvas *canvas, const char *path, Error *error);

// Draws both sides with the words that the session has for them.
void session_draw(const Session *session, Canvas *canvas, const View *view, bool bare);

// The flags that make the same picture again, to be typed.
void snapshot_command(const PreviewOptions *options, const View *view, const Session *session, int width, int height,
                      char *text, size_t size);

#endif
