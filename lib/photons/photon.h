// Photons in flight and at rest.
#pragma once

#include "math/colour.h"
#include "math/vec3.h"
#include "scene/spectrum.h"

#include <math.h>
#include <stdint.h>

// Photons start white. At its first refraction in dispersing glass a white photon becomes three coloured ones; a
// coloured photon never changes colour again.
typedef enum { WHITE, RED, GREEN, BLUE } PhotonColour;

// What lies between the light and the photon's present place.
typedef enum {
    PATH_DIRECT,  // nothing: straight from the light
    PATH_CAUSTIC, // mirrors and glass only
    PATH_INDIRECT // at least one diffuse or glossy bounce
} PhotonPath;

// A photon in flight: a packet of flux, not a quantum.
typedef struct {
    Vec3 position;    // m
    Vec3 direction;   // unit, the way it flies
    Colour power;     // flux it carries, W; already divided by the number of photons emitted
    float wavelength; // nm: of all its flux, which then stands in power three times; 0: power is red, green and blue
    float others[2];  // hero wavelengths: those of power's second and third number, until dispersing glass; 0: none
    PhotonColour colour;
    PhotonPath path;
    int bounce;                // surfaces met so far
    uint32_t from;             // kept by photon_fly: the surface it left,
    float flown;               // how far it flew since the light, m,
    const void *left_material; // and what the surface is made of (NULL: fresh from the light)
} Photon;

// One thread's share of a photon pass; see pass/trace.h, whose calls take it.
typedef struct PhotonTrace PhotonTrace;

// A photon at rest in the map: 32 bytes.
typedef struct {
    Vec3 position;
    Colour power;
    uint32_t packed_wi; // use stored_photon_wi
    uint8_t colour;     // PhotonColour; beyond BLUE: of a single wavelength, see wavelength_of_band
    uint8_t path;       // PhotonPath
    uint8_t bounce;     // surfaces met before this one, 255 at most
    uint8_t material;   // index of the material it landed on
} StoredPhoton;

// A wavelength as one byte behind the PhotonColours, to 0.7 nm: for who looks at photons. Estimates need their power alone.
#define BAND_FIRST (BLUE + 1)
#define BAND_WIDTH (WAVELENGTH_RANGE / (255 - BAND_FIRST)) // nm
static inline uint8_t band_of_wavelength(float wavelength)
{
    return (uint8_t)(BAND_FIRST + (int)((wavelength - WAVELENGTH_FIRST) / BAND_WIDTH + 0.5f));
}

static inline float wavelength_of_band(int colour)
{
    return colour < BAND_FIRST ? 0.0f : WAVELENGTH_FIRST + (float)(colour - BAND_FIRST) * BAND_WIDTH;
}

// Directions as two 16-bit numbers on an octahedron unfolded to a square (Cigolle et al. 2014); error below 1e-4 rad.
static inline uint32_t direction_pack(Vec3 d)
{
    float scale = 1.0f / (fabsf(d.x) + fabsf(d.y) + fabsf(d.z));
    float x = d.x * scale;
    float y = d.y * scale;
    if (d.z < 0.0f) {
        float folded_x = (1.0f - fabsf(y)) * (x >= 0.0f ? 1.0f : -1.0f);
        y = (1.0f - fabsf(x)) * (y >= 0.0f ? 1.0f : -1.0f);
        x = folded_x;
    }
    uint32_t ix = (uint32_t)((x + 1.0f) * 32767.0f + 0.5f);
    uint32_t iy = (uint32_t)((y + 1.0f) * 32767.0f + 0.5f);
    return ix << 16 | iy;
}

// The inverse, of any length: enough where only the sign of a dot product matters.
static inline Vec3 direction_unpack_raw(uint32_t packed)
{
    float x = (float)(packed >> 16) - 32767.0f;
    float y = (float)(packed & 0xffffu) - 32767.0f;
    float z = 32767.0f - fabsf(x) - fabsf(y);
    float fold = z < 0.0f ? -z : 0.0f;
    x += x >= 0.0f ? -fold : fold;
    y += y >= 0.0f ? -fold : fold;
    return vec3(x, y, z);
}

// Unit vector to where the photon came from.
static inline Vec3 stored_photon_wi(const StoredPhoton *photon)
{
    return vec3_normalize(direction_unpack_raw(photon->packed_wi));
}

// Did the photon arrive on the side of the surface that `normal` points to? Cheaper than stored_photon_wi.
static inline int stored_photon_on_side(const StoredPhoton *photon, Vec3 normal)
{
    return vec3_dot(direction_unpack_raw(photon->packed_wi), normal) > 0.0f;
}
