// The search for the k nearest photons: walk the tree from the nearest box to farther ones, collect all photons closer
// than a limit, and select the k nearest when the array is full and at the end. A heap would keep them in order all the
// time, which costs more, and no caller needs an order.
#include "photons/photon_map_internal.h"

#include <string.h>

typedef struct {
    const PhotonMap *map;
    Vec3 point;
    size_t k;
    float limit; // only photons with a smaller distance² count
    NearPhoton *near;
    size_t found;
    uint64_t stack[STACK_CAPACITY]; // what is still to be visited, the nearest on top
    size_t waiting;
} Search;

static float farthest(const NearPhoton *near, size_t count)
{
    float most = 0.0f;
    for (size_t i = 0; i < count; i++)
        most = near[i].distance2 > most ? near[i].distance2 : most;
    return most;
}

// Brings the entries nearer than `pivot` to the front; returns how many they are.
static size_t split_near(NearPhoton *near, size_t count, float pivot)
{
    size_t below = 0;
    for (size_t i = 0; i < count; i++) {
        bool is_below = near[i].distance2 < pivot;
        swap_bytes(&near[i], &near[below], sizeof *near);
        below += is_below;
    }
    return below;
}

// Brings the k nearest to the front and returns the distance² of the farthest of them. Quickselect (Hoare 1961) whose
// first pivots are guesses: around a point on a surface the number of photons grows like distance².
static float keep_nearest(NearPhoton *near, size_t count, size_t k)
{
    enum { GUESSES = 4 };
    size_t low = 0; // entries before `low` are among the nearest, those from `count` on are not
    float nearest = 0.0f;
    float limit = farthest(near, count);
    for (int round = 0; count > k && low < k; round++) {
        float share = ((float)(k - low) + 0.5f) / (float)(count - low);
        float pivot = round < GUESSES ? nearest + (limit - nearest) * share : near[(low + count) / 2].distance2;
        size_t below = low + split_near(near + low, count - low, pivot);
        if (below == low || below == count) { // no progress: split by an entry, and put its equals aside, too
            pivot = near[(low + count) / 2].distance2;
            below = low + split_near(near + low, count - low, pivot);
            if (below < k)
                below += split_near(near + below, count - below, nextafterf(pivot, INFINITY));
            if (below >= k && farthest(near, k) == pivot)
                return pivot;
        }
        if (below >= k) {
            count = below;
            limit = pivot;
        } else {
            low = below;
            nearest = pivot;
        }
    }
    return farthest(near, k);
}

// Distance and number as one integer that sorts by distance: the bits of floats that are not negative sort
// like the floats.
static inline uint64_t pack_waiting(float distance2, size_t number)
{
    uint32_t bits;
    memcpy(&bits, &distance2, sizeof bits);
    return (uint64_t)bits << 32 | (uint32_t)number;
}

static inline float waiting_distance2(uint64_t waiting)
{
    uint32_t bits = (uint32_t)(waiting >> 32);
    float distance2;
    memcpy(&distance2, &bits, sizeof distance2);
    return distance2;
}

static inline void larger_first(uint64_t *a, uint64_t *b)
{
    uint64_t larger = *a > *b ? *a : *b;
    *b = *a > *b ? *b : *a;
    *a = larger;
}

// Puts those of a node's children within reach on the stack, the nearest on top.
static inline void push_children(Search *search, size_t number)
{
    float distance2[4];
    uint64_t order[4];
    node_distances(&search->map->nodes[number], search->point, distance2);
    for (size_t c = 0; c < 4; c++)
        order[c] = pack_waiting(distance2[c], child_number(search->map, number, c));
    larger_first(&order[0], &order[1]); // a sorting network
    larger_first(&order[2], &order[3]);
    larger_first(&order[0], &order[2]);
    larger_first(&order[1], &order[3]);
    larger_first(&order[1], &order[2]);
    for (size_t c = 0; c < 4; c++) {
        search->stack[search->waiting] = order[c];
        search->waiting += waiting_distance2(order[c]) < search->limit;
    }
}

