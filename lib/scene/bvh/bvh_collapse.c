// From the binary tree to nodes of eight children, chosen so that rays meet as few nodes as they can: those whose areas have
// the least sum (by dynamic programming, as Ylitie, Karras & Laine 2017). The nodes are laid out in the order in which a ray that
// always takes the first child meets them, so that near relatives lie in near memory.
#include "scene/bvh/bvh_internal.h"

#include <stdlib.h>

// cost[s − 1]: the least area of all nodes that the subtree needs where it may take s of its parent's places.
typedef struct {
    float cost[WIDTH - 1];
} Plan;

typedef struct {
    const Split *splits;
    Plan *plans; // one for each split
    Tree *tree;
    Run *runs;
    uint32_t leaf_count;
} Collapse;

static float half_area(const Split *split)
{
    float d[3] = {split->high[0] - split->low[0], split->high[1] - split->low[1], split->high[2] - split->low[2]};
    return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
}

// How many of `places` the left child gets where both children together cost least; *cost is what they cost then.
static int share_places(const Collapse *collapse, uint32_t node, int places, float *cost)
{
    const float *left = collapse->plans[node + 1].cost, *right = collapse->plans[collapse->splits[node].first].cost;
    int best = 1;
    for (int i = 1; i < places; i++)
        if (left[i - 1] + right[places - i - 1] < left[best - 1] + right[places - best - 1])
            best = i;
    *cost = left[best - 1] + right[places - best - 1];
    return best;
}

static void make_plan(Collapse *collapse, uint32_t node)
{
    const Split *split = &collapse->splits[node];
    Plan *plan = &collapse->plans[node];
    if (split->count != INNER) {
        collapse->leaf_count++;
        collapse->tree->packet_count += packets_of(split->count);
        *plan = (Plan){{0}};
        return;
    }
    make_plan(collapse, node + 1);
    make_plan(collapse, split->first);
    share_places(collapse, node, WIDTH, &plan->cost[0]);
    plan->cost[0] += half_area(split);
    for (int i = 1; i < WIDTH - 1; i++) {
        share_places(collapse, node, i + 1, &plan->cost[i]);
        plan->cost[i] = fminf(plan->cost[i], plan->cost[i - 1]);
    }
}

static uint32_t emit_leaf(Collapse *collapse, const Split *split)
{
    uint32_t packets = packets_of(split->count);
    uint32_t first = collapse->tree->packet_count;
    for (uint32_t i = 0; i < packets; i++) {
        uint32_t taken = i * PACKET;
        uint32_t rest = split->count - taken;
        collapse->runs[first + i] = (Run){split->first + taken, rest < PACKET ? rest : PACKET};
    }
    collapse->tree->packet_count += packets;
    return LEAF | (packets - 1) << 28 | first;
}

// The children that the subtree contributes to its parent, in at most `places`, as planned.
static int choose(const Collapse *collapse, uint32_t node, int places, uint32_t *children)
{
    const float *cost = collapse->plans[node].cost;
    if (places < WIDTH && cost[places - 1] == cost[0]) {
        children[0] = node;
        return 1;
    }
    float unused;
    int left = share_places(collapse, node, places, &unused);
    int count = choose(collapse, node + 1, left, children);
    return count + choose(collapse, collapse->splits[node].first, places - left, children + count);
}

static uint32_t emit(Collapse *collapse, uint32_t node)
{
    const Split *splits = collapse->splits;
    if (splits[node].count != INNER)
        return emit_leaf(collapse, &splits[node]);
    uint32_t children[WIDTH];
    int count = choose(collapse, node, WIDTH, children);
    uint32_t index = collapse->tree->node_count++;
    Node *wide = &collapse->tree->nodes[index];
    for (int i = 0; i < WIDTH; i++) {
        const Split *child = i < count ? &splits[children[i]] : NULL;
        for (int axis = 0; axis < 3; axis++) {
            wide->bounds[axis][i] = child ? child->low[axis] : INFINITY;
            wide->bounds[axis + 3][i] = child ? child->high[axis] : -INFINITY;
        }
    }
    for (int i = 0; i < WIDTH; i++)
        wide->child[i] = i < count ? emit(collapse, children[i]) : NO_CHILD;
    return index;
}

bool bvh_collapse(const Split *splits, size_t count, Tree *tree, Run **runs)
{
    Collapse collapse = {splits, bvh_allocate(count * sizeof(Plan)), tree, NULL, 0};
    if (!collapse.plans)
        return false;
    make_plan(&collapse, 0);
    tree->nodes = bvh_allocate(collapse.leaf_count * sizeof(Node)); // each has two children at least
    *runs = collapse.runs = malloc(tree->packet_count * sizeof **runs);
    tree->packet_count = 0;
    if (*runs && tree->nodes)
        tree->root = emit(&collapse, 0);
    free(collapse.plans);
    return tree->root != NO_CHILD;
}
