// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/particle_filter/scans/scan_proposal.hpp"

namespace slam::particle_filter {

/// The factor on a particle's weight that a scan leads to, as a logarithm: what Weighting is for
/// landmarks. For several threads at once.
class ScanWeighting {
 public:
  virtual ~ScanWeighting() = default;
  virtual double logFactor(const ScanInMap& scan, const ScanDraft& draft) const = 0;
};

/// The likelihood of the scan at the middle of the proposal, given the particle's map (thesis 5.7).
class LikelihoodScanWeighting final : public ScanWeighting {
 public:
  double logFactor(const ScanInMap& scan, const ScanDraft& draft) const override {
    return scan.log(draft.pose.mean);
  }
};

/// The integral over all poses that the motion may have led to (Grisetti, Stachniss, Burgard 2007,
/// Eq. 12): it does not depend on the pose drawn, which leaves the least variance to the weights.
class IntegralScanWeighting final : public ScanWeighting {
 public:
  double logFactor(const ScanInMap&, const ScanDraft& draft) const override {
    return draft.log_evidence;
  }
};

}  // namespace slam::particle_filter
