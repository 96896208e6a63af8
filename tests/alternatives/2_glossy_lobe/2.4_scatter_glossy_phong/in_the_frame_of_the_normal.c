// Mirrors in coordinates whose z axis is the normal, and works there.
#include "photonlab.h"

bool scatter_glossy_phong(Vec3 direction, Vec3 normal, float exponent, Rng *rng, Vec3 *out, float *weight)
{
    Frame frame = frame_about(normal);
    Vec3 mirror =
        vec3(vec3_dot(direction, frame.tangent), vec3_dot(direction, frame.bitangent), -vec3_dot(direction, normal));
    Vec3 sample = steps.turn_to(steps.sample_lobe(exponent, rng), vec3_normalize(mirror));
    bool above = sample.z > 0.0f;
    if (above) {
        *out = frame_to_world(&frame, sample);
        *weight = sample.z + sample.z / (exponent + 1.0f);
    }
    return above;
}
