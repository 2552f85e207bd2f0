// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/meta_coordinator.hpp"

#include <utility>

namespace slam {

void MetaCoordinator::configure(Settings& settings) {
  parts_ = makeComponents(settings);
  front_end_status_ = Status::ok();
}

void MetaCoordinator::set(OdometrySample sample) {
  if (!parts_.odometry->usesWheels()) return;
  parts_.frames.complete(sample.odometry_frame, sample.base_frame);
  parts_.odometry->set(sample);
  takeMotions();
}

template <class Input>
void MetaCoordinator::setForOdometry(const Input& input) {
  if (!parts_.odometry->usesImages()) return;
  parts_.odometry->set(input);
  takeMotions();
}

template void MetaCoordinator::setForOdometry(const Image&);
template void MetaCoordinator::setForOdometry(const CameraCalibration&);
template void MetaCoordinator::setForOdometry(const CameraMount&);

void MetaCoordinator::takeMotions() {
  do {
    note(parts_.odometry->execute());
    auto motion = parts_.odometry->motion();
    if (!motion) continue;
    parts_.frames.complete(motion->odometry_frame, motion->base_frame);
    set(*motion);
    if (on_motion) on_motion(*motion);
  } while (parts_.odometry->isBusy());
}

void MetaCoordinator::set(const Motion& motion) {
  parts_.estimator.set(motion);
  if (parts_.point_map) parts_.point_map->set(motion);
}

Status MetaCoordinator::set(const MapState& map) {
  const auto status = parts_.estimator.set(map);
  if (parts_.point_map && status.level != Status::Level::kError) parts_.point_map->reset();
  return status;
}

template <class Input>
void MetaCoordinator::setForDetector(const Input& input) {
  if (!parts_.detector) return;
  parts_.detector->set(input);
  const auto& array = parts_.detector->observations();
  do {
    note(parts_.detector->execute());
    if (array) parts_.estimator.set(*array);
    if (array && on_detections) on_detections(*array);
  } while (array);
}

template void MetaCoordinator::setForDetector(const Image&);
template void MetaCoordinator::setForDetector(const CameraCalibration&);
template void MetaCoordinator::setForDetector(const CameraMount&);

void MetaCoordinator::set(LaserSweep sweep) {
  if (!usesScans()) return;
  parts_.laser.set(std::move(sweep));
  takeScans();
}

void MetaCoordinator::set(const LaserMount& mount) {
  parts_.laser.set(mount);
  takeScans();
}

void MetaCoordinator::takeScans() {
  const auto& scan = parts_.laser.scan();
  do {
    note(parts_.laser.next());
    if (scan) parts_.estimator.set(*scan);
    if (scan && parts_.point_map) parts_.point_map->set(*scan);
  } while (scan);
}

void MetaCoordinator::note(const Status& status) {
  if (!status.isOk()) front_end_status_ = status;
}

Status MetaCoordinator::execute() {
  const auto status = parts_.estimator.execute();
  if (parts_.point_map) updatePointMap();
  const auto front_end_status = std::exchange(front_end_status_, Status::ok());
  return front_end_status.isOk() ? status : front_end_status;
}

void MetaCoordinator::updatePointMap() {
  auto& map = *parts_.point_map;
  if (const auto& report = parts_.estimator.report()) {
    map.set(point_map::FilterPose::of(report->stamp, report->pose.pose));
    return;
  }
  do note(map.execute());
  while (map.isBusy());
}

Counters MetaCoordinator::counters() const {
  Counters all = parts_.estimator.counters();
  const auto add = [&](const std::string& prefix, const Counters& part) {
    for (const auto& [reason, count] : part.all()) all.add(prefix + reason, count);
  };
  add("odometry_", parts_.odometry->counters());
  if (parts_.detector) add("detector_", parts_.detector->counters());
  add("laser_", parts_.laser.counters());
  if (parts_.point_map) add("pointmap_", parts_.point_map->counters());
  return all;
}

std::uint64_t MetaCoordinator::dropped() const {
  const auto& odometry = parts_.odometry->counters();
  const auto late_images = parts_.detector ? parts_.detector->counters()["late"] : 0;
  return parts_.estimator.dropped() + odometry["late"] + odometry["invalid"] + late_images;
}

void MetaCoordinator::reset() {
  parts_.odometry->reset();
  if (parts_.detector) parts_.detector->reset();
  parts_.laser.reset();
  if (parts_.point_map) parts_.point_map->reset();
  parts_.estimator.reset();
  front_end_status_ = Status::ok();
}

}  // namespace slam
