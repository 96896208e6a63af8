// A live picture in the viewer tev, by its protocol over TCP.
#ifndef PHOTONLAB_CLI_TEV_H
#define PHOTONLAB_CLI_TEV_H

#include "image/image.h"

#define TEV_PORT "14158" // where tev listens, unless --host tells it otherwise

typedef struct Tev Tev;

// Connects to "HOST" or "HOST:PORT" and opens a black picture there under this name; both texts are to stay till the end. NULL, with the error, when nobody answers.
Tev *tev_open(const char *address, const char *name, int width, int height, Error *error);

// Shows a rectangle of the picture, or all of it. A viewer that has gone is told of by tev_close, and holds up nothing; one that takes
// nothing for ten seconds counts as gone. tev_show: a Tev takes RenderOptions.tiles.
void tev_show(void *tev, const Image *image, int x, int y, int width, int height);
void tev_show_all(Tev *tev, const Image *image);

// False, with the error, when the viewer went before the end. The picture stays there.
bool tev_close(Tev *tev, Error *error);

#endif
