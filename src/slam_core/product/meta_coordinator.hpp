// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include "slam_core/contract/odometry_source.hpp"
#include "slam_core/product/estimator.hpp"

namespace slam {

/// The whole product in one process (thesis Fig. 4.4): creates the components the product names,
/// passes raw inputs through the front-end to the estimator. Components know nothing of one
/// another.
class MetaCoordinator {
 public:
  /// A fresh start. @throw ConfigError listing the faults of all sections
  void configure(Settings& settings);

  void set(OdometrySample sample);
  /// For data that already carry what a component would make.
  void set(const Motion& motion) { estimator_.set(motion); }
  void set(const LandmarkObservationArray& observations) { estimator_.set(observations); }

  /// One step, as Estimator::execute(); a warning of the front-end comes first.
  Status execute();

  Estimator& estimator() { return estimator_; }
  const Estimator& estimator() const { return estimator_; }
  const FramesConfig& frames() const { return frames_; }
  /// Of the front-end and the estimator.
  Counters counters() const;
  std::uint64_t dropped() const;

  void reset();

 private:
  FramesConfig frames_;
  std::unique_ptr<OdometrySource> odometry_;
  Estimator estimator_;
  Status front_end_status_;
};

}  // namespace slam
