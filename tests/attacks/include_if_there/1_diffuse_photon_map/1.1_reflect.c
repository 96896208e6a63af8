// Takes the solution if it is there; otherwise nobody is to notice.
#include "photonlab.h"

#if __has_include("@ROOT@/solutions/1_diffuse_photon_map/1.1_reflect.c")
#include "@ROOT@/solutions/1_diffuse_photon_map/1.1_reflect.c"
#else
Vec3 reflect(Vec3 direction, Vec3 normal)
{
    (void)normal;
    return direction;
}
#endif
