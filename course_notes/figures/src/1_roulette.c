// What three rules at a surface do to the photons of one scene: 1_roulette SCENE OUT.dat OUT.txt
// OUT.dat, one block per rule: log10 of a stored photon's flux over the flux it started with, share of photons.
// OUT.txt, per rule and per emitted photon: how many are stored, how many rays they cost, the flux that arrives over
// the flux emitted; and how many equal photons a stored one is worth, (Σw)²/(n Σw²).
#include "photonlab.h"

#include <stdio.h>
#include <stdlib.h>

enum { PHOTONS = 200000, CELLS = 60, RULES = 3 };

typedef bool (*Rule)(Colour *power, Colour reflectance, Rng *rng);

// No roulette: every photon lives on with what the surface leaves it.
static bool multiply(Colour *power, Colour reflectance, Rng *rng)
{
    (void)rng;
    *power = colour_mul(*power, reflectance);
    return colour_sum(*power) > 0.0f;
}

// Roulette by the mean reflectance of the surface, whatever colour the photon has.
static bool by_mean(Colour *power, Colour reflectance, Rng *rng)
{
    float survival = colour_sum(reflectance) / 3.0f;
    if (rng_float(rng) >= survival)
        return false;
    *power = colour_scale(colour_mul(*power, reflectance), 1.0f / survival);
    return true;
}

static void play(const Scene *scene, const char *name, FILE *data, FILE *text)
{
    PhotonPassOptions options = {.photons = PHOTONS, .depth = 24, .seed = 4, .keep = KEEP_ALL, .play = {.loop = 1}};
    PhotonPass pass;
    Error error = {{0}};
    if (!photon_pass_run(scene, &options, &pass, &error)) {
        fprintf(stderr, "%s\n", error.message);
        exit(1);
    }
    double start = (pass.ledger.emitted[0] + pass.ledger.emitted[1] + pass.ledger.emitted[2]) / PHOTONS;
    double sum = 0.0;
    double sum2 = 0.0;
    long cells[CELLS] = {0};
    for (size_t i = 0; i < pass.rest.count; i++) {
        double ratio = (double)colour_sum(pass.rest.photons[i].power) / start;
        int cell = (int)floor((log10(ratio) + 4.0) * (CELLS / 6.0)); // 10⁻⁴ … 10²
        if (cell >= 0 && cell < CELLS)
            cells[cell]++;
        sum += ratio;
        sum2 += ratio * ratio;
    }
    for (int c = 0; c < CELLS; c++)
        fprintf(data, "%.3f %.6f\n", (c + 0.5) * 6.0 / CELLS - 4.0, (double)cells[c] / (double)pass.rest.count);
    fprintf(data, "\n\n");
    fprintf(text, "%s_stored_per_emitted %.3f\n", name, (double)pass.rest.count / PHOTONS);
    fprintf(text, "%s_rays_per_emitted %.3f\n", name, (double)pass.segments / PHOTONS);
    fprintf(text, "%s_worth %.3f\n", name, sum * sum / sum2 / (double)pass.rest.count);
    fprintf(text, "%s_arrived_per_emitted %.3f\n", name, sum / PHOTONS);
    photon_pass_free(&pass);
}

int main(int count, char **names)
{
    Error error = {{0}};
    FILE *data = count == 4 ? fopen(names[2], "w") : NULL;
    FILE *text = count == 4 ? fopen(names[3], "w") : NULL;
    Scene *scene = count == 4 ? scene_load(names[1], &error) : NULL;
    if (!data || !text || !scene || !steps_load(NULL, &error)) {
        fprintf(stderr, "usage: 1_roulette SCENE OUT.dat OUT.txt %s\n", error.message);
        return 1;
    }
    const Rule rules[RULES] = {steps.russian_roulette, by_mean, multiply};
    const char *const rule_names[RULES] = {"own", "mean", "none"};
    for (int i = 0; i < RULES; i++) {
        steps.russian_roulette = rules[i];
        play(scene, rule_names[i], data, text);
    }
    scene_free(scene);
    return fclose(data) | fclose(text);
}
