// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/scan_weighting.hpp"

namespace slam::particle_filter {

const std::vector<std::string>& scanWeightingNames() {
  static const std::vector<std::string> kNames = {"integral", "likelihood"};
  return kNames;
}

std::unique_ptr<ScanWeighting> makeScanWeighting(const std::string& name) {
  if (name == "likelihood") return std::make_unique<LikelihoodScanWeighting>();
  return std::make_unique<IntegralScanWeighting>();
}

}  // namespace slam::particle_filter
