// The energy ledger of one scene with right and with wrong steps: 1_ledger SCENE OUT.txt
// Red channel: shares of the emitted flux; what the books miss; chance in standard errors.
#include "photonlab.h"

#include <stdio.h>
#include <stdlib.h>

static bool not_reweighted(Colour *power, Colour reflectance, Rng *rng)
{
    Colour before = *power;
    bool survives =
        colour_sum(before) > 0.0f && rng_float(rng) < colour_sum(colour_mul(before, reflectance)) / colour_sum(before);
    if (survives)
        *power = colour_mul(before, reflectance); // and not divided by the probability
    return survives;
}

static Vec3 uniform_hemisphere(Vec3 normal, Rng *rng)
{
    float z = rng_float(rng);
    float phi = 2.0f * PI * rng_float(rng);
    float r = sqrtf(1.0f - z * z);
    Frame frame = frame_about(normal);
    return frame_to_world(&frame, vec3(r * cosf(phi), r * sinf(phi), z));
}

static void play(const Scene *scene, const char *name, FILE *text)
{
    PhotonPassOptions options = {.photons = 200000, .depth = 6, .seed = 8, .keep = KEEP_ALL, .play = {.loop = 1}};
    PhotonPass pass;
    Error error = {{0}};
    if (!photon_pass_run(scene, &options, &pass, &error)) {
        fprintf(stderr, "%s\n", error.message);
        exit(1);
    }
    const Ledger *books = &pass.ledger;
    double emitted = books->emitted[0];
    double missing = emitted - books->absorbed[0] - books->escaped[0] - books->cut[0] - books->chance[0];
    fprintf(text, "%s_emitted %.4f\n", name, emitted);
    fprintf(text, "%s_absorbed %.4f\n", name, books->absorbed[0]);
    fprintf(text, "%s_escaped %.4f\n", name, books->escaped[0]);
    fprintf(text, "%s_cut %.4f\n", name, books->cut[0]);
    fprintf(text, "%s_chance %.4f\n", name, books->chance[0]);
    fprintf(text, "%s_chance_error %.4f\n", name, books->chance_error[0]);
    fprintf(text, "%s_sigmas %.2f\n", name, books->chance[0] / books->chance_error[0]);
    fprintf(text, "%s_balances %d\n", name, fabs(missing) < 1e-4 * emitted);
    photon_pass_free(&pass);
}

int main(int count, char **names)
{
    Error error = {{0}};
    Scene *scene = count == 3 ? scene_load(names[1], &error) : NULL;
    FILE *text = scene ? fopen(names[2], "w") : NULL;
    if (!text || !steps_load(NULL, &error)) {
        fprintf(stderr, "usage: 1_ledger SCENE OUT.txt %s\n", error.message);
        return 1;
    }
    const Steps right = steps;
    play(scene, "right", text);
    steps.russian_roulette = not_reweighted;
    play(scene, "roulette", text);
    steps = right;
    steps.scatter_diffuse = uniform_hemisphere;
    play(scene, "uniform", text);
    scene_free(scene);
    return fclose(text);
}
