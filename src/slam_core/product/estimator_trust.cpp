// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

// This file judges how far the pose of an estimator is trusted, and says so.

#include "slam_core/contract/lost_reporter.hpp"
#include "slam_core/contract/without_covariance.hpp"
#include "slam_core/product/estimator.hpp"

namespace slam {

using relocalisation::Belief;

Status Estimator::watchConsistency() {
  using Fault = ConsistencyMonitor::Fault;
  const auto before = consistency_.fault();
  const auto update = statistics();
  consistency_.add(update);
  dead_reckoning_.correct(update.innovations, backend_->pose().pose);
  const auto now = consistency_.fault();
  const auto finding = consistency_.finding();
  adaptNoise();
  if (now == Fault::kNone || now == before) return Status::ok();
  return now == Fault::kLost ? Status::alarm(finding) : Status::warning(finding);
}

/// The monitor has judged the noise as it was, and begins anew with the noise as it is now.
void Estimator::adaptNoise() {
  if (consistency_config_.adapt && noise_.learn(consistency_, statistics()))
    consistency_ = ConsistencyMonitor(consistency_config_);
}

PoseEstimate Estimator::reportedPose() const {
  auto pose = backend_->pose();
  const bool contradicts_odometry = noise_.scale(ConsistencyMonitor::kMotion) > 1.0;
  pose.covariance += dead_reckoning_.covarianceAt(pose.pose);
  pose.covariance += doubt_.covarianceAt(pose.pose, contradicts_odometry);
  return relocaliser_.told(pose);
}

bool Estimator::isLostByBackend() const {
  const auto* reporter = capabilities_.find<LostReporter>();
  return reporter != nullptr && reporter->lostSince().has_value();
}

/// A back-end that has found the robot by itself has jumped there, which is no way that it drove.
void Estimator::judgeWay(bool was_lost) {
  const auto* reporter = capabilities_.find<LostReporter>();
  const bool has_jumped =
      was_lost && reporter != nullptr && reporter->findsItself() && !isLostByBackend();
  if (has_jumped)
    doubt_.relocate(backend_->pose().pose);
  else if (consistency_config_.adapt)
    doubt_.compare(backend_->pose().pose);
}

bool Estimator::isLost() const {
  const auto belief = relocaliser_.belief();
  return isLostByBackend() || belief == Belief::kLost || belief == Belief::kAnywhere;
}

std::string Estimator::doubt() const {
  using Fault = ConsistencyMonitor::Fault;
  if (isCarriedAway(relocaliser_)) return "what the laser sees has changed at once";
  if (isLost()) return "what is seen contradicts the map";
  if (relocaliser_.belief() == Belief::kUnconfirmed)
    return "the place in the loaded map has not been recognised yet";
  const auto fault = consistency_.fault();
  if (fault == Fault::kLost || fault == Fault::kBias) return consistency_.finding();
  // A pose without covariance cannot contradict what it claims.
  return isWithoutCovariance(capabilities_) ? "" : doubt_.reason();
}

Trust Estimator::trust(const std::string& doubt) const {
  if (isLost()) return Trust::kLost;
  if (!doubt.empty()) return Trust::kDoubtful;
  return isWithoutCovariance(capabilities_) ? Trust::kUnknown : Trust::kConfident;
}

}  // namespace slam
