// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>

#include "slam_core/contract/component.hpp"
#include "slam_core/gyro/gyro_bias.hpp"
#include "slam_core/gyro/gyro_noise.hpp"
#include "slam_core/gyro/gyro_track.hpp"
#include "slam_core/gyro/rest_blocks.hpp"
#include "slam_core/imu/imu_config.hpp"
#include "slam_core/models/motion.hpp"

namespace slam::gyro {

/// It estimates a gyro's bias and noise from what it measures while the wheels stand, and a little
/// from what wheels, or another odometry, measure on the way.
class GyroCalibration {
 public:
  GyroCalibration() = default;
  explicit GyroCalibration(const ImuConfig& config);

  double bias() const { return bias_.bias(); }                ///< [rad/s]
  double biasVariance() const { return bias_.variance(); }    ///< [rad^2/s^2]
  double noiseVariance() const { return noise_.variance(); }  ///< [rad^2/s]
  /// The turn without bias [rad].
  double angle(const GyroTurn& turn) const { return turn.angle - turn.seconds * bias(); }
  /// The variance of angle() [rad^2]. It has the noise (that of the messages where it is larger),
  /// the bias and the scale in it.
  double variance(const GyroTurn& turn) const;
  /// Whether a robot whose wheels stand does not turn, as far as the gyro shows.
  bool rests(const GyroTurn& turn) const;

  /// Time goes on. @param turned [rad] @param drifts the gyro gave the heading meanwhile
  void predict(double seconds, double turned, bool drifts);
  void learnAtRest(const GyroTurn& turn);
  void learnBeside(const GyroTurn& turn, const Motion& wheels);
  /// The gyro measured nothing for a while, or nothing that the calibration may learn from.
  void pause();

  template <class Archive>
  void persist(Archive& archive) {
    archive(bias_, noise_, recent_turns_, blocks_, beside_, other_);
  }

 private:
  /// A second beside the wheels.
  struct Window {
    double seconds = 0.0, gyro = 0.0, wheels = 0.0;  ///< [s], [rad], [rad]
    double way = 0.0, variance = 0.0;                ///< [m], of the wheels' turn [rad^2]
    double first_rate = 0.0, last_rate = 0.0;        ///< [rad/s]

    template <class Archive>
    void persist(Archive& archive) {
      archive(seconds, gyro, wheels, way, variance, first_rate, last_rate);
    }
  };
  /// Blocks at rest in a row that measure another bias.
  struct OtherBias {
    double seconds = 0.0, angle = 0.0, least = 0.0, most = 0.0;  ///< [s], [rad], [rad/s], [rad/s]

    template <class Archive>
    void persist(Archive& archive) {
      archive(seconds, angle, least, most);
    }
  };

  void observe(const RestRate& block);
  void contradict(const RestRate& block);

  double scale_sigma_ = 0.0;
  GyroBias bias_;
  GyroNoise noise_;
  /// Sums of recent turns to the right and to the left, which fade with a time constant of 3 s
  /// [rad]: their errors by the gyro's scale add up. What the scale makes wrong to one
  /// side is not made up for by the other: the way in between has been wrong.
  std::array<double, 2> recent_turns_{};
  RestBlocks blocks_;
  Window beside_;
  OtherBias other_;
};

/// Bias, its standard deviation, and noise, for diagnostics.
Component::Figures figuresOf(const GyroCalibration& calibration);

}  // namespace slam::gyro
