// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/policies.hpp"

#include <cmath>

namespace slam::particle_filter {
namespace {

KldSize::Limits limitsOf(const PfConfig& config) {
  KldSize::Limits limits;
  limits.min = static_cast<std::size_t>(config.min_particles);
  limits.max = static_cast<std::size_t>(config.max_particles);
  limits.error = config.kld_error;
  limits.quantile = config.kld_quantile;
  limits.bin_position = config.kld_bin_position;
  limits.bin_heading = config.kld_bin_heading;
  return limits;
}

}  // namespace

// the quantile of the chi-square distribution with two degrees of freedom has a closed form
Policies::Policies(const PfConfig& config)
    : gate(-2.0 * std::log(1.0 - config.gate_probability)),
      proposal(makeProposal(config.proposal)),
      weighting(makeWeighting(config.weighting)),
      resampling(makeResampling(config.resampling)),
      size(limitsOf(config)) {}

}  // namespace slam::particle_filter
