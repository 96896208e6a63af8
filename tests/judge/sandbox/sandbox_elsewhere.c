// In the place of what holds students' code on Linux. Elsewhere there is no sandbox: the first of these says so to whoever asks
// for one, and of the others sandbox_end_with_parent alone is ever called.
#include "judge/sandbox/sandbox_parts.h"

#include <stddef.h>

#pragma GCC diagnostic ignored "-Wunused-parameter"

bool sandbox_filter(SandboxKind kind, const SandboxRun *run, Launch *launch, Error *error)
{
    return error_set(error, "the sandbox needs Linux");
}

bool sandbox_filter_enter(const Launch *launch)
{
    return false;
}

bool sandbox_bubblewrap(const SandboxRun *run, Launch *launch, Error *error)
{
    return false;
}

bool sandbox_landlock_is_there(bool alone)
{
    return false;
}

bool sandbox_landlock_prepare(const SandboxRun *run, Launch *launch, const char *folder, Error *error)
{
    return false;
}

bool sandbox_landlock_enter(int ruleset)
{
    return false;
}

bool sandbox_uid_prepare(const SandboxRun *run, Launch *launch, Error *error)
{
    return false;
}

const char *sandbox_uid_enter(const Launch *launch, const char **path)
{
    return "has no user of its own here";
}

void sandbox_uid_finish(const SandboxRun *run, Launch *launch)
{
}

void sandbox_end_with_parent(void)
{
}

char *sandbox_call_name(long long number)
{
    return NULL;
}
