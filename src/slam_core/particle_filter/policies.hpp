// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>

#include "slam_core/particle_filter/kld_size.hpp"
#include "slam_core/particle_filter/pf_config.hpp"
#include "slam_core/particle_filter/proposal.hpp"
#include "slam_core/particle_filter/resampling.hpp"
#include "slam_core/particle_filter/weighting.hpp"

namespace slam::particle_filter {

/// What varies from one particle filter to another, as a configuration has it.
struct Policies {
  Policies() : Policies(PfConfig()) {}
  /// @param config is valid
  explicit Policies(const PfConfig& config);

  double gate;  ///< largest squared Mahalanobis distance of an observation that counts
  RangeBearingModel model;
  std::unique_ptr<Proposal> proposal;
  std::unique_ptr<Weighting> weighting;
  std::unique_ptr<Resampling> resampling;
  KldSize size;
};

}  // namespace slam::particle_filter
