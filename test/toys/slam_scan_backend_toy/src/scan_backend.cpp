// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "scan_backend.hpp"

#include <cmath>
#include <utility>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam_toy {
namespace {

const slam::Registrar<slam::Backend, ScanBackend> kRegistrar("scan_toy");
const slam::SectionRegistrar<ScanBackendConfig> kSectionRegistrar;

constexpr double kArm = 1.0;  // a turn of 1 rad is as far as this [m]

/// `first`, and `second` from there on.
slam::PoseEstimate composed(const slam::PoseEstimate& first, const Alignment& second) {
  Eigen::Matrix3d J_first, J_second;
  slam::PoseEstimate sum;
  sum.pose = first.pose.compose(second.pose, &J_first, &J_second);
  const Eigen::Matrix3d P = J_first * first.covariance * J_first.transpose() +
                            J_second * second.covariance * J_second.transpose();
  sum.covariance = 0.5 * (P + P.transpose());
  return sum;
}

}  // namespace

void ScanBackendConfig::describe(slam::Fields& fields) {
  fields.add("mode", &mode, slam::backendModeNames(),
             "add key scans, or keep those that there are");
  fields
      .add("key_distance", &key_distance,
           "a scan that is further than this from all key scans becomes one; 1 rad counts as 1 m")
      .unit("m")
      .in(slam::Range::above(0));
  fields.add("initial_sigma", &initial_sigma, "standard deviation of the first pose")
      .unit("m, rad")
      .in(slam::Range::above(0));
}

void ScanBackend::configure(slam::Settings& settings) {
  config_ = settings.read<ScanBackendConfig>();
  reset();
}

void ScanBackend::describe(slam::Ports& ports) {
  ports.takes<slam::LaserScan>("scan", "laser scans", this);
}

void ScanBackend::reset() {
  estimate_ = {{}, std::pow(config_.initial_sigma, 2) * Eigen::Matrix3d::Identity()};
  keys_.clear();
  last_.reset();
  twist_.setZero();
  counters_.clear();
  scan_.reset();
  initial_pose_.reset();
}

slam::Status ScanBackend::execute() {
  if (initial_pose_) estimate_ = *std::exchange(initial_pose_, std::nullopt);
  if (const auto scan = std::exchange(scan_, std::nullopt)) return take(*scan);
  return slam::Status::ok();
}

slam::Status ScanBackend::take(const slam::LaserScan& scan) {
  const auto points = pointsOf(scan);
  const double dt = last_ ? slam::seconds(scan.stamp - *last_) : 0.0;
  last_ = scan.stamp;
  const auto before = estimate_.pose;
  const auto assumed = composed(estimate_, coasted(twist_, dt));
  const auto* key = nearestTo(assumed.pose);
  const bool had_key = key != nullptr;
  const auto found =
      key ? align(key->points, points, key->place.pose.between(assumed.pose)) : std::nullopt;
  estimate_ = found ? composed(key->place, *found) : assumed;
  if (dt > 0.0) twist_ = before.between(estimate_.pose).log() / dt;
  if (!points.empty() && isKey(key, found.has_value())) keys_.push_back({estimate_, points});
  if (found || !had_key) return slam::Status::ok();
  counters_.add("coasted");
  return slam::Status::warning(
      "a scan could not be aligned with those before: the robot is taken to have gone on at its "
      "last velocity");
}

bool ScanBackend::isKey(const KeyScan* nearest, bool is_aligned) const {
  if (nearest == nullptr) return true;
  return is_aligned && config_.mode == slam::BackendMode::kSlam &&
         distance(nearest->place.pose, estimate_.pose) > config_.key_distance;
}

double ScanBackend::distance(const slam::Pose2& a, const slam::Pose2& b) const {
  const auto step = a.between(b);
  return std::hypot(step.position().norm(), kArm * step.theta());
}

const ScanBackend::KeyScan* ScanBackend::nearestTo(const slam::Pose2& pose) const {
  const KeyScan* best = nullptr;
  for (const auto& key : keys_)
    if (!best || distance(key.place.pose, pose) < distance(best->place.pose, pose)) best = &key;
  return best;
}

}  // namespace slam_toy
