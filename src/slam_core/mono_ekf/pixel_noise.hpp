// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>

namespace slam::mono_ekf {

/// What the innovations of an update tell of the pixels' variance r: the derivative of the
/// logarithm of their likelihood N(nu; 0, S) in log r, and the Fisher information (Harville 1977).
/// Since dS / d log r = r I,
///
///     slope = r / 2 (|S^-1 nu|^2 - tr S^-1),   information = r^2 / 2 tr S^-2.
///
/// r S^-1 nu are the residuals after the update, so that the trace takes into account what the
/// state has been fitted to (Mohamed and Schwarz 1999).
struct PixelScore {
  double slope = 0.0;
  double information = 0.0;
};

/// Estimates the noise of the pixels where features are found from the innovations, by a step of
/// Fisher scoring for each update (adaptive filtering: Mehra 1970). It forgets what is older than
/// some 40 images. The estimate is between the least sigma, which stands for what linearisation
/// leaves as well, and 25 times that; it begins with five times the least one.
class PixelNoise {
 public:
  PixelNoise() = default;
  /// @param least_sigma [px]
  explicit PixelNoise(double least_sigma) : least_sigma_(least_sigma) {}

  void learn(const PixelScore& score);
  /// To be called for an image whose matches do not agree: it may be noisier than believed.
  void doubt();
  /// Standard deviation of a pixel's coordinate [px].
  double sigma() const { return least_sigma_ * std::exp(0.5 * log_factor_); }

  template <class Archive>
  void persist(Archive& archive) {
    archive(log_factor_, information_);
  }

 private:
  static constexpr double kFirstLogFactor = 3.219;  ///< of the variance: five times the sigma
  static constexpr double kFirstInformation = 4.0;  ///< as of four matches that are well predicted

  double least_sigma_ = 1.0;
  double log_factor_ = kFirstLogFactor;  ///< of the variance over its least one
  double information_ = kFirstInformation;
};

}  // namespace slam::mono_ekf
