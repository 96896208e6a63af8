// From the binary tree to nodes of eight children. The nodes are laid out in the order in which a ray that
// always takes the first child meets them, so that near relatives lie in near memory.
#include "scene/bvh/bvh_internal.h"

#include <stdlib.h>

typedef struct {
    const Split *splits;
    Tree *tree;
    Run *runs;
} Collapse;

static void count_leaves(const Split *splits, uint32_t node, uint32_t *leaves, uint32_t *packets)
{
    while (splits[node].count == INNER) {
        count_leaves(splits, node + 1, leaves, packets);
        node = splits[node].first;
    }
    *leaves += 1;
    *packets += packets_of(splits[node].count);
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

static float split_half_area(const Split *split)
{
    float d[3] = {split->high[0] - split->low[0], split->high[1] - split->low[1], split->high[2] - split->low[2]};
    return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
}

// Opens the largest inner child again and again until the wide node is full: its children in the binary tree.
static int choose_children(const Split *splits, uint32_t node, uint32_t children[WIDTH])
{
    float area[WIDTH];
    int count = 1;
    children[0] = node;
    area[0] = INFINITY;
    while (count < WIDTH) {
        int widest = -1;
        for (int i = 0; i < count; i++)
            if (area[i] >= 0.0f && (widest < 0 || area[i] > area[widest]))
                widest = i;
        if (widest < 0)
            break;
        uint32_t opened[2] = {children[widest] + 1, splits[children[widest]].first};
        for (int i = 0; i < 2; i++) {
            int place = i == 0 ? widest : count;
            children[place] = opened[i];
            area[place] = splits[opened[i]].count == INNER ? split_half_area(&splits[opened[i]]) : -1.0f;
        }
        count++;
    }
    return count;
}

static uint32_t emit(Collapse *collapse, uint32_t node)
{
    const Split *splits = collapse->splits;
    if (splits[node].count != INNER)
        return emit_leaf(collapse, &splits[node]);
    uint32_t children[WIDTH];
    int count = choose_children(splits, node, children);
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

bool bvh_collapse(const Split *splits, Tree *tree, Run **runs)
{
    uint32_t leaves = 0;
    uint32_t packets = 0;
    count_leaves(splits, 0, &leaves, &packets);
    // The most nodes that there can be: a node is full, or it has nothing but leaves for children, at least two.
    tree->nodes = bvh_allocate((leaves / 2 + leaves / (WIDTH - 1) + 1) * sizeof(Node));
    *runs = malloc(packets * sizeof **runs);
    if (!*runs || !tree->nodes)
        return false;
    Collapse collapse = {splits, tree, *runs};
    tree->root = emit(&collapse, 0);
    return true;
}
