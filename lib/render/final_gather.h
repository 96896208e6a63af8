// Final gathering (Jensen 1996): indirect light comes from rays sent out over the hemisphere, which look the photon map up
// where they end, and not from a look-up where one looks. Its blotches are then averaged away.
//
//   photons ──▶ irradiance_map: E at some of them ──▶ gather rays (gather_trace) ──▶ irradiance_estimate ──▶ irradiance_cache
#pragma once

#include "render/eye.h"
#include "render/gather/gather_trace.h"
#include "render/gather/irradiance_cache.h"
#include "render/gather/irradiance_map.h"

#define GATHER_ACCURACY 0.25f // a of the cache
#define SHORTEST        1.5f  // pixels in which an estimate serves at least
#define LONGEST         6.0f  // times that, at most
#define LIFT            1e-3f // pixels

struct FinalGather {
    IrradianceMap *ends; // light where gather rays end
    IrradianceCache *cache;
    float size;  // of the scene, m
    float pixel; // angle that a pixel covers, radians
};

struct GatherTrace {
    Eye *eye;
    float distance; // of the last ray, to its first surface
    int met;        // surfaces, by the present ray
    bool is_second; // sent by a gather ray that was short
    bool is_sent;   // by gather_send, which makes of a colour's share the whole
    int channel;    // the one that is left after dispersing glass; −1: all
    Material glass; // the last that disperses, as this channel meets it
};

// Makes the estimates that the picture needs. One eye a thread; the same estimates whatever their number. False: no memory.
bool final_gather_fill(Eye *eyes, int threads);

// Indirect irradiance at a rough hit that the eye sees along −wo, `distance` away in all, W/m².
Colour final_gather_irradiance(Eye *eye, const Hit *hit, Vec3 wo, float distance);

// An estimate by gather rays.
void irradiance_estimate_make(Eye *eye, const Hit *hit, Vec3 wo, float distance, IrradianceEstimate *estimate);
