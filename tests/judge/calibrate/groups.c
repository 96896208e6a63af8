#define _GNU_SOURCE // popen, mkstemp
#include "calibrate.h"
#include "judge/probe/probe_sizes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define BLOCK 10 // groups that one probe draws

typedef struct {
    const Arguments *a;
    const PictureSet *set;
    uint64_t purpose;
    long groups;
} Run;

static uint64_t seed_of(const Run *run, long block)
{
    uint64_t seed = hash_text(hash_u64((uint64_t)run->a->seed), run->set->name);
    return hash_u64(hash_u64(seed + run->purpose) + hash_u64((uint64_t)block));
}

// The block's pictures, planned as the judge plans them. The path's last six letters are filled in.
static bool write_cases(const Run *run, long block, long groups, char *path)
{
    Plan plan = {.seed = seed_of(run, block)};
    for (long i = 0; i < groups; i++)
        picture_set_plan(run->set, &plan);
    int fd = mkstemp(path);
    FILE *file = fd >= 0 ? fdopen(fd, "w") : NULL;
    for (size_t i = 0; file && i < plan.count; i++)
        fprintf(file, "%s\n", plan.lines[i]);
    plan_free(&plan);
    return file && fclose(file) == 0;
}

static bool read_picture(FILE *pipe, uint32_t number, size_t floats, float *values)
{
    uint32_t head[2];
    return fread(head, sizeof head, 1, pipe) == 1 && head[0] == number && head[1] == floats &&
           fread(values, sizeof *values, floats, pipe) == floats;
}

// What the probe sends, into values.
static bool draw(const Run *run, const char *cases, size_t pictures, size_t floats, float *values)
{
    char solution[4300], command[16384], magic[sizeof PROBE_MAGIC] = "";
    const Arguments *a = run->a;
    const char *step = a->step ? a->step : run->set->step;
    snprintf(solution, sizeof solution, "%s/solutions/%s.so", a->build, step_find(step)->file);
    snprintf(command, sizeof command,
             "'%s/probe' --step %s --object '%s' --references '%s/solutions' --fd 3 '%s' 3>&1 1>/dev/null", a->build,
             step, a->object ? a->object : solution, a->build, cases);
    FILE *pipe = popen(command, "r");
    if (!pipe)
        return false;
    bool ok = fread(magic, strlen(PROBE_MAGIC), 1, pipe) == 1 && strcmp(magic, PROBE_MAGIC) == 0;
    for (size_t i = 0; ok && i < pictures; i++)
        ok = read_picture(pipe, (uint32_t)i, floats, values + i * floats);
    return pclose(pipe) == 0 && ok;
}

static bool run_block(const Run *run, long block, void (*each)(long, const Results *, void *), void *data)
{
    long first = block * BLOCK, groups = run->groups - first < BLOCK ? run->groups - first : BLOCK;
    size_t floats = (size_t)run->set->side * (size_t)run->set->side * 3, replicates = (size_t)run->set->replicates;
    size_t pictures = (size_t)groups * replicates;
    float *values = malloc(pictures * floats * sizeof *values);
    char cases[4200];
    snprintf(cases, sizeof cases, "%s/calibrate-XXXXXX", run->a->build);
    bool ok = values && write_cases(run, block, groups, cases);
    ok = ok && draw(run, cases, pictures, floats, values);
    unlink(cases);
    for (long g = 0; ok && g < groups; g++) {
        Numbers numbers[MOST_REPLICATES];
        for (size_t r = 0; r < replicates; r++)
            numbers[r] = (Numbers){values + ((size_t)g * replicates + r) * floats, floats};
        each(first + g, &(Results){.cases = numbers, .count = replicates}, data);
    }
    free(values);
    return ok;
}

bool groups_run(const Arguments *a, const PictureSet *set, uint64_t purpose, long groups,
                void (*each)(long group, const Results *pictures, void *data), void *data)
{
    const Run run = {a, set, purpose, groups};
    long blocks = (groups + BLOCK - 1) / BLOCK;
    bool ok = true;
#pragma omp parallel for schedule(dynamic, 1) num_threads(parallel_threads(a->jobs)) reduction(&& : ok)
    for (long block = 0; block < blocks; block++)
        ok = ok && run_block(&run, block, each, data);
    return ok;
}
