// What students' code left behind for the preview: photons at rest and legs of paths, and the directions of a lobe. Views
// draw it; where it comes from, a process or a file, they do not know.
#pragma once

#include "photons/irradiance.h"
#include "photons/pass/photon_pass.h"
#include "steps/steps.h"

// What students' code is run for.
typedef enum {
    RUN_PHOTONS,   // a Recording
    RUN_LOBE,      // Findings: LobeSample…
    RUN_ESTIMATES, // Findings: IrradianceEstimate…, those that a gathered picture needs
    RUN_DISKS,     // Findings: ShrinkingDisk…
    RUN_RENDER     // a picture that comes pass by pass
} RunKind;

// A photon at rest, and how far it had flown since the light, m: what lets photons appear in order of flight.
typedef struct {
    StoredPhoton at;
    float flown;
} RecordedPhoton;

typedef enum {
    LEG_SURFACE, // ends at a surface, and what happened there shows in the next leg, if there is one
    LEG_LIGHT,   // ends at a light, which absorbs it
    LEG_ESCAPED  // leaves the scene; drawn for a while
} LegEnd;

// One straight part of a path. The legs of a path follow each other in the order of flight; where a photon split, a
// child's legs come before those of the next child.
typedef struct {
    Vec3 from, to; // m
    Colour power;  // W, carried along this leg
    float flown;   // at `from`, m
    uint32_t path; // number of the emitted photon
    uint16_t bounce;
    uint8_t colour; // PhotonColour
    uint8_t end;    // LegEnd
} PathLeg;

static inline float leg_length(const PathLeg *leg)
{
    return vec3_length(vec3_sub(leg->to, leg->from));
}

// Of one photon pass.
typedef struct {
    RecordedPhoton *photons; // in the order of the paths: any first part is a fair sample
    size_t count;
    PathLeg *legs; // of the first `recorded` paths
    size_t leg_count;
    long recorded, emitted;
    int bounces; // the most that a photon had met
    Ledger ledger;
    uint64_t segments;
    UnsoundPaths unsound;
    long redraw_caps;
    double seconds;  // from the request until all was there
    double farthest; // that any of the photons and legs had flown, m
    StepState states[STEP_COUNT];
    StepChoice play;
} Recording;

// Fills in `farthest`, and `bounces` as far as its photons tell.
void recording_measure(Recording *recording);
// Photons out of a file, see photon_numbers.h, which may hold anything: one that is not well formed is refused, photons
// that cannot be drawn (no numbers, no such material) are left out.
bool recording_read(const char *path, const Scene *scene, Recording *recording, Error *error);
void recording_free(Recording *recording);
// What another part of the pass counted; its photons and legs are not.
void recording_add_books(Recording *sum, const Recording *part);

// What a scatter step answered about one lobe; a weight of 0 stands for a photon that was absorbed.
typedef struct {
    Vec3 direction;
    float weight;
} LobeSample;

// Where progressive photon mapping (stage 5) looks for photons, at a pixel of a small picture, pass after pass.
#define DISK_PASSES 64
typedef struct {
    Vec3 position, normal;         // a rough surface, seen through the pixel's middle
    float radius[DISK_PASSES + 1]; // after so many passes, m
} ShrinkingDisk;

// What a run found that is no photon; items of the type that RunKind names.
typedef struct {
    void *items;
    size_t count;
} Findings;
void findings_free(Findings *findings);
