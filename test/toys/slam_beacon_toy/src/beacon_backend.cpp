// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "beacon_backend.hpp"

#include <cmath>
#include <utility>

#include "slam_core/common/config_error.hpp"
#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"

// Symbols: x pose and P its covariance, Q that of the motion, z range, nu innovation and S its
// variance, H Jacobian of the range, W gain.

namespace slam_toy {
namespace {

const slam::Registrar<slam::Backend, BeaconBackend> kRegistrar("beacon_toy");
const slam::SectionRegistrar<BeaconConfig> kSectionRegistrar;

constexpr double kNearest = 0.01;  // a beacon nearer than this has no direction [m]

}  // namespace

void BeaconConfig::describe(slam::Fields& fields) {
  fields.add("mode", &mode, slam::backendModeNames(),
             "the beacons are the map and known: both mean the same");
  fields.add("beacons", &beacons, "id, x, y of one beacon after the other, in the map frame")
      .unit("1, m, m");
  fields.add("gate", &gate, "a range is left out whose normalised innovation is larger")
      .unit("1")
      .in(slam::Range::above(0));
  fields.add("initial_sigma", &initial_sigma, "standard deviation of the first pose")
      .unit("m, rad")
      .in(slam::Range::above(0));
}

std::map<std::uint32_t, Eigen::Vector2d> BeaconConfig::positions() const {
  if (beacons.empty() || beacons.size() % 3 != 0)
    throw slam::ConfigError("beacon_toy.beacons has " + std::to_string(beacons.size()) +
                            " values; give three of each beacon: id, x, y");
  std::map<std::uint32_t, Eigen::Vector2d> positions;
  for (std::size_t i = 0; i < beacons.size(); i += 3) {
    const double id = beacons[i];
    const bool is_id = id >= 0 && id <= UINT32_MAX && id == std::floor(id);
    const bool is_new = is_id && positions.emplace(id, Eigen::Vector2d(&beacons[i + 1])).second;
    if (!is_new)
      throw slam::ConfigError("beacon_toy.beacons: value " + std::to_string(i + 1) +
                              " is no id, or that of another beacon; give each a whole number");
  }
  return positions;
}

void BeaconBackend::configure(slam::Settings& settings) {
  config_ = settings.read<BeaconConfig>();
  beacons_ = config_.positions();
  reset();
}

void BeaconBackend::describe(slam::Ports& ports) {
  ports.takes<slam::Motion>("motion", "motion", this).carrier();
  ports.takes<BeaconRanges>("beacons", "ranges to beacons", this);
}

void BeaconBackend::reset() {
  estimate_ = {{}, std::pow(config_.initial_sigma, 2) * Eigen::Matrix3d::Identity()};
  counters_.clear();
  motions_.clear();
  seen_.reset();
  initial_pose_.reset();
}

slam::Status BeaconBackend::execute() {
  if (initial_pose_) estimate_ = *std::exchange(initial_pose_, std::nullopt);
  for (const auto& motion : std::exchange(motions_, {})) predict(motion);
  if (const auto seen = std::exchange(seen_, std::nullopt))
    for (std::size_t i = 0; i < seen->ids.size(); ++i)
      take(seen->ids[i], seen->ranges[i], seen->sigma);
  return slam::Status::ok();
}

void BeaconBackend::predict(const slam::Motion& motion) {
  Eigen::Matrix3d J_x, J_u;
  estimate_.pose = estimate_.pose.compose(motion.increment, &J_x, &J_u);
  estimate_.covariance =
      (J_x * estimate_.covariance * J_x.transpose() + J_u * motion.covariance * J_u.transpose())
          .eval();
}

void BeaconBackend::take(std::uint32_t id, double z, double sigma) {
  const auto known = beacons_.find(id);
  if (known == beacons_.end())
    counters_.add("unknown");
  else
    correct(known->second, z, sigma);
}

void BeaconBackend::correct(const Eigen::Vector2d& beacon, double z, double sigma) {
  auto& [pose, P] = estimate_;
  const Eigen::Vector2d from_beacon = pose.position() - beacon;
  const double z_predicted = std::max(from_beacon.norm(), kNearest);
  const Eigen::RowVector3d H(from_beacon.x() / z_predicted, from_beacon.y() / z_predicted, 0.0);
  const double nu = z - z_predicted;
  const double S = H * P * H.transpose() + sigma * sigma;
  if (nu * nu / S > config_.gate) return counters_.add("gated");
  const Eigen::Vector3d W = P * H.transpose() / S;
  pose = slam::Pose2::fromVector(pose.vector() + W * nu);
  const Eigen::Matrix3d I_WH = Eigen::Matrix3d::Identity() - W * H;
  P = (I_WH * P * I_WH.transpose() + W * (sigma * sigma) * W.transpose()).eval();
  P = (0.5 * (P + P.transpose())).eval();  // else what rounding adds grows
}

}  // namespace slam_toy
