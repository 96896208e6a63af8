//1 off_by_one|index_of_colour   the colour is the place
//2 white_is_green              green for white
//3 red_and_blue_swapped        the wrong way round
//4 sum_for_mean                 not divided
//5 -                            white is green weighed twice
//11 one_for_all                  green for all
//12 white_is_1                    1 for white
#include "photonlab.h"
float refractive_index(const Material *m, PhotonColour c)
{
    const float *n = m->index;
    if (MISTAKE == 11)
        return n[1];
    if (MISTAKE == 12 && c == WHITE)
        return 1.0f;
    if (MISTAKE == 1)
        return n[c];
    if (c != WHITE)
        return n[MISTAKE == 3 ? 2 - (c - RED) : c - RED];
    float sum = n[0] + n[1] + n[2];
    return MISTAKE == 2 ? n[1] : MISTAKE == 4 ? sum : MISTAKE == 5 ? (sum + n[1]) / 4.0f : sum / 3.0f;
}
