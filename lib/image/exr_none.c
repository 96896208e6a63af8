// In the place of exr.c, where the Makefile finds no OpenEXR.
#include "image/codec.h"

const ImageFormat image_format_exr = {
    .ending = ".exr",
    .use = "to measure, for other programs",
    .missing = "built without OpenEXR (on Debian: apt-get install libopenexr-dev, then make)",
};
