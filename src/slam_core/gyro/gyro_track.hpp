// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "slam_core/common/counters.hpp"
#include "slam_core/models/imu_sample.hpp"

namespace slam::gyro {

/// A turn about the vertical as a gyro measured it, its bias included.
struct GyroTurn {
  struct Piece {
    double seconds = 0.0;
    double angle = 0.0;  ///< [rad]
  };
  std::vector<Piece> pieces;    ///< one after the other
  double seconds = 0.0;         ///< of all pieces
  double angle = 0.0;           ///< of all pieces [rad]
  double given_variance = 0.0;  ///< of the angle, by the messages' covariances [rad^2]; 0: none
  double fastest = 0.0;         ///< the largest rate of the samples, with its sign [rad/s]
  bool is_repeated = false;     ///< of one value that came again and again, since before the turn
};

/// The last samples of a gyro, from which the turn between any two stamps follows: the rate is
/// linear between two samples.
///
/// Counted: "gyro_late" samples, not newer than the one before; "gyro_stamp_jump", stamped more
/// than kStampJump away, which counts once the next one is there as well.
class GyroTrack {
 public:
  void add(const ImuSample& sample, Counters& counters);
  void clear() { *this = {}; }
  /// Drops readings that no turn after this stamp needs.
  void forgetBefore(Stamp stamp);

  /// The stamp of the newest sample.
  std::optional<Stamp> end() const;
  /// The turn between two stamps. It is empty where the samples leave a hole in between.
  std::optional<GyroTurn> between(Stamp start, Stamp end) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(readings_, odd_);
  }

 private:
  struct Reading {
    Stamp stamp;
    double rate = 0.0;        ///< about the vertical [rad/s]
    double variance = 0.0;    ///< of the rate, as the driver gives it [rad^2/s^2]; 0: none
    Stamp same_since;         ///< the first of the samples in a row that have this rate
    std::size_t repeats = 0;  ///< how many of them came before this one

    template <class Archive>
    void persist(Archive& archive) {
      archive(stamp, rate, variance, same_since, repeats);
    }
  };

  static Reading readingOf(const ImuSample& sample);
  void append(Reading reading);

  std::deque<Reading> readings_;
  std::optional<Reading> odd_;  ///< whose stamp jumped, until another confirms it
};

}  // namespace slam::gyro
