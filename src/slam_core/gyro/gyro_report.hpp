// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/common/counters.hpp"
#include "slam_core/common/status.hpp"
#include "slam_core/gyro/gyro_trust.hpp"

namespace slam::gyro {

/// Whether the gyro says how the robot turned during a motion, or why it does not.
enum class GyroUse { kTurn, kRest, kSilent, kStuck, kBurst, kImplausible };

/// Counts the motions for which the gyro cannot be used, by "gyro_silent", "gyro_stuck" and
/// "gyro_implausible", and reports each reason once, until the gyro has measured a turn again. A
/// silent gyro is reported after a second.
class GyroReport {
 public:
  GyroReport() = default;
  /// @param other what measures turns as well, as "the wheels"
  /// @param instead a sentence on what is used without the gyro
  GyroReport(std::string other, std::string instead);

  void reset();
  Status add(const Motion& motion, GyroUse use, GyroTrust::Verdict verdict, bool has_measured_turn);
  const Counters& counters() const { return counters_; }

  template <class Archive>
  void persist(Archive& archive) {
    archive(said_, silent_for_, counters_);
  }

 private:
  void count(GyroUse use);
  std::string sentenceOf(GyroUse use, GyroTrust::Verdict verdict) const;

  std::string other_, instead_;
  GyroUse said_ = GyroUse::kTurn;  ///< what was reported last; kTurn: nothing
  Duration silent_for_{};
  Counters counters_;
};

}  // namespace slam::gyro
