#include "base/text.h"
#include "render/passes/pass_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST_BYTES (64u << 20) // of a scene file

void pass_origin_range(const PassOrigin *origin, int *first, int *last)
{
    *first = (int)((long long)origin->all * (origin->part - 1) / origin->parts);
    *last = (int)((long long)origin->all * origin->part / origin->parts);
}

// Both are the same flags in the same order, each with its value.
static void compare_settings(const char *own, const char *other, char *text, size_t size)
{
    char flag[100], value[100], other_value[100];
    int length, other_length;
    while (sscanf(own, "%99s %99s%n", flag, value, &length) == 2 &&
           sscanf(other, "%*s %99s%n", other_value, &other_length) == 1) {
        if (strcmp(value, other_value) != 0)
            text_append(text, size, "%s%s %s, not %s", *text ? ", " : "it was made by ", flag, value, other_value);
        own += length;
        other += other_length;
    }
}

bool pass_origin_differs(const PassOrigin *origin, const PassOrigin *other, char *text, size_t size)
{
    text[0] = '\0';
    if (strcmp(origin->scene, other->scene) != 0)
        text_append(text, size, "its scene is %s, not %s", origin->scene, other->scene);
    else if (strcmp(origin->settings, other->settings) != 0)
        compare_settings(origin->settings, other->settings, text, size);
    else if (strcmp(origin->code, other->code) != 0)
        text_append(text, size, "it was made by %s, not by %s", origin->code, other->code);
    return text[0] != '\0';
}

// Of numbers of 32 bits, so that it does not depend on the order of their bytes.
static uint64_t add_words(uint64_t hash, const void *words, size_t bytes)
{
    for (size_t i = 0; i < bytes; i += sizeof(uint32_t)) {
        uint32_t word;
        memcpy(&word, (const char *)words + i, sizeof word);
        hash = hash_u64(hash ^ word);
    }
    return hash;
}

bool pass_origin_scene(const char *path, const Scene *scene, PassOrigin *origin, Error *error)
{
    size_t size;
    char *text = text_read_file(path, MOST_BYTES, &size, error);
    if (!text)
        return false;
    uint64_t hash = size;
    for (size_t i = 0; i < size; i++)
        hash = hash_u64(hash ^ (unsigned char)text[i]);
    free(text);
    for (size_t i = 0; i < scene->flat_count; i++) // meshes are in none of the text
        hash = add_words(hash, &scene->flats[i], 3 * sizeof(Vec3));
    hash = add_words(hash, scene->normals, scene->normal_count * sizeof *scene->normals);
    const char *slash = strrchr(path, '/');
    snprintf(origin->scene, sizeof origin->scene, "%.200s (%016llx)", slash ? slash + 1 : path,
             (unsigned long long)hash);
    for (char *at = origin->scene; *at; at++) // it is to stay one line
        *at = *at == '\n' ? '?' : *at;
    return true;
}

void pass_origin_settings(const RenderOptions *options, const Passes *passes, PassOrigin *origin)
{
    const RenderSettings *s = &options->settings;
    char choice[40];
    step_choice_print(options->play, choice, sizeof choice);
    snprintf(origin->settings, sizeof origin->settings,
             "--integrator %s --size %dx%d --photons %ld --k %d --radius %.9g --samples %d --depth %d --seed %llu "
             "--reuse %.9g --steps %s --wavelengths %d --glass-sides %d --alpha %.9g --radii %s",
             integrator_names[options->integrator], s->width, s->height, s->photons, s->k, (double)s->radius,
             s->samples, s->depth, (unsigned long long)options->seed, (double)options->reuse, choice,
             options->hero ? 3 : 1, options->glass_sides, (double)passes->alpha, passes->by_pixel ? "pixel" : "pass");
    snprintf(origin->code, sizeof origin->code, "the reference's steps");
    const char *before = " but ";
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (step_states[i] == STEP_STUDENT) {
            text_append(origin->code, sizeof origin->code, "%s%s", before, step_table[i].id);
            before = " ";
        }
}
