// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/weighting.hpp"

namespace slam::particle_filter {

double Weighting::logFactor(const Prediction* predictions, std::size_t matches) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < matches; ++k) sum += predictions[k].log_likelihood;
  return sum;
}

const std::vector<std::string>& weightingNames() {
  static const std::vector<std::string> kNames = {"predictive", "importance"};
  return kNames;
}

std::unique_ptr<Weighting> makeWeighting(const std::string& name) {
  if (name == "importance") return std::make_unique<ImportanceWeighting>();
  return std::make_unique<PredictiveWeighting>();
}

}  // namespace slam::particle_filter
