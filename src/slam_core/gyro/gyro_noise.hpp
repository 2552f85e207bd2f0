// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace slam::gyro {

/// A gyro's noise density, measured at rest as the Allan variance of mean rates is: from the
/// differences of neighbouring means, so that the bias does not matter (IEEE Std 952). What the
/// robot file says counts as some differences that have been measured.
class GyroNoise {
 public:
  GyroNoise() = default;
  /// @param density [rad/sqrt(s)]
  explicit GyroNoise(double density);

  /// Takes in the difference of two neighbouring mean rates [rad/s], each over its time [s].
  void add(double difference, double seconds_before, double seconds_after);
  /// The variance that each second adds to the angle that the gyro measures [rad^2/s].
  double variance() const { return sum_ / weight_; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(sum_, weight_);
  }

 private:
  double sum_ = 0.0, weight_ = 1.0, least_ = 0.0;
};

}  // namespace slam::gyro
