// One row of weights a colour.
#include "photonlab.h"

static const float weights[4][3] = {
    [WHITE] = {1.0f / 3.0f, 1.0f / 3.0f, 1.0f / 3.0f},
    [RED] = {1.0f, 0.0f, 0.0f},
    [GREEN] = {0.0f, 1.0f, 0.0f},
    [BLUE] = {0.0f, 0.0f, 1.0f},
};

float refractive_index(const Material *glass, PhotonColour colour)
{
    const float *w = weights[colour];
    return w[0] * glass->index[0] + w[1] * glass->index[1] + w[2] * glass->index[2];
}
