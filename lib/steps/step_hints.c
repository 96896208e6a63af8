#include "steps/step_hints.h"

const char *const step_hints[STEP_COUNT][HINT_COUNT] = {
    {
        // 1.1 reflect
        "Take the direction apart: one part along the normal, one in the surface. Which of the two does a mirror "
        "change, and how?",
        "r = d − 2(d·n)n. The part along the normal is (d·n)n: taken away once, the rest lies in the surface; taken "
        "away twice, it comes out mirrored. Turning n round changes nothing.",
        "vec3_dot(direction, normal) is how far the direction goes along the normal. vec3_along(a, b, s) is a + "
        "s·b.\n"
        "return vec3_along(direction, normal, -2 times how far);",
    },
    {
        // 1.2 emit_photon
        "A photon needs a place, a direction and power. Is any place on the lamp likelier than another? And any "
        "direction? A lamp that looks equally bright from all sides sends less sideways, since its surface looks "
        "narrower from there.",
        "Place: corner + u·edge_u + v·edge_v, with u and v uniform in 0…1. Direction: the cosine about "
        "light->direction, which is what step 1.3 draws. Power: all of light->power; the photon pass divides by the "
        "number of photons.",
        "float u = rng_float(rng), and float v in a statement of its own. Two calls of vec3_along lead from "
        "light->position to the place. The direction is steps.scatter_diffuse(light->direction, rng).\n"
        "return photon_create(position, direction, light->power);",
    },
    {
        // 1.3 scatter_diffuse
        "More photons leave near the normal than along the surface. A random number taken as the angle itself would "
        "crowd them at the normal, taken as its cosine it would spread them evenly. What lies between?",
        "The share of photons within θ of the normal is sin²θ. Set it to a uniform random number 1 − u₁:\n"
        "cosθ = √u₁,  sinθ = √(1 − u₁),  and about the normal φ = 2πu₂.\n"
        "With the normal as z axis, the direction is (sinθ cosφ, sinθ sinφ, cosθ).",
        "float u1 = rng_float(rng);  float u2 = rng_float(rng);\n"
        "cos_theta = sqrtf(u1);  sin_theta = sqrtf(1 - u1);\n"
        "Frame frame = frame_about(normal);\n"
        "return frame_to_world(&frame, vec3(…));",
    },
    {
        // 1.4 russian_roulette
        "A wall that reflects half of the light could halve the power of every photon, or stop every second one. "
        "Both are right on average. Which one needs fewer photons to follow, and what must the survivors then carry?",
        "p = min(1, Σ Φ_c ρ_c / Σ Φ_c)\n"
        "with sums over red, green and blue of this photon's own power. A survivor's power becomes Φ_c ρ_c / p, so "
        "that the mean stays Φ_c ρ_c. A photon without power has p = 0: mind 0/0.",
        "reflected = colour_mul(*power, reflectance);  p = colour_sum(reflected) / colour_sum(*power), at most 1.\n"
        "If rng_float(rng) >= p: return false, and leave *power alone.\n"
        "Otherwise *power = colour_scale(reflected, 1 / p) and return true.",
    },
    {
        // 1.5 trace_photon
        "Follow one photon with your finger: it flies, lands, perhaps leaves a copy, takes a new direction, flies "
        "on. Where can its path end? Does the copy carry the power from before the bounce or from after it?",
        "while (photon_fly(…)): if the surface is rough, photon_store; then a switch over hit.material->type: "
        "diffuse, glossy, mirror, glass, light, as the header lists them. A roulette that is lost ends the path. At "
        "the end of each round the photon moves to hit.position.",
        "Hit hit;  while (photon_fly(trace, &photon, &hit)) { … photon.position = hit.position; }\n"
        "Store: if (material_is_rough(hit.material)) photon_store(trace, &photon, &hit);\n"
        "MATERIAL_DIFFUSE: if (!steps.russian_roulette(&photon.power, hit.material->diffuse, rng)) return; then "
        "photon.direction = steps.scatter_diffuse(hit.normal, rng);\n"
        "MATERIAL_MIRROR: the same with ->specular and steps.reflect(photon.direction, hit.normal).\n"
        "MATERIAL_GLOSSY: if (!photon_scatter_glossy(&photon, &hit, rng)) return;\n"
        "MATERIAL_GLASS: photon_scatter_glass(&photon, &hit, rng);  MATERIAL_LIGHT: return;",
    },
    {
        // 1.6 estimate_radiance
        "Photons carry watts; radiance needs watts per square metre. Which area do the photons share that you have "
        "found? Should one at the rim of it count as much as one in the middle?",
        "L = 3/(πr²) Σ f_r Φ (1 − d/r)\n"
        "over the photons that came from the normal's side. The 3: a cone of height 1 over the disk has a third of "
        "its area as volume. No cosine: photons already arrive more thinly on a tilted surface.",
        "size_t found = gather_near(map, hit->position, gather, &r); if nothing was found or r is 0: return black.\n"
        "For each i: photon = gather->near[i].photon; skip it unless stored_photon_on_side(photon, hit->normal).\n"
        "weight = 1 - sqrtf(gather->near[i].distance2) / r;  f = gather_brdf(gather, hit, photon, wo);\n"
        "Add colour_scale(colour_mul(f, photon->power), weight). After the loop scale the sum by 3 / (PI * r * r).",
    },
    {
        // 2.1 sample_lobe
        "Step 1.3 drew by the cosine; this lobe is the cosine to the power n, narrower the larger n is. For n = 1 it "
        "must be step 1.3's again, for n = 0 all directions above are equally likely. Which root of a random number "
        "does both?",
        "The share of directions farther than α from +z is cosα to the power n+1. Set it to u₁, with n+1 and not "
        "n:\n"
        "cosα = u₁^(1/(n+1)),  sinα = √(1 − cos²α),  φ = 2πu₂\n"
        "and the direction is (sinα cosφ, sinα sinφ, cosα).",
        "float u1 = 1 - rng_float(rng), never 0;  float u2 = rng_float(rng);\n"
        "cos_alpha = powf(u1, 1 / (exponent + 1)) would do, but for large n the 1 - cos² behind the sine loses its "
        "digits. So: log_cos = logf(u1) / (exponent + 1);\n"
        "cos_alpha = expf(log_cos);  sin_alpha = sqrtf(-expm1f(2 * log_cos));",
    },
    {
        // 2.2 turn_to
        "local.x, local.y and local.z say how far to go along x, y and z. Which three unit vectors take their places "
        "when +z becomes `axis`?",
        "turned = local.x·tangent + local.y·bitangent + local.z·axis\n"
        "A cross product of the axis with a vector that is not parallel to it gives the tangent, once it is made "
        "unit length; a second one gives the bitangent. No one vector will do for every axis: choose between two.",
        "helper = fabsf(axis.x) < 0.7f ? the x axis : the y axis;\n"
        "tangent = vec3_normalize(vec3_cross(helper, axis));  bitangent = vec3_cross(axis, tangent);\n"
        "Then vec3_scale(tangent, local.x), and vec3_along for the other two.",
    },
    {
        // 2.3 scatter_glossy_source_text
        "The source text draws a diffuse direction first. A plane at right angles to the mirror direction parts all "
        "directions in two. What becomes of a draw on the mirror direction's side, and what of one on the other?",
        "out = a diffuse direction about the normal. dot(out, mirror) ≤ 0: it stays. Otherwise a lobe sample about "
        "the mirror direction replaces it, drawn again while dot(out, normal) ≤ 0, at most MAX_LOBE_TRIES times. "
        "*weight is always 1.",
        "mirror = steps.reflect(direction, normal);  *weight = 1;\n"
        "*out = steps.scatter_diffuse(normal, rng);\n"
        "if (vec3_dot(*out, mirror) <= 0) return true;\n"
        "Up to MAX_LOBE_TRIES times: local = steps.sample_lobe(exponent, rng);  *out = steps.turn_to(local, mirror); "
        "and return true if vec3_dot(*out, normal) > 0.\n"
        "After that: redraw_cap_reached();  return false;",
    },
    {
        // 2.4 scatter_glossy_phong
        "Step 2.3 sends on every photon with all its power, also where half of the lobe lies inside the surface. If "
        "nothing may be drawn again, what becomes of a sample that points inside? And is a sample at a grazing angle "
        "worth as much as one straight up?",
        "weight = f·cosθ_o / (ρ·pdf),  f = ρ(n+2)/(2π)·cosⁿα,  pdf = (n+1)/(2π)·cosⁿα\n"
        "Write the fraction down and cancel: little is left, and nothing of α.",
        "mirror = steps.reflect(direction, normal);  local = steps.sample_lobe(exponent, rng);\n"
        "*out = steps.turn_to(local, mirror);\n"
        "cos_out = vec3_dot(*out, normal); if it is not above 0: return false.\n"
        "*weight = (exponent + 2) / (exponent + 1) * cos_out;  return true;",
    },
    {
        // 3.1 refract
        "Snell: n_i sinθ_i = n_t sinθ_t. When would sinθ_t have to be larger than 1, and what does light do then? "
        "The sine belongs to the part of the direction along the surface: by which factor does that part change?",
        "cosθ_i = −d·n;  cos²θ_t = 1 − η²(1 − cos²θ_i)\n"
        "t = ηd + (η cosθ_i − cosθ_t)n\n"
        "If cos²θ_t is negative: return false, before the root is taken.",
        "cos_i = -vec3_dot(direction, normal);  cos2_t = 1 - eta * eta * (1 - cos_i * cos_i); below 0: return false "
        "and leave *refracted alone.\n"
        "t = vec3_along(vec3_scale(direction, eta), normal, eta * cos_i - sqrtf(cos2_t));\n"
        "*refracted = vec3_normalize(t);  return true;",
    },
    {
        // 3.2 fresnel
        "A window seen straight on reflects a few per cent, seen at a grazing angle nearly everything. What does "
        "total reflection reflect? Start with that case: cosθ_t is found as in step 3.1.",
        "R_s = (η cosθ_i − cosθ_t)/(η cosθ_i + cosθ_t)\n"
        "R_p = (cosθ_i − η cosθ_t)/(cosθ_i + η cosθ_t)\n"
        "R = (R_s² + R_p²)/2\n"
        "To try out: cosθ_i = 1 and η = 1/1.5 give 0.04, and so does η = 1.5.",
        "cos2_t = 1 - eta * eta * (1 - cos_i * cos_i); if it is not above 0: return 1.\n"
        "cos_t = sqrtf(cos2_t);\n"
        "r_s = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);\n"
        "r_p = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);\n"
        "return 0.5f * (r_s * r_s + r_p * r_p);",
    },
    {
        // 3.3 refractive_index
        "Red, green and blue each have an index of their own. White is all three at once: which single number is "
        "fair to all?",
        "RED: index[0], GREEN: index[1], BLUE: index[2]. WHITE: the mean of the three, not the middle one.",
        "switch (colour) with a case for each. Or by arithmetic, but look at the enum first: WHITE is 0 and RED is "
        "1, so a colour's place is colour - RED.\n"
        "White: (glass->index[0] + glass->index[1] + glass->index[2]) / 3.0f",
    },
    {
        // 3.4 trace_photon_in_colour
        "A loop follows one photon. Behind glass there may be three: who follows the other two? Which parts of your "
        "step 1.5 can stay as they are?",
        "Fly once, and return if the path ended; move to hit.position; store on a rough surface; treat the material "
        "as in 1.5; and in place of the next round call yourself. At glass: F_c for each channel at its own index, "
        "F̄ their mean. \n"
        "With probability F̄ reflect, power_c ·= F_c/F̄.\n"
        "Otherwise power_c ·= (1 − F_c)/(1 − F̄), split, and call yourself for each child.",
        "band = photon.colour == WHITE ? (PhotonColour)(RED + c) : photon.colour;\n"
        "share[c] = steps.fresnel(cos_i, glass_eta(hit, steps.refractive_index(glass, band))); mean = a third of "
        "their sum.\n"
        "if (rng_float(rng) < mean): multiply the power, photon.direction = steps.reflect(…), "
        "steps.trace_photon_in_colour(trace, photon, rng), return.\n"
        "Otherwise multiply the power;  Photon children[3];  int count = steps.split_colour(&photon, glass, "
        "children); for each child: eta by its own colour, and if steps.refract(photon.direction, hit->normal, eta, "
        "&children[i].direction): call yourself with it.",
    },
    {
        // 3.5 split_colour
        "One photon becomes three. If each of them carried all of its power, how much light would there be behind "
        "the prism? And what must happen when one of the three leaves the glass again?",
        "White in glass that disperses: (Φr, 0, 0) RED, (0, Φg, 0) GREEN, (0, 0, Φb) BLUE; return 3. Anything else, "
        "a coloured photon or glass of one index, goes on as it is: one child, return 1.",
        "if (photon->colour != WHITE || !glass->disperses): children[0] = *photon and return 1.\n"
        "For c = 0, 1, 2: children[c] = *photon;  children[c].colour = (PhotonColour)(RED + c);\n"
        "children[c].power = colour_grey(0);  colour_set_channel(&children[c].power, c, "
        "colour_channel(photon->power, c));\n"
        "return 3;",
    },
};
