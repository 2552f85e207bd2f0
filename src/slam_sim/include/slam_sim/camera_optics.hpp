// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace slam::sim {

/// What makes a camera's picture worse than a perfect projection.
struct CameraOptics {
  double exposure = 0.01;        ///< [s]; the image's stamp is its middle
  double rolling_shutter = 0.0;  ///< the last row is exposed so much later than the first [s]; the
                                 ///< image's stamp is the middle of the middle row's exposure
  double brightness = 1.0;       ///< of the whole image; 1: white paper under a lamp is about 230
  double vignetting = 0.3;       ///< part of the light that is lost in the corners [0, 1]
  double defocus_sigma = 0.0;    ///< standard deviation of a Gaussian blur [px], 0 none
  double noise_sigma = 3.0;      ///< standard deviation of a pixel's additive noise [of 255]
  int samples = 8;               ///< rays a pixel, spread over its area and over the exposure
};

}  // namespace slam::sim
