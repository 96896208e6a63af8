// A photon map seen from above: 1_kdtree OUT.dat OUT.txt
// OUT.dat, block 0: photons; 1: boxes of the leaves that a search need not open, 2: of those it must (corner and far
// corner); 3: where the search is and its radius.
#include "1_plane.h"
#include "photons/photon_map_internal.h"

enum { K = 12 };

static double spot(double x, double y)
{
    return 0.12 + 0.88 * exp(-12.0 * ((x - 0.3) * (x - 0.3) + (y - 0.35) * (y - 0.35)));
}

// How far the search at (x, y) is from the leaf's own box. Also gives the box.
static double leaf_distance(const PhotonMap *map, size_t leaf, double x, double y, double box[4])
{
    box[0] = box[1] = INFINITY;
    box[2] = box[3] = -INFINITY;
    for (size_t i = leaf_begin(map, leaf); i < leaf_begin(map, leaf + 1); i++) {
        double px = (double)map->photons[i].position.x;
        double py = (double)map->photons[i].position.y;
        box[0] = fmin(box[0], px);
        box[1] = fmin(box[1], py);
        box[2] = fmax(box[2], px);
        box[3] = fmax(box[3], py);
    }
    double dx = fmax(0.0, fmax(box[0] - x, x - box[2]));
    double dy = fmax(0.0, fmax(box[1] - y, y - box[3]));
    return sqrt(dx * dx + dy * dy);
}

int main(int count, char **names)
{
    NearPhoton near[PHOTON_MAP_NEAREST_CAPACITY(K)];
    Error error = {{0}};
    FILE *data = count == 3 ? fopen(names[1], "w") : NULL;
    FILE *text = count == 3 ? fopen(names[2], "w") : NULL;
    if (!data || !text || !steps_load(NULL, &error))
        give_up("usage: 1_kdtree OUT.dat OUT.txt");
    Rng rng = rng_create(5, 5);
    PhotonMap *map = plane_map(1200.0, 0.0, 1.0, spot, &rng);
    float radius2 = INFINITY;
    const double x = 0.62;
    const double y = 0.5;
    photon_map_nearest(map, vec3((float)x, (float)y, 0), K, &radius2, near);

    for (size_t i = 0; i < map->count; i++)
        fprintf(data, "%.4f %.4f\n", (double)map->photons[i].position.x, (double)map->photons[i].position.y);
    size_t opened = 0;
    for (int want = 0; want < 2; want++) {
        fprintf(data, "\n\n");
        for (size_t leaf = 0; leaf < (size_t)1 << map->depth; leaf++) {
            double box[4];
            bool open = leaf_distance(map, leaf, x, y, box) < (double)sqrtf(radius2);
            if (open == want)
                fprintf(data, "%.4f %.4f %.4f %.4f\n", box[0], box[1], box[2], box[3]);
            opened += open && want;
        }
    }
    fprintf(data, "\n\n%.4f %.4f %.4f\n", x, y, (double)sqrtf(radius2));
    fprintf(text, "photons %zu\nleaves %d\nopened %zu\ndepth %d\n", map->count, 1 << map->depth, opened, map->depth);
    photon_map_free(map);
    return fclose(data) | fclose(text);
}
