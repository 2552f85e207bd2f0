// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/mono_ekf/test/textured_room.hpp"
#include "slam_core/product/test/driven_backend.hpp"

namespace slam::test {

/// A robot on a circle in a room whose walls it sees: motion with noise, and images.
class RoomWithView final : public SimulatedDrive {
 public:
  explicit RoomWithView(std::uint64_t seed) : world_(seed), room_(seed) {}

  Pose2 give(ComponentDriver& inputs) override {
    const auto step = world_.next();
    inputs.set(step.motion);
    inputs.set(room_.look(Pose2(0.0, -4.0, 0.0) * step.truth, step.motion.end));
    return step.truth;
  }
  int stepsOfALap() const override { return SimulatedWorld::kLap; }

 private:
  SimulatedWorld world_;
  TexturedRoom room_;
};

}  // namespace slam::test
