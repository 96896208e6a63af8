// Building a binary tree by the surface-area heuristic; bvh_collapse.c makes it wide.
//
// The heuristic (Goldsmith & Salmon 1987; MacDonald & Booth 1990): a ray that meets a box meets a smaller box
// within it with the ratio of their surface areas as probability, so that the best split is the one with the
// least area × packets, summed over both halves. Candidates are the borders between bins of centroids (Wald
// 2007).
#include "scene/bvh/bvh_internal.h"

#include <stdlib.h>

#define BINS        16
#define DEPTH_LIMIT 60 // below this depth ranges are halved by number, which adds 32 levels at most

typedef struct {
    Float4 low, high; // lane 3 is not used
} Box4;

typedef struct {
    Box4 box;
    uint32_t count;
} Bin;

// What is left to build: a range of references, and the box of their centroids, times two (low + high, not halved).
typedef struct {
    uint32_t first, count;
    Box4 box, centroids;
    int depth;
} Range;

// Where to part a range: references whose bin on the axis is at most `bin` go left.
typedef struct {
    int axis, bin;
    float cost;                     // INFINITY: no bin separates anything
    Float4 origin, scale, last_bin; // bin = (centroid − origin)·scale
} Cut;

typedef struct {
    Reference *references;
    Split *splits;
} Builder;

static inline Box4 box4_empty(void)
{
    return (Box4){float4_all(INFINITY), float4_all(-INFINITY)};
}

static inline void box4_add(Box4 *box, Float4 low, Float4 high)
{
    box->low = float4_min(low, box->low);
    box->high = float4_max(high, box->high);
}

static inline float box4_half_area(const Box4 *box)
{
    Float4 d = box->high - box->low;
    return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
}

static inline Int4 bins_of(const Reference *reference, const Cut *cut)
{
    Float4 place = (reference->low + reference->high - cut->origin) * cut->scale;
    return __builtin_convertvector(float4_min(place, cut->last_bin), Int4);
}

static Cut cut_prepare(const Range *range, int bins)
{
    Cut cut = {.cost = INFINITY, .origin = range->centroids.low, .last_bin = float4_all((float)(bins - 1))};
    for (int axis = 0; axis < 3; axis++) {
        float extent = range->centroids.high[axis] - range->centroids.low[axis];
        float scale = (float)bins / extent;
        cut.scale[axis] = extent > 0.0f && scale < INFINITY ? scale : 0.0f;
    }
    cut.origin[3] = 0.0f;
    cut.scale[3] = 0.0f;
    return cut;
}

// Sweeps over the bins of one axis, from the right and then from the left, and keeps the cheapest border in
// *best.
static void cut_sweep(const Bin *bin, int bins, int axis, Cut *best)
{
    float right_cost[BINS];
    Box4 box = box4_empty();
    uint32_t count = 0;
    for (int i = bins - 1; i > 0; i--) {
        box4_add(&box, bin[i].box.low, bin[i].box.high);
        count += bin[i].count;
        right_cost[i] = count ? box4_half_area(&box) * (float)packets_of(count) : INFINITY;
    }
    box = box4_empty();
    count = 0;
    for (int i = 0; i + 1 < bins; i++) {
        box4_add(&box, bin[i].box.low, bin[i].box.high);
        count += bin[i].count;
        if (!count)
            continue;
        float cost = box4_half_area(&box) * (float)packets_of(count) + right_cost[i + 1];
        if (cost < best->cost) {
            best->cost = cost;
            best->axis = axis;
            best->bin = i;
        }
    }
}

static Cut cut_find(const Reference *references, const Range *range)
{
    int bins = range->count / 16 + 4 < BINS ? (int)(range->count / 16 + 4) : BINS;
    Cut cut = cut_prepare(range, bins);
    Bin bin[3][BINS];
    for (int axis = 0; axis < 3; axis++)
        for (int i = 0; i < bins; i++)
            bin[axis][i] = (Bin){box4_empty(), 0};
    for (uint32_t i = range->first; i < range->first + range->count; i++) {
        Int4 place = bins_of(&references[i], &cut);
        for (int axis = 0; axis < 3; axis++) {
            Bin *b = &bin[axis][place[axis]];
            box4_add(&b->box, references[i].low, references[i].high);
            b->count++;
        }
    }
    for (int axis = 0; axis < 3; axis++)
        if (cut.scale[axis] > 0.0f)
            cut_sweep(bin[axis], bins, axis, &cut);
    return cut;
}

static inline void range_add(Range *range, const Reference *reference)
{
    Float4 centroid = reference->low + reference->high;
    box4_add(&range->box, reference->low, reference->high);
    box4_add(&range->centroids, centroid, centroid);
    range->count++;
}

// Reorders the range so that the references left of the cut come first.
static void partition(Reference *references, const Range *range, const Cut *cut, Range *left, Range *right)
{
    uint32_t i = range->first;
    uint32_t end = range->first + range->count;
    while (i < end) {
        if (bins_of(&references[i], cut)[cut->axis] <= cut->bin) {
            range_add(left, &references[i++]);
        } else {
            Reference other = references[--end];
            range_add(right, &references[i]);
            references[end] = references[i];
            references[i] = other;
        }
    }
    right->first = i;
}

// Where no cut separates anything (all centroids coincide), or the tree grows too deep.
static void halve(const Reference *references, const Range *range, Range *left, Range *right)
{
    right->first = range->first + range->count / 2;
    for (uint32_t i = range->first; i < range->first + range->count; i++)
        range_add(i < right->first ? left : right, &references[i]);
}

static void build_range(const Builder *builder, Range range, uint32_t node)
{
    Split *split = &builder->splits[node];
    *split = (Split){.low = {range.box.low[0], range.box.low[1], range.box.low[2]},
                     .first = range.first,
                     .high = {range.box.high[0], range.box.high[1], range.box.high[2]},
                     .count = range.count,
                     .packets = packets_of(range.count)};
    bool is_small_scene = range.depth == 0 && range.count <= SMALL_SCENE;
    if (range.count <= PACKET || is_small_scene)
        return;
    Cut cut = cut_find(builder->references, &range);
    Range left = {.first = range.first, .box = box4_empty(), .centroids = box4_empty(), .depth = range.depth + 1};
    Range right = left;
    if (range.depth < DEPTH_LIMIT && cut.cost < INFINITY)
        partition(builder->references, &range, &cut, &left, &right);
    else
        halve(builder->references, &range, &left, &right);
    split->count = INNER;
    split->first = node + 2 * left.count;
    OMP(omp task default(shared) firstprivate(left) if (left.count > TASK_COUNT))
    build_range(builder, left, node + 1);
    build_range(builder, right, split->first);
    OMP(omp taskwait)
    bvh_plan(builder->splits, node);
}

bool bvh_build_tree(const Shapes *shapes, Reference *references, Tree *tree)
{
    if (shapes->count == 0)
        return true;
    Builder builder = {references, array_allocate(2 * shapes->count * sizeof *builder.splits)};
    if (!builder.splits)
        return false;
    Range all = {.box = box4_empty(), .centroids = box4_empty()};
    for (size_t i = 0; i < shapes->count; i++)
        range_add(&all, &references[i]);
    OMP(omp parallel if (shapes->count > TASK_COUNT))
    OMP(omp single)
    build_range(&builder, all, 0);
    bool done = bvh_collapse(shapes, references, builder.splits, tree);
    free(builder.splits);
    return done;
}
