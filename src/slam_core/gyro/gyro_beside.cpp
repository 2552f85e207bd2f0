// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/gyro/gyro_beside.hpp"

namespace slam::gyro {

void GyroBeside::configure(Settings& settings, const std::string& sensor) {
  gyro_.configure(settings.read<ImuConfig>(), {sensor, "turns are measured without it meanwhile"});
}

/// A value that is repeated or a spin that is too fast cannot be checked in advance.
std::optional<Turn> GyroBeside::between(Stamp start, Stamp end) const {
  if (!gyro_.isProven()) return std::nullopt;
  const auto turn = gyro_.track().between(start, end);
  if (!turn || turn->is_repeated || GyroTrust::isSpin(turn->fastest)) return std::nullopt;
  const auto& calibration = gyro_.calibration();
  return Turn{calibration.angle(*turn), calibration.variance(*turn)};
}

Status GyroBeside::learn(const Motion& motion, bool is_measured) {
  constexpr bool kIsResting = false;  // what such a source measures is never exactly zero
  constexpr Duration kLongest = std::chrono::milliseconds(500);  // a robot turns half round in more
  const auto turn = gyro_.track().between(motion.start, motion.end);
  if (!is_measured || motion.end - motion.start > kLongest)
    return gyro_.pass(turn, motion, !is_measured && between(motion.start, motion.end).has_value());
  return gyro_.learn(turn, motion, gyro_.judge(turn, motion, kIsResting), kIsResting, false);
}

}  // namespace slam::gyro
