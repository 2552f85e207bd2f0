// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "slam_core/grid_map/scan_likelihood.hpp"

namespace slam::grid_map {

struct ScanMatch {
  Pose2 pose;              ///< T_map_base
  double log_value = 0.0;  ///< of the objective there
};

/// Finds where the objective is largest. For several threads at once.
class ScanMatcher {
 public:
  virtual ~ScanMatcher() = default;
  virtual ScanMatch match(const MatchObjective& objective) const = 0;
};

/// From the prior to the next place that none of its neighbours beats, in steps that are halved as
/// long as none helps (as of Grisetti, Stachniss, Burgard 2007). Cheap, and as good as the prior is
/// near.
class HillClimbing final : public ScanMatcher {
 public:
  struct Steps {
    double position = 0.05;  ///< the first [m]
    double heading = 0.03;   ///< the first [rad]
    int halvings = 5;
  };
  explicit HillClimbing(const Steps& steps) : steps_(steps) {}
  ScanMatch match(const MatchObjective& objective) const override {
    return from(objective.prior(), objective);
  }
  ScanMatch from(const Pose2& start, const MatchObjective& objective) const;

 private:
  Steps steps_;
};

/// The best place in a window, whatever lies between it and the prior, then climbed from there: all
/// headings and places of a lattice, of which whole squares are ruled out by a table of lower
/// resolution (Olson 2009). For odometry that slips by more than hill climbing finds back from.
class CorrelativeMatching final : public ScanMatcher {
 public:
  struct Window {
    double position = 0.3;  ///< half of its edge [m]
    double heading = 0.2;   ///< half of its angle [rad]
  };
  CorrelativeMatching(const Window& window, const HillClimbing::Steps& steps)
      : window_(window), climbing_(steps) {}
  ScanMatch match(const MatchObjective& objective) const override;

 private:
  Window window_;
  HillClimbing climbing_;
};

}  // namespace slam::grid_map
