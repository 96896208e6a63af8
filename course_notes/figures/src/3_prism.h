// A ray through a 60° prism, by the steps' own functions: what the chapter's numbers and plots are made of. Two
// dimensions, angles in degrees, the apex up; light comes from the left and is bent down, towards the base.
#pragma once

#include "photonlab.h"

#include <stdio.h>
#include <stdlib.h>

static const double DEGREES = 57.295779513082321;

// Counter-clockwise from +x.
static inline Vec3 at_angle(double degrees)
{
    return vec3((float)cos(degrees / DEGREES), (float)sin(degrees / DEGREES), 0.0f);
}

static inline double angle_between(Vec3 a, Vec3 b)
{
    double cross = (double)a.x * (double)b.y - (double)a.y * (double)b.x;
    double dot = (double)a.x * (double)b.x + (double)a.y * (double)b.y;
    return DEGREES * fabs(atan2(cross, dot));
}

// The outward normals of the faces: left, right, base.
#define FACE_LEFT  150.0
#define FACE_RIGHT 30.0
#define FACE_BASE  270.0

static inline Vec3 prism_incoming(double incidence)
{
    return at_angle(incidence - 30.0);
}

// The direction inside, behind the left face.
static inline Vec3 prism_inside(double index, double incidence)
{
    Vec3 inside = vec3(0, 0, 0);
    steps.refract(prism_incoming(incidence), at_angle(FACE_LEFT), (float)(1.0 / index), &inside);
    return inside;
}

// The angle of the ray inside to the normal of the right face.
static inline double prism_second_incidence(double index, double incidence)
{
    return angle_between(prism_inside(index, incidence), at_angle(FACE_RIGHT));
}

// By how much the prism turns a ray; NAN: the right face reflects it totally.
static inline double prism_deviation(double index, double incidence)
{
    Vec3 out;
    Vec3 facing = vec3_negate(at_angle(FACE_RIGHT));
    if (!steps.refract(prism_inside(index, incidence), facing, (float)index, &out))
        return (double)NAN;
    return angle_between(prism_incoming(incidence), out);
}

// D_min = 2·asin(n·sin 30°) − 60°, at the incidence asin(n·sin 30°).
static inline double prism_best_incidence(double index)
{
    return DEGREES * asin(0.5 * index);
}

// Below this incidence the right face reflects totally.
static inline double prism_cut(double index)
{
    return DEGREES * asin(index * sin(60.0 / DEGREES - asin(1.0 / index)));
}

static inline double index_of(const char *glass, double wavelength_nm)
{
    return glass_index(glass_find(glass), wavelength_nm);
}

static inline void load_reference_steps(void)
{
    Error error = {""};
    if (steps_load(NULL, &error))
        return;
    fprintf(stderr, "%s\n", error.message);
    exit(1);
}

// The file named by the first argument, or standard output.
static inline FILE *open_output(int count, char **arguments)
{
    FILE *out = count > 1 ? fopen(arguments[1], "w") : stdout;
    if (out)
        return out;
    fprintf(stderr, "cannot write %s\n", arguments[1]);
    exit(1);
}
