// Stage 5, progressive photon mapping: the contracts of its steps.
//
// A map is as large as memory, and its radius is a compromise: large, and edges blur; small, and the picture is noisy. Now
// there is one photon pass after the other, each with photons of its own, which are forgotten after it. Radii shrink from
// pass to pass, and what the passes give is averaged: blur and noise both go to 0. Two ways to say by how much to shrink:
//   a radius for the whole pass, by its number (Knaus & Zwicker 2011): 5.1, and 5.2 takes the mean
//   a radius for each pixel, by the photons that it found (Hachisuka, Ogaki & Jensen 2008; a point drawn anew in each
//   pass: Hachisuka & Jensen 2009): 5.3 and 5.4
#pragma once

#include "math/colour.h"
#include "photons/progressive.h"

// 5.1  The radius of the next pass, m, where pass number i (the first is 1) had r_i = `radius` > 0:
//          r²_{i+1} = r²_i · (i + α)/(i + 1)
// α in (0, 1] shares out what passes win: after i of them the squared noise of the mean has fallen with i^(−α), its squared blur
// with i^(2(α−1)). With 1 no radius shrinks.
float next_radius(float radius, int pass, float alpha);

// 5.2  The mean over two runs of passes, per channel: a is the mean over m passes, b over n, both ≥ 0 and one of them > 0. Every
// pass has the same weight:
//          (m·a + n·b)/(m + n)
// So a pass is added to a mean (n = 1), and what several machines have made becomes one picture.
Colour join_means(Colour a, int m, Colour b, int n);

// 5.3  What is known of a point after a pass that has found M = `found` ≥ 0 photons nearer than R, and with them the flux
// Φ = `flux` = Σ f_r·Φ_p, W/sr. The share α of the new photons stays; R shrinks so that the density (N + M)/πR² is kept, and what
// lies in the ring that is cut off leaves the flux with it:
//          N' = N + αM,  R'² = R²·(N + αM)/(N + M),  τ' = (τ + Φ)·R'²/R²
// Found nothing: all stays.
PointStatistics add_photons(PointStatistics point, int found, Colour flux, float alpha);

// 5.4  The point's radiance, W/(m²·sr), after `passes` ≥ 1 calls of 5.3:
//          L = τ/(passes · πR²)
// Each pass has shared the light's whole power out among its own photons, so that in τ there is the light of all passes.
Colour point_radiance(PointStatistics point, int passes);
