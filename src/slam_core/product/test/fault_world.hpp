// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <utility>
#include <vector>

#include "slam_core/product/test/faulty_link.hpp"
#include "slam_core/product/test/product_drives.hpp"

namespace slam::test {

/// What the sensors of a simulated robot send, for a whole product or for its back-end alone, and
/// where the robot is.
class FaultWorld {
 public:
  static constexpr double kSecondsOfStep = 0.1;
  using Truths = std::map<Stamp, Pose2>;

  /// @param is_whole wheels and laser send what drivers send, else motion and scans
  FaultWorld(std::uint64_t seed, bool has_scans, bool is_whole)
      : world_(seed, landmarks(seed)), room_(seed), has_scans_(has_scans), is_whole_(is_whole) {}

  /// @return the messages before the drive: the laser's mount, and where the odometry begins
  std::vector<ProductInput> begin() const {
    if (!is_whole_) return {};
    auto first = world_;
    auto first_in_room = room_;
    const auto motion = has_scans_ ? first_in_room.next().motion : first.next().motion;
    std::vector<ProductInput> inputs;
    if (has_scans_)
      inputs.push_back(
          [mount = laserMount()](MetaCoordinator& product) { product.put("scan", mount); });
    inputs.push_back([begin = odometryAt(motion.start, motion.odometry_start)](
                         MetaCoordinator& product) { product.set(begin); });
    return inputs;
  }

  std::vector<Message> next() {
    if (has_scans_) {
      const auto step = room_.next();
      note(step.motion.end, step.truth);
      if (is_whole_) return {odometryOf(step.motion), sweepOf(step.scan)};
      return {step.motion, step.scan};
    }
    const auto step = world_.next();
    note(step.motion.end, step.truth);
    if (is_whole_) return {odometryOf(step.motion), step.observations};
    return {step.motion, step.observations};
  }

  const Pose2& truth() const { return truths_.rbegin()->second; }
  /// @return the true poses of the last minutes
  const Truths& truths() const { return truths_; }

 private:
  /// In no order and of no symmetry: without ids two places must not look alike.
  static std::map<LandmarkId, Eigen::Vector2d> landmarks(std::uint64_t seed) {
    constexpr LandmarkId kMost = 20;
    RandomStream random(seed, 3);
    std::map<LandmarkId, Eigen::Vector2d> all;
    for (LandmarkId id = 0; id < kMost; ++id)
      all[id] = {8.0 - 16.0 * random.uniform(), 12.0 - 16.0 * random.uniform()};
    return all;
  }
  static LaserMount laserMount() {
    LaserMount mount{"laser", Eigen::Isometry3d::Identity()};
    const auto pose = RoomDrive::sensorPose();
    mount.T_base_laser.translation() << pose.x(), pose.y(), 0.3;
    mount.T_base_laser.rotate(Eigen::AngleAxisd(pose.theta(), Eigen::Vector3d::UnitZ()));
    return mount;
  }
  static OdometrySample odometryOf(const Motion& motion) {
    return odometryAt(motion.end, motion.odometry_end);
  }
  void note(Stamp stamp, const Pose2& truth) {
    constexpr std::size_t kMost = 3000;
    truths_[stamp] = truth;
    if (truths_.size() > kMost) truths_.erase(truths_.begin());
  }

  SimulatedWorld world_;
  RoomDrive room_;
  bool has_scans_, is_whole_;
  Truths truths_;
};

}  // namespace slam::test