// Appends a leaf's photons that are near enough. Each is written, and stays if it was: a branch would be mispredicted every few
// photons.
static inline void search_leaf(Search *search, size_t leaf)
{
    const PhotonMap *map = search->map;
    size_t end = leaf_begin(map, leaf + 1), found = search->found;
    for (size_t i = leaf_begin(map, leaf); i < end; i++) {
        Vec3 offset = vec3_sub(map->photons[i].position, search->point);
        float distance2 = vec3_dot(offset, offset);
        search->near[found] = (NearPhoton){&map->photons[i], distance2};
        found += distance2 < search->limit;
    }
    search->found = found;
    if (search->found + LEAF_PHOTONS > PHOTON_MAP_NEAREST_CAPACITY(search->k)) {
        search->limit = keep_nearest(search->near, search->found, search->k);
        search->found = search->k;
    }
}

// Finds all within the limit, or the k nearest of them and maybe some more.
static void search_tree(Search *search)
{
    const PhotonMap *map = search->map;
    search->found = 0;
    search->stack[0] = pack_waiting(0.0f, 0);
    search->waiting = 1;
    while (search->waiting > 0) {
        uint64_t next = search->stack[--search->waiting];
        size_t number = (uint32_t)next;
        if (!(waiting_distance2(next) < search->limit))
            continue;
        if (number < map->node_count)
            push_children(search, number);
        else
            search_leaf(search, number - map->node_count);
    }
}

// A distance² within which rather more than k photons lie if they are spread as evenly as in this box: over a
// surface of the size of its two longest sides, or along its longest.
static float guess_from_box(const MapNode *node, size_t c, float photons_in_box, float k)
{
    float x = node->high[0][c] - node->low[0][c];
    float y = node->high[1][c] - node->low[1][c];
    float z = node->high[2][c] - node->low[2][c];
    float longest = fmaxf(x, fmaxf(y, z));
    float area = fmaxf(x * y, fmaxf(y * z, x * z));
    float share = k / photons_in_box;
    float half_line = 0.5f * longest * share;
    float disc2 = area * share / PI;
    // The count varies by about its root: with this much more, one search in a hundred finds too few.
    return fmaxf(disc2, half_line * half_line) * (1.2f + 3.0f / sqrtf(k));
}

// A guess from the box nearest to the point that holds about k photons.
static float guess_limit(const Search *search)
{
    const PhotonMap *map = search->map;
    float k = (float)search->k;
    float photons = (float)map->count * (map->first_child < 0 ? 2.0f : 1.0f);
    size_t number = 0;
    size_t nearest = 0;
    const MapNode *node = NULL;
    while (number < map->node_count && (number == 0 || photons > 2.0f * k)) {
        float distance2[4];
        node = &map->nodes[number];
        node_distances(node, search->point, distance2);
        size_t left = distance2[0] < distance2[1] ? 0 : 1;
        size_t right = distance2[2] < distance2[3] ? 2 : 3;
        nearest = distance2[left] < distance2[right] ? left : right;
        number = child_number(map, number, nearest);
        photons *= 0.25f;
    }
    return node ? guess_from_box(node, nearest, photons, k) : INFINITY;
}

size_t photon_map_nearest(const PhotonMap *map, Vec3 point, size_t k, float *radius2, NearPhoton *near)
{
    if (k == 0 || map->count == 0)
        return 0;
    Search search = {.map = map, .point = point, .k = k, .near = near};
    search.limit = fminf(*radius2, guess_limit(&search));
    float limit = search.limit;
    search_tree(&search);
    // Too few: the guess was too small. The second step is to the caller's own limit.
    for (float growth = 4.0f; search.found < k && limit < *radius2; growth = INFINITY) {
        search.limit = limit = fminf(*radius2, limit * growth);
        search_tree(&search);
    }
    if (search.found < k)
        return search.found;
    *radius2 = keep_nearest(near, search.found, k);
    return k;
}
