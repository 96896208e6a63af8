// Halving a range of photons at the median: find the median's value first, on copies of the one coordinate
// that counts, so that the photons themselves are moved once only.
#include "photons/photon_map_internal.h"

enum {
    SAMPLE_FROM = 512, // ranges longer than this have their median narrowed down by a sample
    SAMPLES = 128,
    SAMPLE_MARGIN = 17
};

static int longest_axis(Box box)
{
    Vec3 size = vec3_sub(box.high, box.low);
    if (size.x >= size.y && size.x >= size.z)
        return 0;
    return size.y >= size.z ? 1 : 2;
}

// One coordinate of a photon, without a branch on the axis.
static inline float coordinate(const StoredPhoton *photon, int axis)
{
    return (&photon->position.x)[axis];
}

static void sort_small(float *values, size_t count)
{
    for (size_t i = 1; i < count; i++) {
        float value = values[i];
        size_t at = i;
        for (; at > 0 && value < values[at - 1]; at--)
            values[at] = values[at - 1];
        values[at] = value;
    }
}

// Brings the values below `pivot` to the front; returns how many they are. Without a branch on the data,
// since nobody can predict which side a value of the middle falls on.
static size_t split_values(float *values, size_t count, float pivot)
{
    size_t below = 0;
    for (size_t i = 0; i < count; i++) {
        float value = values[i];
        values[i] = values[below];
        values[below] = value;
        below += value < pivot;
    }
    return below;
}

static float middle_of_three(float a, float b, float c)
{
    float low = a < b ? a : b;
    float high = a < b ? b : a;
    return c < low ? low : c > high ? high : c;
}

// The value that stands at `rank` (from 0) when all are sorted. Quickselect (Hoare 1961).
static float select_value(float *values, size_t count, size_t rank)
{
    while (count > 12) {
        float pivot = middle_of_three(values[0], values[count / 2], values[count - 1]);
        size_t below = split_values(values, count, pivot);
        if (rank < below) {
            count = below;
            continue;
        }
        // Those equal to the pivot go aside, too, so that every round gets shorter even if all are equal.
        values += below;
        count -= below;
        rank -= below;
        size_t equal = split_values(values, count, nextafterf(pivot, INFINITY));
        if (rank < equal)
            return pivot;
        values += equal;
        count -= equal;
        rank -= equal;
    }
    sort_small(values, count);
    return values[rank];
}

// The coordinate at `rank`. One pass copies out those between two values that the median very likely lies between, and
// counts those below. Of many photons the two are quantiles of a sample, three standard deviations either side of its
// middle; of few, three standard deviations around the middle, as if they were spread evenly.
static float select_coordinate(const StoredPhoton *photons, size_t count, Box box, int axis, size_t rank, float *values)
{
    float low = vec3_component(box.low, axis), high = vec3_component(box.high, axis);
    float middle = 0.5f * (low + high), margin = 1.5f * (high - low) / sqrtf((float)count);
    low = middle - margin;
    high = middle + margin;
    if (count > SAMPLE_FROM) {
        float sample[SAMPLES];
        for (size_t i = 0; i < SAMPLES; i++)
            sample[i] = coordinate(&photons[count * (2 * i + 1) / (2 * SAMPLES)], axis);
        sort_small(sample, SAMPLES);
        low = sample[SAMPLES / 2 - SAMPLE_MARGIN];
        high = sample[SAMPLES / 2 + SAMPLE_MARGIN];
    }
    for (;;) {
        size_t below = 0;
        size_t inside = 0;
        for (size_t i = 0; i < count; i++) {
            float value = coordinate(&photons[i], axis);
            values[inside] = value;
            below += value < low;
            inside += (value >= low) & (value <= high);
        }
        if (below <= rank && rank < below + inside)
            return select_value(values, inside, rank - below);
        low = -INFINITY; // bad luck, or not spread evenly
        high = INFINITY;
    }
}

// Brings the photons whose coordinate is below `pivot` to the front; returns how many they are.
static size_t split_photons(StoredPhoton *photons, size_t count, int axis, float pivot)
{
    size_t below = 0;
    for (size_t i = 0; i < count; i++) {
        bool is_below = coordinate(&photons[i], axis) < pivot;
        swap_bytes(&photons[i], &photons[below], sizeof *photons);
        below += is_below;
    }
    return below;
}

void photon_map_halve(StoredPhoton *photons, size_t count, Box box, size_t rank, float *values)
{
    int axis = longest_axis(box);
    float median = select_coordinate(photons, count, box, axis, rank, values);
    size_t below = split_photons(photons, count, axis, median);
    if (below < rank) // several at the median: bring them together in the middle
        split_photons(photons + below, count - below, axis, nextafterf(median, INFINITY));
}
