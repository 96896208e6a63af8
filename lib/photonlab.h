// photonlab: photon mapping to learn from.
//
// What happens, from a scene to a picture, and where to read it:
//
//   scene file ──▶ Scene ──▶ photon pass ──▶ PhotonMap ──▶ eye pass ──▶ Image ──▶ PNG
//
//   scene/    materials, lights, a camera; file/: out of YAML and OBJ; bvh/: the tree of boxes that finds what a ray meets
//   photons/  photons in flight and at rest, and the kd-tree that finds those near a point (photon_map.h)
//     pass/   lights emit photons, which bounce and land (trace.h: one path; photon_pass.h: all of them)
//   render/   eye rays find surfaces through the pixels, the map tells how much light arrives there; passes/: again and again
//   image/    pictures, in memory and in files, and how far one is from another
//   steps/    the parts that you write: one function each, called through the table `steps`
//   math/     vectors, colours, random numbers
//   base/     errors, files, text, threads
//   preview/  the live preview; the program's, not the library's
//   cli/      the program `photonlab`, one file per subcommand
//
// README.md in this folder says which of these includes which, and where to find what.
//
// Conventions, everywhere:
//   Metres, watts, linear RGB. Radiance L in W/(m²·sr), flux Φ in W, irradiance E in W/m².
//   At a surface, wi points to where light comes from and wo to where it goes; a photon's `direction` is the way it flies,
//   so wi = −direction. Normals in a Hit face the side the ray came from.
//   Vectors are unit length where they are called a direction or a normal.
//   Functions that can fail return false or NULL and explain themselves in an Error. The library never prints or exits.
//   The same seed gives the same bytes, whatever the number of threads.
#pragma once

#include "base/error.h"    // Error, error_set
#include "base/parallel.h" // parallel_threads, clock_seconds
#include "base/progress.h" // Progress

#include "math/colour.h" // Colour, colour_…
#include "math/frame.h"  // Frame, frame_about, frame_to_world
#include "math/ray.h"    // Ray, Box
#include "math/rng.h"    // Rng, rng_create, rng_float
#include "math/vec3.h"   // Vec3, vec3_…

#include "scene/camera.h"          // Camera, camera_ray
#include "scene/glass_catalogue.h" // glass_find, glass_index, cauchy_index
#include "scene/light.h"           // Light, light_sample
#include "scene/material.h"        // Material, material_brdf, material_albedo
#include "scene/spectrum.h"        // Spectrum, spectral_colour, reflectance_at
#include "scene/scene.h"           // Scene, scene_load, scene_intersect, scene_occluded
#include "scene/bvh/shape.h"       // Flat, Sphere

#include "photons/gather.h"           // Gather, gather_near
#include "photons/photon.h"           // Photon, StoredPhoton
#include "photons/photon_map.h"       // PhotonMap, photon_map_build, photon_map_nearest
#include "photons/pass/photon_pass.h" // PhotonPass, photon_pass_run, Ledger
#include "photons/pass/trace.h"       // photon_fly, photon_store

#include "render/gather/gather_trace.h" // gather_send, gather_meet, gather_irradiance
#include "render/passes/passes.h"       // Passes, passes_run
#include "render/render.h"              // RenderOptions, render_image

#include "image/difference.h" // image_difference
#include "image/image.h"      // Image, image_read, image_write

#include "steps/steps.h" // steps, steps_load: reflect, emit_photon, scatter_diffuse, …
