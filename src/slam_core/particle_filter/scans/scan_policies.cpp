// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/scans/scan_weighting.hpp"

namespace slam::particle_filter {

ScanDraft MotionScanProposal::propose(const grid_map::ScanLikelihood& likelihood,
                                      const grid_map::ScanPoints& scan,
                                      const grid_map::GridMap& map, const PoseGaussian& prior,
                                      RandomStream& random) const {
  const Pose2 pose = prior.sample(random);
  return {{pose}, likelihood.log(map, scan, pose)};
}

const std::vector<std::string>& scanProposalNames() {
  static const std::vector<std::string> kNames = {"matched", "motion"};
  return kNames;
}

const std::vector<std::string>& scanMatcherNames() {
  static const std::vector<std::string> kNames = {"hill_climbing", "correlative"};
  return kNames;
}

const std::vector<std::string>& scanWeightingNames() {
  static const std::vector<std::string> kNames = {"integral", "likelihood"};
  return kNames;
}

std::unique_ptr<ScanWeighting> makeScanWeighting(const std::string& name) {
  if (name == "likelihood") return std::make_unique<LikelihoodScanWeighting>();
  return std::make_unique<IntegralScanWeighting>();
}

}  // namespace slam::particle_filter
