// Takes the solution in as source.
#include "@ROOT@/solutions/1_diffuse_photon_map/1.1_reflect.c"
