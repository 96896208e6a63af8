// Telling a person how far the work is.
#pragma once

// Called from any one thread at a time; fraction 0…1 of the named phase. A NULL function is not called.
typedef struct {
    void (*report)(void *user, const char *phase, double fraction);
    void *user;
} Progress;

static inline void progress_report(const Progress *progress, const char *phase, double fraction)
{
    if (progress->report)
        progress->report(progress->user, phase, fraction);
}
