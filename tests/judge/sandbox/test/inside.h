#ifndef PHOTONLAB_TEST_INSIDE_H
#define PHOTONLAB_TEST_INSIDE_H

// `what` is done, with `path` where it needs one. Returns the program's exit code; 99: there is no such thing to do.
int inside(const char *what, const char *path);

#endif
