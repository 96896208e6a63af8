// How many numbers each case gives: the probe keeps to it, and the judge accepts nothing else.
#ifndef PHOTONLAB_CLI_PROBE_SIZES_H
#define PHOTONLAB_CLI_PROBE_SIZES_H

#include "judge/probe/probe_batch.h"
#include "judge/probe/probe_scatter.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>

// Numbers of one call of this step; 0: it is not called alone.
static inline size_t probe_call_size(const char *id)
{
    static const struct {
        const char *id;
        size_t size;
    } sizes[] = {{"1.1", 3}, {"1.2", 11}, {"1.3", 3}, {"1.4", 4}, {"1.6", 3}, {"2.1", 3}, {"2.2", 3},
                 {"2.3", 6}, {"2.4", 5},  {"3.1", 4}, {"3.2", 1}, {"3.3", 1}, {"3.5", 34}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
        if (strcmp(sizes[i].id, id) == 0)
            return sizes[i].size;
    return 0;
}

// Numbers that a case gives, from its line; 0 for a line that is none.
static inline size_t probe_case_size(const char *id, const char *line)
{
    long first, second;
    if (sscanf(line, "call %ld", &first) == 1)
        return (size_t)first * probe_call_size(id);
    if (sscanf(line, "paths %*s %*d %ld", &first) == 1)
        return (size_t)first * BATCH_NUMBERS;
    if (sscanf(line, "scatter %*s %*d %ld", &first) == 1)
        return SCATTER_HEAD + (size_t)first * SCATTER_NUMBERS;
    if (sscanf(line, "picture %*s %ld %ld", &first, &second) == 2)
        return (size_t)first * (size_t)second * 3;
    return 0;
}

#endif
