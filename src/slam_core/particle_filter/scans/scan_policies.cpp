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

}  // namespace slam::particle_filter
