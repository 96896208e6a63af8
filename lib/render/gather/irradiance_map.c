// Estimates are averaged in the cells of a grid, apart by the way their surface faces, and found by hashing: the nearest
// one is not worth a search in a tree, since hundreds of them are summed.
#include "render/gather/irradiance_map.h"

#include "steps/steps.h"

#include <stdlib.h>

#define ESTIMATES_A_CELL 4.0f // on a flat surface, on average
#define FACINGS          6    // along ±x, ±y, ±z, whichever is nearest

typedef struct {
    LocalIrradiance mean; // while the map is built: the sum
    float weight;         // of the estimates in it
} Cell;

// Keys apart from what they lead to: a gather ray ends anywhere, and keys alone fit a processor's cache.
struct IrradianceMap {
    uint64_t *keys; // hashes of cell and facing; 0: the slot is empty
    Cell *cells;
    size_t mask; // slots − 1, a power of two less one
    float size;  // of a cell, m
};

typedef struct {
    Vec3 normal;
    LocalIrradiance local; // radius 0: there is none
} Site;

static int facing_of(Vec3 normal)
{
    float x = fabsf(normal.x), y = fabsf(normal.y), z = fabsf(normal.z);
    if (x >= y && x >= z)
        return normal.x < 0.0f ? 0 : 1;
    if (y >= z)
        return normal.y < 0.0f ? 2 : 3;
    return normal.z < 0.0f ? 4 : 5;
}

typedef struct {
    int32_t x, y, z;
} Place;

// Farther out than an int counts, neighbours as well, any cell will do.
static int32_t cell_of(float x)
{
    float cell = floorf(x);
    return fabsf(cell) < 1e9f ? (int32_t)cell : 0;
}

static Place place_of(const IrradianceMap *map, Vec3 p)
{
    float scale = 1.0f / map->size;
    return (Place){cell_of(p.x * scale), cell_of(p.y * scale), cell_of(p.z * scale)};
}

// 64 bits of hash stand for the cell: that two share one does not happen.
static uint64_t key_of(Place place, int facing)
{
    uint64_t hash = hash_u64((uint64_t)(uint32_t)place.x << 32 | (uint32_t)place.y);
    return hash_u64(hash ^ ((uint64_t)(uint32_t)place.z << 3 | (uint64_t)facing)) | 1u;
}

// The slot of this key, or the empty one where it would go.
static size_t slot_of(const IrradianceMap *map, uint64_t key)
{
    size_t slot = key >> 20 & map->mask;
    while (map->keys[slot] && map->keys[slot] != key)
        slot = (slot + 1) & map->mask;
    return slot;
}

// The same for who fills it.
static Cell *claim_cell(IrradianceMap *map, Place place, int facing)
{
    uint64_t key = key_of(place, facing);
    size_t slot = slot_of(map, key);
    map->keys[slot] = key;
    return &map->cells[slot];
}

// A photon does not know its surface: a short ray back the way it came finds it.
static bool find_surface(const Scene *scene, const StoredPhoton *photon, float step, Hit *hit)
{
    Vec3 wi = stored_photon_wi(photon);
    Ray ray = {vec3_along(photon->position, wi, step), vec3_negate(wi), NO_PRIMITIVE};
    return scene_intersect(scene, &ray, hit) && fabsf(hit->distance - step) < 0.5f * step &&
           hit->material == &scene->materials[photon->material];
}

static Site estimate_site(const Scene *scene, const PhotonMap *photons, const StoredPhoton *photon, float step,
                          Gather *gather)
{
    static const Material white = {.name = "white", .type = MATERIAL_DIFFUSE, .diffuse = {1.0f, 1.0f, 1.0f}};
    Hit hit;
    if (!find_surface(scene, photon, step, &hit))
        return (Site){.local = {.radius = 0.0f}};
    hit.material = &white;
    gather->reach = 0.0f;
    Colour radiance = steps.estimate_radiance(photons, &hit, hit.normal, gather);
    return (Site){hit.normal, {colour_scale(radiance, PI), gather->reach}};
}

static bool estimate_sites(const Scene *scene, const PhotonMap *photons, const StoredPhoton *places, size_t k,
                           Site *sites, size_t count)
{
    float step = 1e-4f * box_diagonal(bvh_bounds(scene->bvh));
    bool ok = true;
#pragma omp parallel reduction(&& : ok)
    {
        Gather gather = {.k = k, .radius = INFINITY, .near = malloc(PHOTON_MAP_NEAREST_ROOM(k) * sizeof(NearPhoton))};
        ok = gather.near != NULL;
#pragma omp for schedule(dynamic, 256)
        for (size_t i = 0; i < count; i++)
            if (gather.near)
                sites[i] = estimate_site(scene, photons, &places[i], step, &gather);
        free(gather.near);
    }
    return ok;
}

