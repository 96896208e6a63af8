//1 lobe_about_normal        about the normal
//2 no_redraw                taken as it is
//3 cap_not_told             nobody is told
//4 cosine_weight            weighed by the cosine
//5 no_gap                   the lobe always
//6 redraw_diffuse                        a new diffuse direction is tried in each redraw's place, twice
#include "photonlab.h"
bool scatter_glossy_source_text(Vec3 d, Vec3 n, float e, Rng *rng, Vec3 *out, float *weight)
{
    Vec3 m = steps.reflect(d, n), way = steps.scatter_diffuse(n, rng);
    *weight = 1.0f;
    if (vec3_dot(way, m) > 0.0f || MISTAKE == 5) {
        int tries = 0;
        do {
            if (tries++ == MAX_LOBE_TRIES) {
                if (MISTAKE != 3)
                    redraw_cap_reached();
                return false;
            }
            if (MISTAKE == 6 && tries == 2) {
                way = steps.scatter_diffuse(n, rng);
                break;
            }
            way = steps.turn_to(steps.sample_lobe(e, rng), MISTAKE == 1 ? n : m);
        } while (MISTAKE != 2 && vec3_dot(way, n) <= 0.0f);
        if (MISTAKE == 4)
            *weight = vec3_dot(way, n);
    }
    *out = way;
    return true;
}
