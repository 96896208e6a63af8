// The same from where the submission may lie within the checkout.
#include "../../../../solutions/1_diffuse_photon_map/1.1_reflect.c"
