// From the binary tree to nodes of eight children, chosen so that rays meet as few nodes as they can: the sum of all nodes' areas
// is the least that there is (by dynamic programming, as in Ylitie, Karras & Laine 2017). A node's children lie side by side, and
// what is below the first of them before what is below the second, so that near relatives lie in near memory.
#include "scene/bvh/bvh_internal.h"

#include <float.h>

#define STEP_SLACK 0x1p-10f // a child's box is so many steps larger than need be: the traversal rounds

typedef struct {
    const Shapes *shapes;
    const Reference *references;
    const Split *splits;
    Tree *tree;
} Collapse;

// How many of `places` the left child gets where both children together cost least; *cost is what they cost then.
static int share_places(const Split *splits, uint32_t node, int places, float *cost)
{
    const float *left = splits[node + 1].cost, *right = splits[splits[node].first].cost;
    int best = 0;
    *cost = INFINITY;
    for (int i = 1; i < places; i++) {
        float sum = left[i - 1] + right[places - i - 1];
        if (sum < *cost) {
            *cost = sum;
            best = i;
        }
    }
    return best;
}

void bvh_plan(Split *splits, uint32_t node)
{
    Split *split = &splits[node];
    split->packets = splits[node + 1].packets + splits[split->first].packets;
    float d[3], below;
    for (int axis = 0; axis < 3; axis++)
        d[axis] = split->high[axis] - split->low[axis];
    share_places(splits, node, WIDTH, &below);
    float own = below + d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
    for (int places = 1; places < WIDTH; places++) {
        share_places(splits, node, places, &below);
        split->cost[places - 1] = below < own ? below : own;
    }
}

typedef struct {
    uint32_t nodes[WIDTH], leaves[WIDTH]; // in the binary tree
    uint32_t node_count, leaf_count;
} Children;

// Adds what the subtree contributes to its parent, in at most `places`, as planned.
static void choose(const Split *splits, uint32_t node, int places, Children *children)
{
    const Split *split = &splits[node];
    if (split->count != INNER) {
        children->leaves[children->leaf_count++] = node;
    } else if (places < WIDTH && split->cost[places - 1] == split->cost[0]) {
        children->nodes[children->node_count++] = node;
    } else {
        float cost;
        int left = share_places(splits, node, places, &cost);
        choose(splits, node + 1, left, children);
        choose(splits, split->first, places - left, children);
    }
}

// A little lower than `low`, with the exponent of the shortest step of which 254 reach `high`: rounding takes one more.
static float frame(float low, float high)
{
    float margin = fabsf(low) * 0x1p-13f;
    uint32_t exponent = (float_bits((high - low + 2.0f * margin) / 254.0f + FLT_MIN) + 0x7fffff) >> 23;
    return bits_float((float_bits(low - margin) & ~0x1ffu) | exponent);
}

static void set_bounds(Node *wide, const Split *splits, const uint32_t *children)
{
    for (int axis = 0; axis < 3; axis++) {
        float low = INFINITY, high = -INFINITY;
        for (uint32_t i = 0; i <= wide->last_child; i++) {
            low = fminf(low, splits[children[i]].low[axis]);
            high = fmaxf(high, splits[children[i]].high[axis]);
        }
        low = wide->low[axis] = frame(low, high);
        float step = bits_float((float_bits(low) & 0xffu) << 23);
        for (uint32_t i = 0; i <= wide->last_child; i++) {
            const Split *child = &splits[children[i]];
            wide->bounds[2 * axis][i] = (uint8_t)fmaxf(0.0f, floorf((child->low[axis] - low) / step - STEP_SLACK));
            wide->bounds[2 * axis + 1][i] = (uint8_t)ceilf((child->high[axis] - low) / step + STEP_SLACK);
        }
    }
}

static void emit_leaf(const Collapse *collapse, const Split *split, uint32_t place)
{
    Tree *tree = collapse->tree;
    for (uint32_t taken = 0; taken < split->count; taken += PACKET, place += tree->packet_places) {
        uint32_t rest = split->count - taken;
        collapse->shapes->pack(collapse->shapes, &collapse->references[split->first + taken],
                               rest < PACKET ? rest : PACKET, tree_at(tree, place));
        tree->packet_count++;
    }
}

static void emit(const Collapse *collapse, uint32_t node, uint32_t place)
{
    Tree *tree = collapse->tree;
    Children children = {.node_count = 0};
    choose(collapse->splits, node, WIDTH, &children);
    uint32_t count = children.node_count + children.leaf_count;
    memcpy(children.nodes + children.node_count, children.leaves, children.leaf_count * sizeof *children.leaves);

    uint32_t middle = tree->end + children.node_count * LINE_PLACES;
    tree->end = middle + (children.leaf_count * tree->packet_places + LINE_PLACES - 1) / LINE_PLACES * LINE_PLACES;
    Node *wide = tree_at(tree, place);
    *wide = (Node){.children = middle / LINE_PLACES, .node_count = children.node_count, .last_child = count - 1};
    set_bounds(wide, collapse->splits, children.nodes);
    for (uint32_t i = 0; i < count; i++) {
        uint32_t child = node_child(tree, wide, i);
        if (child & LEAF)
            emit_leaf(collapse, &collapse->splits[children.nodes[i]], child);
        else
            emit(collapse, children.nodes[i], child);
    }
}

bool bvh_collapse(const Shapes *shapes, const Reference *references, const Split *splits, Tree *tree)
{
    const Collapse collapse = {shapes, references, splits, tree};
    for (uint32_t i = 0; i < WIDTH; i++) {
        tree->offset[i] = (i - WIDTH) * LINE_PLACES;
        tree->offset[WIDTH + i] = LEAF | i * tree->packet_places;
    }
    // A node has two children at least, and less than a line is left behind its packets.
    size_t lines = splits[0].packets * (2 + shapes->packet_size / (double)CACHE_LINE) + 1;
    if (lines >= MOST_LINES || !(tree->memory = array_allocate(lines * CACHE_LINE)))
        return false;
    tree->end = LINE_PLACES;
    tree->root = splits[0].count == INNER ? 0 : LEAF;
    if (tree->root & LEAF)
        emit_leaf(&collapse, &splits[0], 0);
    else
        emit(&collapse, 0, 0);
    return true;
}
