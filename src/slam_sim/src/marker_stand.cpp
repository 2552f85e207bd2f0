// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/marker_stand.hpp"

#include <cmath>

#include "slam_core/camera/camera_model.hpp"
#include "slam_core/camera/image.hpp"
#include "slam_sim/studio.hpp"

namespace slam::sim {
namespace {

constexpr std::int64_t kFramePeriod = 100000000;  // [ns]

CameraMount levelMount() {
  CameraMount mount{"camera", Eigen::Isometry3d::Identity()};
  mount.T_base_camera.linear() << 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, -1.0, 0.0;
  return mount;
}

}  // namespace

MarkerStand::MarkerStand(std::unique_ptr<LandmarkDetector> detector,
                         const CameraCalibration& calibration, const CameraOptics& optics)
    : world_(studioWorld(kFamily, kId, kSize)),
      camera_(std::make_shared<const Scene>(world_), calibration, optics),
      detector_(std::move(detector)),
      ports_(portsOf(*detector_)) {
  gate_.configure(CameraConfig());
  gate_.set(calibration);
  gate_.set(levelMount());
}

MarkerTruth MarkerStand::truth(const Eigen::Isometry3d& T_world_camera) const {
  const auto& marker = world_.markers.front();
  const Eigen::Vector3d centre =
      T_world_camera.inverse() * Eigen::Vector3d(marker.T_world_marker.translation());
  MarkerTruth truth{std::hypot(centre.x(), centre.z()), std::atan2(-centre.x(), centre.z()), {}};
  const CameraModel model(camera_.calibration());
  const auto corners = cornersOf(marker, T_world_camera);
  for (std::size_t k = 0; k < 4; ++k) truth.corners[k] = model.project(corners[k]).value();
  return truth;
}

std::optional<LandmarkObservation> MarkerStand::look(const CameraPath& T_world_camera,
                                                     std::uint64_t frame) {
  Image image;
  image.stamp = stampFromNanoseconds(static_cast<std::int64_t>(frame + 1) * kFramePeriod);
  image.frame = levelMount().camera_frame;
  image.gray = camera_.render(T_world_camera, RandomStream(1, frame));
  gate_.set(image);
  gate_.execute();
  ports_.input("camera", kindOf<CameraView>())->set(&gate_.view().value());
  detector_->execute();
  if (!detector_->observations()) return std::nullopt;
  for (const auto& observation : detector_->observations()->observations) {
    if (observation.id == kId) return observation;
  }
  return std::nullopt;
}

Eigen::Isometry3d poseBefore(double distance, double obliqueness, double aside,
                             std::uint64_t index) {
  RandomStream random(7, index);
  const auto about = [&random](double extent) { return extent * (2.0 * random.uniform() - 1.0); };
  const double near = distance * (1.0 + about(0.02));
  const double turned = obliqueness + about(0.03);
  const double x = about(0.7 * aside);
  return cameraBefore(near, turned, {x, about(0.7 * aside)});
}

}  // namespace slam::sim
