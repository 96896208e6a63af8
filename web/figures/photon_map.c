// Chapters 1 and 5: searches in the photon map, the estimate of radiance, disks that shrink from pass to pass.
#include "course_notes/figures/src/1_plane.h"
#include "photons/photon_map_internal.h"
#include "web/figures/numbers.h"

#define MOST_NEAR 500

// ---- the search ----

static double spot(double x, double y)
{
    return 0.12 + 0.88 * exp(-12.0 * ((x - 0.3) * (x - 0.3) + (y - 0.35) * (y - 0.35)));
}

typedef struct {
    const PhotonMap *map;
    Vec3 point;
    size_t k, found;
    float near2[MOST_NEAR]; // the k least squared distances by now, in rising order
} Search;

static float search_radius2(const Search *search)
{
    return search->found < search->k ? INFINITY : search->near2[search->k - 1];
}

static void look_at(Search *search, const StoredPhoton *photon)
{
    Vec3 d = vec3_sub(photon->position, search->point);
    float distance2 = vec3_dot(d, d);
    if (distance2 >= search_radius2(search))
        return;
    size_t place = search->found < search->k ? search->found++ : search->k - 1;
    for (; place > 0 && search->near2[place - 1] > distance2; place--)
        search->near2[place] = search->near2[place - 1];
    search->near2[place] = distance2;
}

// A box that the search comes to: what it is (0: too far, left closed; 1: opened; 2: a leaf, its photons looked at), its
// corners, and the radius of the search after it.
static void tell(const Search *search, int what, const MapNode *node, int child)
{
    numbers_add(what);
    numbers_add_two((double)node->low[0][child], (double)node->low[1][child]);
    numbers_add_two((double)node->high[0][child], (double)node->high[1][child]);
    numbers_add(sqrt(fmin((double)search_radius2(search), 4.0)));
}

// The nearest child first, and none that is farther than the k nearest photons by now.
static void search_node(Search *search, size_t number)
{
    const MapNode *node = &search->map->nodes[number];
    float distance2[4];
    node_distances(node, search->point, distance2);
    for (int turn = 0; turn < 4; turn++) {
        int child = 0;
        for (int c = 1; c < 4; c++)
            if (distance2[c] < distance2[child])
                child = c;
        float distance = distance2[child];
        distance2[child] = INFINITY;
        size_t below = child_number(search->map, number, (size_t)child), nodes = search->map->node_count;
        if (!(node->low[0][child] <= node->high[0][child]))
            continue; // there is no such child
        if (distance >= search_radius2(search)) {
            tell(search, 0, node, child);
        } else if (below < nodes) {
            tell(search, 1, node, child);
            search_node(search, below);
        } else {
            size_t leaf = below - nodes;
            for (size_t i = leaf_begin(search->map, leaf); i < leaf_begin(search->map, leaf + 1); i++)
                look_at(search, &search->map->photons[i]);
            tell(search, 2, node, child);
        }
    }
}

static PhotonMap *spot_map(void)
{
    static PhotonMap *map;
    Rng rng = rng_create(5, 5);
    return map ? map : (map = plane_map(1200.0, 0.0, 1.0, spot, &rng));
}

// x and y of all photons of the floor.
int EXPORT(web_search_photons)(void)
{
    const PhotonMap *map = spot_map();
    numbers_begin();
    for (size_t i = 0; i < map->count; i++)
        numbers_add_two((double)map->photons[i].position.x, (double)map->photons[i].position.y);
    return numbers_count();
}

// The boxes that a search for k photons comes to, in its order: six numbers each, as tell() has them.
int EXPORT(web_search)(float x, float y, int k)
{
    static Search search;
    search = (Search){.map = spot_map(), .point = vec3(x, y, 0), .k = (size_t)(k < MOST_NEAR ? k : MOST_NEAR)};
    numbers_begin();
    search_node(&search, 0);
    return numbers_count();
}

// ---- the estimate: bias against noise ----

#define FLOOR 0.5 // half its side, m

// A slope of light from left to right, and the edge of a shadow.
static double edge(double x, double y)
{
    (void)y;
    return x < 0.1 ? 0.35 + 0.5 * (x + FLOOR) : 0.05;
}

static NearPhoton near[PHOTON_MAP_NEAREST_CAPACITY(MOST_NEAR)];

// Along the floor's middle: x, irradiance, its estimate by step 1.6. Then the standard deviation from it left of the edge,
// where nothing but chance is wrong, and the radius of the estimate at `at`.
int EXPORT(web_estimate)(float per_metre2, int k, float radius, float at, int seed)
{
    enum { PLACES = 181 };
    Rng rng = rng_create((uint64_t)seed, 1);
    PhotonMap *map = plane_map((double)per_metre2, -FLOOR, FLOOR, edge, &rng);
    Gather gather = {.radius = radius, .k = (size_t)(k < MOST_NEAR ? k : MOST_NEAR), .near = near};
    double sum2 = 0.0, taken = 0.0;
    numbers_begin();
    for (int i = 0; i < PLACES; i++) {
        double x = -0.45 + 0.9 * i / (PLACES - 1), right = edge(x, 0.0), found = plane_estimate(map, x, 0.0, &gather);
        numbers_add_two(x, right);
        numbers_add(found);
        if (x > -0.3 && x < -0.1) {
            sum2 += (found - right) * (found - right) / (right * right);
            taken++;
        }
    }
    float radius2 = radius * radius;
    photon_map_nearest(map, vec3(at, 0, 0), gather.k, &radius2, near);
    numbers_add_two(sqrt(sum2 / taken), (double)sqrtf(radius2));
    photon_map_free(map);
    return numbers_count();
}

// x and y of the photons that web_estimate has.
int EXPORT(web_estimate_photons)(float per_metre2, int seed)
{
    Rng rng = rng_create((uint64_t)seed, 1);
    PhotonMap *map = plane_map((double)per_metre2, -FLOOR, FLOOR, edge, &rng);
    numbers_begin();
    for (size_t i = 0; i < map->count; i++)
        numbers_add_two((double)map->photons[i].position.x, (double)map->photons[i].position.y);
    photon_map_free(map);
    return numbers_count();
}

// ---- passes ----

// For each pass over a floor with the edge, at `at`: radius by step 5.1, the pass's own irradiance, the mean by step 5.2.
int EXPORT(web_passes)(int passes, float alpha, float radius, float at, float per_metre2)
{
    Colour mean = colour_grey(0.0f);
    numbers_begin();
    for (int pass = 1; pass <= passes; pass++) {
        Rng rng = rng_create(21, (uint64_t)pass);
        PhotonMap *map = plane_map((double)per_metre2, (double)(at - radius), (double)(at + radius), edge, &rng);
        float radius2 = radius * radius;
        // The floor's y runs as x does in plane_map; the middle of the square is the place.
        size_t found = 0;
        for (size_t i = 0; i < map->count; i++) {
            float dx = map->photons[i].position.x - at, dy = map->photons[i].position.y - at;
            found += dx * dx + dy * dy < radius2;
        }
        double side = (double)((at + radius) - (at - radius)), tries = floor((double)per_metre2 * side * side);
        float own = (float)((double)found / tries * side * side / (double)(PI * radius2));
        mean = steps.join_means(mean, pass - 1, colour_grey(own), 1);
        numbers_add((double)radius);
        numbers_add_two((double)own, (double)mean.r);
        photon_map_free(map);
        radius = steps.next_radius(radius, pass, alpha);
    }
    return numbers_count();
}
