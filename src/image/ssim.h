// SPDX-License-Identifier: MIT
// Structural similarity: Wang, Bovik, Sheikh, Simoncelli, "Image Quality Assessment: From Error
// Visibility to Structural Similarity", IEEE Transactions on Image Processing 13(4), 2004.
#pragma once

#include "image/image.h"

namespace lueur {

// For each pixel, with means m, variances v and the covariance w of test (t) and reference (r)
// under an 11x11 Gaussian window of 1.5 pixels standard deviation:
//
//   (2 m_t m_r + C1) (2 w + C2) / ((m_t^2 + m_r^2 + C1) (v_t + v_r + C2))
//   C1 = 0.01^2, C2 = 0.03^2
//
// 1 for equal windows, less otherwise, down to -1. Both pictures are display-referred luma in
// [0, 1], one channel, of the same size. The picture is not scaled down first. differs: windows
// that reach over the border repeat the outermost pixels, the paper leaves them out; so each pixel
// has a value, and pictures smaller than a window too. Symmetric in its arguments.
ImageF ssim_map(const ImageF& test_luma, const ImageF& reference_luma);

}  // namespace lueur
