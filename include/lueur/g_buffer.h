// SPDX-License-Identifier: MIT
// What an engine knows of a view's visible surfaces.
#pragma once

#include "lueur/image.h"
#include "lueur/view.h"

namespace lueur {

// A view's G-buffer, all images of one extent W x H from 1x1 to the device's limit. The first three
// are always needed; what else a technique and its settings need is told by the technique.
struct GBuffer {
  Image depth;   // d32f or r32f: as the view's projection yields it; cleared where nothing is
  Image normal;  // two channels, [-1, 1]: unit normal in world space, octahedral (see
                 // shading/packing.h)
  // rgba16f or rgba32f, alpha ignored: diffuse outgoing radiance, i.e. albedo x direct irradiance
  // / pi + emission. No specular reflection, no fog, no sky: what is not a surface has to be 0.
  Image source;
  // rgba16f: radiance that `source` has by emission alone. Invalid: nothing emits.
  Image emission;
  // rg16f, UV: where the point is now minus where it was in the previous frame.
  Image motion;
  // rgba16f, alpha ignored: diffuse albedo, what further bounces are multiplied with. Black for
  // what shall not pass on light.
  Image albedo;
  // rgba16f. rgb: specular reflectance at normal incidence, linear. a from 0 to 1: a GGX lobe of
  // this perceptual roughness; a = -1 - i: the cosine lobe i of Inputs::lobes, of which rgb is the
  // colour; i is at most 2046, as half floats count no further.
  Image reflectance;
  // r8: 0 for what stands still, (i + 1) / 255 for object i of Host::objects(). Invalid: nothing
  // moves.
  Image object;
};

// A cosine lobe: the light's direction is mirrored by the coefficients in the surface's frame (z is
// the normal), and
//   f = rgb (n + 2) / (2 pi m^n) max(c_xy (l_x v_x + l_y v_y) + c_z l_z v_z, 0)^n,
//   m = max(|c_xy|, |c_z|).
// Coefficients -1 and 1 are Phong's lobe, others the isotropic ones of Lafortune et al. 1997.
struct CosineLobe {
  float exponent = 1.0f;  // n
  float c_xy = -1.0f;
  float c_z = 1.0f;
};

}  // namespace lueur
