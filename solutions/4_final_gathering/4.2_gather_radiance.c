// Step 4.2: what a gather ray brings. Contract: lib/steps/4_final_gathering.h
#include "photonlab.h"

Colour gather_radiance(GatherTrace *trace, Ray ray, Rng *rng)
{
    // BEGIN SOLUTION
    Colour weight = colour_grey(1.0f);
    Hit hit;

    // 1. Follow the ray from surface to surface, until it leaves the scene or meets a lamp, which shadow rays have counted.
    while (gather_meet(trace, &ray, &hit) && hit.material->type != MATERIAL_LIGHT) {
        const Material *material = hit.material;

        // 2. At a rough surface, take the light that leaves it, by the irradiance kept there.
        if (material_is_rough(material)) {
            Colour sent_back = colour_mul(gather_albedo(trace, &ray, &hit), gather_irradiance(trace, &hit));
            return colour_mul(weight, colour_scale(sent_back, 1.0f / PI));
        }

        // 3. A mirror turns the ray and takes its share.
        Vec3 onward = steps.reflect(ray.direction, hit.normal);
        if (material->type == MATERIAL_MIRROR) {
            weight = colour_mul(weight, material->specular);
        } else {
            // 4. Glass reflects it as well, or lets it through, by Fresnel's share. Radiance is squeezed in the denser side.
            float eta = glass_eta(&hit, steps.refractive_index(material, WHITE));
            float share = steps.fresnel(-vec3_dot(ray.direction, hit.normal), eta);
            if (rng_float(rng) >= share && steps.refract(ray.direction, hit.normal, eta, &onward))
                weight = colour_scale(weight, eta * eta);
        }

        // 5. Go on from here.
        ray = (Ray){hit.position, onward, hit.primitive};
    }
    return colour_grey(0.0f);
    // STUB: return colour(0, 0, 0);
    // END SOLUTION
}
