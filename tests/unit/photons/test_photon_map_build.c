// Building the photon map: nothing lost, the same order always, bad positions refused, memory bounded.
#include "unit/photons/photon_map_helpers.h"

#ifdef _OPENMP
#include <omp.h>
#endif

TEST(test_keeps_every_photon)
{
    enum { COUNT = 30000 };
    for (int arrangement = 0; arrangement < ARRANGEMENTS; arrangement++) {
        StoredPhoton *before = make_photons((Arrangement)arrangement, COUNT, 8);
        PhotonMap *map = make_map((Arrangement)arrangement, COUNT, 8);
        unsigned char *seen = memory(COUNT, 1);
        assert_int_equal(photon_map_count(map), COUNT);
        for (size_t i = 0; i < COUNT; i++) {
            const StoredPhoton *photon = &photon_map_photons(map)[i];
            size_t number = (size_t)photon->power.r;
            assert_memory_equal(photon, &before[number], sizeof *photon);
            assert_int_equal(seen[number]++, 0);
        }
        free(before);
    }
}

TEST(test_same_order_for_any_threads)
{
    enum { COUNT = 100000 };
    for (int arrangement = 0; arrangement < ARRANGEMENTS; arrangement++) {
        PhotonMap *maps[3];
        for (int i = 0; i < 3; i++) {
#ifdef _OPENMP
            static const int threads[] = {1, 2, 7};
            omp_set_num_threads(threads[i]);
#endif
            maps[i] = make_map((Arrangement)arrangement, COUNT, 9);
        }
        for (int i = 1; i < 3; i++)
            assert_memory_equal(photon_map_photons(maps[0]), photon_map_photons(maps[i]), COUNT * sizeof(StoredPhoton));
    }
}

// FNV-1a (Fowler, Noll, Vo) over the photons' numbers in the tree's order and in the order of an answer.
static uint64_t hash_number(uint64_t hash, const StoredPhoton *photon)
{
    return (hash ^ (uint64_t)photon->power.r) * 0x100000001b3u;
}

// The same order from every compiler and on every system, ties and all: the figure here is for all of them.
// It changes when the building or searching does, and with it the images (in their last bits).
TEST(test_same_order_everywhere)
{
    uint64_t hash = 0xcbf29ce484222325u;
    for (int arrangement = 0; arrangement < ARRANGEMENTS; arrangement++) {
        PhotonMap *map = make_map((Arrangement)arrangement, 5000, 10);
        for (size_t i = 0; i < photon_map_count(map); i++)
            hash = hash_number(hash, &photon_map_photons(map)[i]);
        NearPhoton near[PHOTON_MAP_NEAREST_CAPACITY(50)];
        float radius2 = INFINITY;
        size_t found = photon_map_nearest(map, vec3(0.1f, 0.2f, 0.3f), 50, &radius2, near);
        for (size_t i = 0; i < found; i++)
            hash = hash_number(hash, near[i].photon);
    }
    assert_true(hash == 0xf93a34b35583421bu);
}

TEST(test_refuses_bad_positions)
{
    static const float bad[] = {NAN, INFINITY, -INFINITY, 1e19f};
    for (int i = 0; i < 12; i++) {
        StoredPhoton *photons = make_photons(CUBE, 100, 11);
        (&photons[42].position.x)[i % 3] = bad[i / 3];
        assert_null(photon_map_build(photons, 100, &said));
        assert_non_null(strstr(said.message, "photon 42 "));
        assert_said("finite");
    }
}

TEST(test_memory)
{
    static const size_t counts[] = {32, 33, 64, 65, 128, 129, 256, 257, 512, 513, 1025, 4097, 16385, 100000};
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) {
        PhotonMap *map = make_map(CUBE, counts[i], 12);
        assert_true(photon_map_bytes(map) > 32 * counts[i]);
        assert_true(photon_map_bytes(map) <= 40 * counts[i]);
    }
    photon_map_free(NULL);
}
