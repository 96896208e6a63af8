// The photon map against brute force: every answer must be the one a plain loop over all photons gives.
#include "unit/photons/photon_map_helpers.h"

enum { MOST = 100000 }; // photons

// Near the photons, far away from them, or on one of them.
static Vec3 make_query(const PhotonMap *map, Arrangement arrangement, int which, Rng *rng)
{
    if (which == 0 && photon_map_count(map) > 0)
        return photon_map_photons(map)[rng_u32(rng) % photon_map_count(map)].position;
    if (which == 1)
        return vec3(300.0f, -7.0f, 2.0f);
    return place(which % 2 ? arrangement : CUBE, rng);
}

static float distance2_to(const StoredPhoton *photon, Vec3 point)
{
    Vec3 d = vec3_sub(photon->position, point);
    return vec3_dot(d, d);
}

static int compare_floats(const void *a, const void *b)
{
    float left = *(const float *)a;
    float right = *(const float *)b;
    return left < right ? -1 : left > right;
}

static int compare_near(const void *a, const void *b)
{
    const StoredPhoton *left = ((const NearPhoton *)a)->photon;
    const StoredPhoton *right = ((const NearPhoton *)b)->photon;
    return left < right ? -1 : left > right;
}

static void assert_distinct(NearPhoton *near, size_t count)
{
    qsort(near, count, sizeof *near, compare_near);
    for (size_t i = 1; i < count; i++)
        assert_ptr_not_equal(near[i - 1].photon, near[i].photon);
}

// All squared distances, ascending; good until the next call.
static const float *sorted_distances(const PhotonMap *map, Vec3 point)
{
    static float sorted[MOST + 1];
    size_t count = photon_map_count(map);
    assert_true(count <= MOST);
    for (size_t i = 0; i < count; i++)
        sorted[i] = distance2_to(&photon_map_photons(map)[i], point);
    qsort(sorted, count, sizeof *sorted, compare_floats);
    return sorted;
}

static size_t count_below(const float *sorted, size_t count, float limit)
{
    size_t below = 0;
    while (below < count && sorted[below] < limit)
        below++;
    return below;
}

static void check_nearest(const PhotonMap *map, Vec3 point, size_t k, float limit, const float *sorted)
{
    size_t room = PHOTON_MAP_NEAREST_CAPACITY(k);
    NearPhoton *near = malloc(room * sizeof *near); // exactly that much: AddressSanitizer watches
    assert_non_null(near);
    size_t in_reach = count_below(sorted, photon_map_count(map), limit);
    size_t expected = in_reach < k ? in_reach : k;
    float radius2 = limit;
    assert_int_equal(photon_map_nearest(map, point, k, &radius2, near), expected);
    assert_true(radius2 == (expected == k ? sorted[k - 1] : limit));
    static float found[MOST];
    for (size_t i = 0; i < expected; i++) {
        size_t index = (size_t)(near[i].photon - photon_map_photons(map));
        assert_true(index < photon_map_count(map));
        assert_true(near[i].distance2 == distance2_to(near[i].photon, point));
        found[i] = near[i].distance2;
    }
    qsort(found, expected, sizeof *found, compare_floats);
    assert_memory_equal(found, sorted, expected * sizeof *found);
    assert_distinct(near, expected);
    free(near);
}

static void check_query(const PhotonMap *map, Vec3 point, const size_t *ks, size_t k_count)
{
    size_t count = photon_map_count(map);
    const float *sorted = sorted_distances(map, point);
    for (size_t i = 0; i < k_count; i++) {
        check_nearest(map, point, ks[i], INFINITY, sorted);
        if (count == 0)
            continue;
        check_nearest(map, point, ks[i], sorted[count / 2], sorted); // a limit that a photon lies exactly on
        check_nearest(map, point, ks[i], sorted[count / 3] * 1.01f, sorted);
        check_nearest(map, point, ks[i], 0.0f, sorted);
    }
}

// A widely copied traversal never visits the last three or four photons, which shows for few photons.
TEST(test_nearest_of_few)
{
    for (int arrangement = 0; arrangement < ARRANGEMENTS; arrangement++)
        for (size_t count = 0; count <= 64; count++) {
            PhotonMap *map = make_map((Arrangement)arrangement, count, 1 + count);
            size_t ks[67];
            for (size_t k = 1; k <= count + 2; k++)
                ks[k - 1] = k;
            Rng rng = rng_create(2, count);
            for (int which = 0; which < 4; which++)
                check_query(map, make_query(map, (Arrangement)arrangement, which, &rng), ks, count + 2);
        }
}

static void nearest_of_many(size_t count, int queries)
{
    static const size_t ks[] = {1, 2, 7, 50, 400, 999, 1000, 1001};
    for (int arrangement = 0; arrangement < ARRANGEMENTS; arrangement++) {
        PhotonMap *map = make_map((Arrangement)arrangement, count, 3);
        Rng rng = rng_create(4, count);
        for (int which = 0; which < queries; which++)
            check_query(map, make_query(map, (Arrangement)arrangement, which, &rng), ks, sizeof ks / sizeof *ks);
    }
}

TEST(test_nearest_of_1000)
{
    nearest_of_many(1000, 30);
}

TEST(test_nearest_of_100000)
{
    nearest_of_many(MOST, 6);
}

TEST(test_no_photons_wanted)
{
    PhotonMap *map = make_map(CUBE, 100, 5);
    NearPhoton near[PHOTON_MAP_NEAREST_CAPACITY(0)];
    float radius2 = 3.0f;
    assert_int_equal(photon_map_nearest(map, vec3(0.0f, 0.0f, 0.0f), 0, &radius2, near), 0);
    assert_true(radius2 == 3.0f);
}

// The header's example, word for word.
TEST(test_example_of_the_header)
{
    const size_t count = 20000;
    StoredPhoton *photons = make_photons(CUBE, count, 8);
    Vec3 point = vec3(0.1f, 0.2f, -0.3f);

    PhotonMap *map = own_map(photon_map_build(photons, count, &said)); // takes the array over and reorders it
    NearPhoton near[PHOTON_MAP_NEAREST_CAPACITY(50)];
    float radius2 = 0.1f * 0.1f;
    size_t found = photon_map_nearest(map, point, 50, &radius2, near);

    // 20000 photons on 8 m³ are 10 within 0.1 m, on average.
    const float *sorted = sorted_distances(map, point);
    assert_true(found > 0 && found < 50);
    assert_int_equal(found, count_below(sorted, count, 0.1f * 0.1f));
    assert_true(radius2 == 0.1f * 0.1f);
    radius2 = 1.0f;
    assert_int_equal(photon_map_nearest(map, point, 50, &radius2, near), 50);
    assert_true(radius2 == sorted[49]);
}
