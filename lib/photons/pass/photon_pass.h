// The photon pass: emits photons from every light, follows them, keeps those that land.
#pragma once

#include "photons/pass/trace.h"
#include "base/progress.h"
#include "steps/steps.h"

#define KEEP_DIRECT   (1u << PATH_DIRECT)
#define KEEP_CAUSTIC  (1u << PATH_CAUSTIC)
#define KEEP_INDIRECT (1u << PATH_INDIRECT)
#define KEEP_ALL      (KEEP_DIRECT | KEEP_CAUSTIC | KEEP_INDIRECT)

// Told of what happens as it happens, for those who look on. For passes on one thread.
typedef struct {
    void *user;
    void (*path)(void *user, long path); // a path begins
    // A photon comes to rest, `flown` metres after the light. It goes here alone, not into the pass.
    void (*stored)(void *user, const StoredPhoton *photon, float flown);
    // A photon, as it is when it sets out, flies to this hit; NULL: it leaves the scene.
    void (*leg)(void *user, const Photon *photon, const Hit *hit);
} PhotonRecorder;

typedef struct {
    long photons; // to emit
    int depth;    // surfaces a path may meet
    uint64_t seed;
    int threads;   // 0: all cores
    unsigned keep; // KEEP_…: which photons to store. KEEP_CAUSTIC alone: paths end at their first rough surface
    StepChoice
        play; // whose BRDF the ledger expects at glossy surfaces; the loop of 1.5, the recursion of 3.4, or single wavelengths
    bool hero;        // with wavelengths: three for a photon, until it meets dispersing glass (Wilkie et al. 2014)
    long first, last; // only the paths first…last−1 of `photons`, as they are among all of them; last 0: all
    // Bytes that have to be there for what follows the pass, in all, for each photon that is stored, and for each caustic one.
    double room, room_a_photon, room_a_caustic;
    const PhotonRecorder *recorder; // NULL: none
    Progress progress;
} PhotonPassOptions;

// Where the flux went, W per channel (0 red, 1 green, 2 blue):
//   emitted = absorbed + escaped + cut + chance, by construction;
// that `chance` (what roulette, Fresnel's choice and the lobe's weights won or lost) is 0 within a few standard errors
// is what right code adds to that. Doubles alone: so they are added up.
typedef struct {
    double emitted[3];
    double absorbed[3]; // what the surfaces' albedos take of the flux that arrives
    double escaped[3];  // left the scene
    double cut[3];      // ended by the depth limit
    double chance[3];
    double chance_error[3]; // standard error of chance
} Ledger;

// Paths that ended because a step gave a direction not of unit length. Counted as escaped.
typedef struct {
    long total;
    long at[MATERIAL_TYPES]; // by the surface that they left; MATERIAL_LIGHT: as they were emitted
    float length;            // of the first one's direction; NaN: it is no number
} UnsoundPaths;

// A bag of stored photons.
typedef struct {
    StoredPhoton *photons; // from malloc
    size_t count;
} PhotonArray;

typedef struct {
    PhotonArray caustic; // KEEP_CAUSTIC photons, apart, when direct photons are not kept as well
    PhotonArray rest;    // all others that were kept; everything in the case of KEEP_ALL
    Ledger ledger;
    long emitted; // paths traced
    size_t stored;
    uint64_t segments; // rays traced
    UnsoundPaths unsound;
    double seconds;
} PhotonPass;

// The same bytes whatever the number of threads: a random stream per photon, and chunks merged in their order. False
// on lack of memory, which shows after the first paths. Free with photon_pass_free; arrays taken over by a map must be zeroed first.
bool photon_pass_run(const Scene *scene, const PhotonPassOptions *options, PhotonPass *pass, Error *error);
void photon_pass_free(PhotonPass *pass); // its photons; the numbers stay

// Adds a later part's to the sum.
void unsound_paths_add(UnsoundPaths *sum, const UnsoundPaths *part);

// A photon from light number `index` carrying the light's whole power (library lights and step 1.2's rectangle).
Photon light_emit(const Light *light, Rng *rng);
