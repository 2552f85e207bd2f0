// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>

#include "slam_core/models/motion.hpp"

namespace slam::gyro {

/// Whether the gyro measures the turns that the wheels measure, as far as wheels show it: they may
/// be wrong by a factor of a few, not by one of 57 and not by the sign. While turns have not shown
/// it, what differs much is not believed; once they have, the gyro is believed over the wheels
/// until turn after turn says otherwise.
class GyroTrust {
 public:
  enum class Verdict {
    kUnproven,
    kProven,
    kTooLarge,   ///< as where it counts in degrees
    kOpposite,   ///< as where it is mounted upside down
    kUnrelated,  ///< as where it measures about another axis
  };

  /// @param gyro its turn without bias, in the interval of the wheels' motion [rad]
  /// @param bias_sigma [rad/s]
  void add(double gyro, const Motion& wheels, double bias_sigma);
  Verdict verdict() const { return verdict_; }
  /// Whether the gyro reports a spin that no robot makes unless its wheels do: such a motion tells
  /// nothing of the gyro, and is not to be added.
  /// @param rate of the gyro [rad/s]
  static bool isBurst(double rate, const Motion& wheels);
  /// Whether robots spin so fast only where their wheels turn them. @param rate [rad/s]
  static bool isSpin(double rate);
  /// Whether the gyro is to be believed for this motion, before add().
  bool believes(double gyro, const Motion& wheels, double bias_sigma) const;
  void reset() { *this = {}; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(since_vote_, block_, is_doubted_, fits_, against_, verdict_);
  }

 private:
  /// Gyro and wheels measured these turns in one interval.
  struct Turns {
    double seconds = 0.0, gyro = 0.0, wheels = 0.0;  ///< [s], [rad], [rad]
    double variance = 0.0, way = 0.0;                ///< of the wheels' turn [rad^2], [m]

    void add(double turned, const Motion& motion);
    /// The turn that wheels of unequal size may measure on a straight way [rad].
    double straight() const;
    /// The error that noise may give the wheels' turn [rad].
    double noise() const;
    /// Whether the wheels have turned beyond doubt.
    bool isTurn() const;
    bool contradict(double bias_sigma) const;

    template <class Archive>
    void persist(Archive& archive) {
      archive(seconds, gyro, wheels, variance, way);
    }
  };

  void vote();
  void voteFor(double weight);
  void voteAgainst(std::size_t kind, double weight);

  Turns since_vote_, block_;  ///< a block is the shortest time of a vote
  bool is_doubted_ = false;   ///< since a block contradicted, up to the next one that does not
  double fits_ = 0.0;         ///< turns of the wheels that the gyro has measured as well [rad]
  std::array<double, 3> against_{};  ///< and others, in the order of the verdicts
  Verdict verdict_ = Verdict::kUnproven;
};

}  // namespace slam::gyro
