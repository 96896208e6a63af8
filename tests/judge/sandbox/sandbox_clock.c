// The limit by the clock. It is for what waits: what got a processor since the last look waits for its turn on a busy machine.
#include "judge/sandbox/sandbox_parts.h"

#include <stdio.h>
#include <string.h>
#include <time.h>

#define PATIENCE 10 // times the limit that a busy machine may take

double sandbox_now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

// Processor time of a process and those that it started, ticks; 0 where the system does not tell.
static unsigned long ticks_of(int process)
{
    char path[64], text[1024] = "";
    unsigned long user = 0, kernel = 0;
    int child;
    snprintf(path, sizeof path, "/proc/%d/stat", process);
    FILE *file = fopen(path, "re");
    if (!file)
        return 0;
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    const char *behind_name = strrchr(text, ')');
    if (behind_name)
        sscanf(behind_name, ") %*c %*d %*d %*d %*d %*d %*u %*u %*u %*u %*u %lu %lu", &user, &kernel);
    snprintf(path, sizeof path, "/proc/%d/task/%d/children", process, process);
    file = fopen(path, "re");
    while (file && fscanf(file, "%d", &child) == 1)
        user += ticks_of(child);
    if (file)
        fclose(file);
    return user + kernel;
}

bool sandbox_waits_too_long(pid_t child, const SandboxRun *run, Waiting *waiting)
{
    if (sandbox_now() <= waiting->deadline)
        return false;
    unsigned long before = waiting->ticks;
    waiting->ticks = ticks_of(child);
    waiting->deadline += run->wall_seconds;
    return waiting->ticks <= before || sandbox_now() > waiting->begin + PATIENCE * run->wall_seconds;
}
