// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>

#include "pose_graph.hpp"

namespace slam::eval {

/// A city like Manhattan: straight streets with crossings at equal distances, on which a robot
/// drives at random and recognises places where it was before. Its measurements have exactly the
/// noise that their information matrices state.
struct GraphWorldConfig {
  int poses = 3500;
  int block = 4;                 ///< steps of 1 m between two crossings
  int visits = 3;                ///< of each place, mean; so large is the city
  double sigma_position = 0.03;  ///< of a measurement, along and across [m]
  double sigma_heading = 0.01;   ///< of a measurement [rad]
  double loop_radius = 2.0;      ///< a place is recognised from so far [m]
  int loop_gap = 20;             ///< so many steps ago at least
  double loop_chance = 0.1;      ///< for each pose nearby that it is recognised
  int most_loops = 2;            ///< of one pose
};

/// The graph of one seed: way, loops and noise depend on it.
PoseGraph makeGraphWorld(const GraphWorldConfig& config, std::uint64_t seed);

}  // namespace slam::eval
