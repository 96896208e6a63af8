// The same by another way to the same file.
#include "/proc/self/root@ROOT@/solutions/1_diffuse_photon_map/1.1_reflect.c"