// Cells in which about so many estimates lie on a flat piece of surface.
static float cell_size(const Site *sites, size_t count, size_t photons, size_t k)
{
    double radius2 = 0.0;
    size_t valid = 0;
    for (size_t i = 0; i < count; i++) {
        radius2 += (double)sites[i].local.radius * (double)sites[i].local.radius;
        valid += sites[i].local.radius > 0.0f;
    }
    if (valid == 0)
        return 1.0f; // of none
    double area_a_photon = (double)PI * radius2 / (double)valid / (double)k;
    return (float)sqrt(area_a_photon * (double)photons / (double)count * (double)ESTIMATES_A_CELL);
}

static void add_weighted(Cell *sum, LocalIrradiance local, float weight)
{
    sum->mean.irradiance = colour_add(sum->mean.irradiance, colour_scale(local.irradiance, weight));
    sum->mean.radius += local.radius * weight;
    sum->weight += weight;
}

static LocalIrradiance mean_of(const Cell *sum)
{
    float share = 1.0f / sum->weight;
    return (LocalIrradiance){colour_scale(sum->mean.irradiance, share), sum->mean.radius * share};
}

// A mean over the area of the cell, not over the photons in it, most of which lie where it is bright: weighed by the disk
// that each of them stands for.
static void add_site(IrradianceMap *map, Vec3 position, const Site *site)
{
    Cell *cell = claim_cell(map, place_of(map, position), facing_of(site->normal));
    add_weighted(cell, site->local, site->local.radius * site->local.radius);
}

static IrradianceMap *map_create(size_t slots, float size)
{
    IrradianceMap *map = calloc(1, sizeof *map);
    if (!map)
        return NULL;
    *map = (IrradianceMap){calloc(slots, sizeof *map->keys), calloc(slots, sizeof *map->cells), slots - 1, size};
    if (map->keys && map->cells)
        return map;
    irradiance_map_free(map);
    return NULL;
}

IrradianceMap *irradiance_map_build(const Scene *scene, const PhotonMap *photons, const StoredPhoton *places,
                                    size_t count, size_t k, Error *error)
{
    size_t slots = 64;
    while (slots <= count)
        slots *= 2;
    Site *sites = calloc(count + 1, sizeof *sites);
    bool ok = sites && estimate_sites(scene, photons, places, k, sites, count);
    IrradianceMap *map = ok ? map_create(slots, cell_size(sites, count, photon_map_count(photons), k)) : NULL;
    for (size_t i = 0; map && i < count; i++)
        if (sites[i].local.radius > 0.0f)
            add_site(map, places[i].position, &sites[i]);
    for (size_t slot = 0; map && slot < slots; slot++)
        if (map->cells[slot].weight)
            map->cells[slot].mean = mean_of(&map->cells[slot]);
    free(sites);
    if (!map)
        error_set(error, "not enough memory for the irradiance of %zu photons", count);
    return map;
}

// A cell for each facing, and no end to it.
IrradianceMap *irradiance_map_uniform(Colour irradiance)
{
    IrradianceMap *map = map_create(64, INFINITY);
    for (int facing = 0; map && facing < FACINGS; facing++)
        claim_cell(map, (Place){0, 0, 0}, facing)->mean.irradiance = irradiance;
    return map;
}

void irradiance_map_free(IrradianceMap *map)
{
    if (!map)
        return;
    free(map->keys);
    free(map->cells);
    free(map);
}

size_t irradiance_map_bytes(const IrradianceMap *map)
{
    return (map->mask + 1) * (sizeof *map->keys + sizeof *map->cells);
}

// Where a cell is empty: the mean over its neighbours.
static bool find_around(const IrradianceMap *map, Place place, int facing, LocalIrradiance *found)
{
    Cell sum = {.weight = 0.0f};
    for (int i = 0; i < 27; i++) {
        Place next = {place.x + i % 3 - 1, place.y + i / 3 % 3 - 1, place.z + i / 9 - 1};
        const Cell *cell = &map->cells[slot_of(map, key_of(next, facing))];
        add_weighted(&sum, cell->mean, cell->weight); // 0 in an empty slot
    }
    if (sum.weight > 0.0f)
        *found = mean_of(&sum);
    return sum.weight > 0.0f;
}

bool irradiance_map_find(const IrradianceMap *map, Vec3 position, Vec3 normal, LocalIrradiance *found)
{
    Place place = place_of(map, position);
    int facing = facing_of(normal);
    size_t slot = slot_of(map, key_of(place, facing));
    if (!map->keys[slot])
        return find_around(map, place, facing, found);
    *found = map->cells[slot].mean;
    return true;
}
