// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/scans/scan_weighting.hpp"

namespace slam::particle_filter {

ScanDraft MotionScanProposal::propose(const ScanInMap& scan, const PoseGaussian& prior,
                                      const std::optional<Pose2>&, RandomStream& random) const {
  const Pose2 pose = prior.sample(random);
  return {{pose}, scan.log(pose)};
}

}  // namespace slam::particle_filter
