// How large and how small things may be. Scene files and flags of the command line ask for no more.
#pragma once

#define MOST_PHOTONS 1000000000L
#define MOST_K       1000000
#define MOST_DEPTH   1000 // bounces: step 3.4 calls itself for each
#define MOST_SIDE    16384
#define MOST_SAMPLES 1000000

#define MAX_MATERIALS 255 // with those of the lights that have a surface
#define MAX_LIGHTS    1000
#define MAX_SHAPES    100000 // entries of a file; a mesh is one

// Rays are followed in single precision, where the square of an area must still be a number: that bounds lengths on
// both sides.
#define SCENE_LARGEST_NUMBER  1e9 // of any number in a scene file or mesh
#define SCENE_SMALLEST_LENGTH 1e-9f
