// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <utility>

#include "slam_core/product/test/driven_backend.hpp"
#include "slam_core/rat/cell_place.hpp"

namespace slam::test {

/// A robot on a circle whose pose cells are where it is, with a view for each direction from its
/// centre. Its odometry is exact: in its first lap RatSLAM can be no better than that.
class CircleOfViews final : public SimulatedDrive {
 public:
  explicit CircleOfViews(std::uint64_t seed) : world_(seed) {}

  Pose2 give(ComponentDriver& inputs) override {
    auto step = world_.next();
    step.motion.increment = std::exchange(last_, step.truth).between(step.truth);
    rat::PoseCellState state;
    state.stamp = step.motion.end;
    state.sequence = static_cast<std::uint64_t>(count_);
    const Eigen::Vector2d from_centre = step.truth.position() - Eigen::Vector2d(0.0, 4.0);
    const double angle = std::atan2(from_centre.y(), from_centre.x()) + M_PI;
    state.view = static_cast<std::int64_t>(angle * stepsOfALap() / (2.0 * M_PI));
    state.edge = 100;
    state.headings = 36;
    state.place = {step.truth.x() + 50.0, step.truth.y() + 50.0,  // cells of 1 m
                   step.truth.theta() * 36 / (2 * M_PI) + 18.0};
    ++count_;
    inputs.set(step.motion);
    inputs.set(state);
    return step.truth;
  }
  int stepsOfALap() const override { return SimulatedWorld::kLap; }

 private:
  SimulatedWorld world_;
  Pose2 last_;
  int count_ = 0;
};

}  // namespace slam::test
