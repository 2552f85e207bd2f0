// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/point_map/point_map.hpp"

#include <cmath>
#include <utility>

#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/point_map/pcd_file.hpp"

namespace slam::point_map {
namespace {

const Registrar<MapModule, PointMap> kRegistrar("pointmap");
const SectionRegistrar<PointMapConfig> kSectionRegistrar;

}  // namespace

void PointMap::describe(Ports& ports) {
  ports.takes<LaserScan>("scan", "laser scans", this);
  ports.takes<Motion>("motion", "motion", this).carrier();
  ports.takes<FilterPose>("pose", "the back-end's pose", this);
  ports.makes<PointMap>("points", [this] { return is_busy_ ? this : nullptr; });
}

void PointMap::configure(Settings& settings) {
  config_ = settings.read<PointMapConfig>();
  fusion_ = makeFusion(config_);
  reset();
}

void PointMap::reset() {
  gap_.reset();
  collator_ = PoseCollator();
  counters_.clear();
  fault_.clear();
  stamp_ = Stamp();
  is_busy_ = false;
  begin();
}

void PointMap::begin() {
  points_.clear();
  fusion_->reset();
  ++revision_;
}

void PointMap::set(Motion motion) {
  const auto fault = faultOf(motion);
  if (fault.empty()) {
    const auto bridge = gap_.bridge(motion);
    if (bridge == MotionGap::Bridge::kByPoses) counters_.add("bridged");
    if (bridge == MotionGap::Bridge::kByVelocity) counters_.add("coasted");
    collator_.push(std::move(motion));
    return;
  }
  counters_.add("invalid_motion");
  fault_ = fault + "; it is left out";
}

void PointMap::set(const FilterPose& pose) {
  if (pose.pose().isFinite()) {
    collator_.push(pose);
    return;
  }
  counters_.add("invalid_pose");
  fault_ = "a pose holds a value that is not a number; it is left out";
}

void PointMap::set(LaserScan scan) { collator_.push(std::move(scan)); }

Status PointMap::execute() {
  const auto placed = collator_.next();
  is_busy_ = placed.has_value();
  const auto status = fault_.empty() ? Status::ok() : Status::warning(std::exchange(fault_, ""));
  if (!placed) return status;
  if (placed->restart) begin();
  stamp_ = placed->scan.stamp;
  const auto fused = fuse(placed->scan, fusion_->place(placed->scan, placed->T_map_base, points_));
  return status.isOk() ? fused : status;
}

Status PointMap::fuse(const LaserScan& scan, const Pose2& T_map_base) {
  std::uint64_t left_out = 0;
  forEachFan(scan, [&](const LaserFan& fan) { left_out += fuse(fan, T_map_base); });
  ++revision_;
  counters_.add("full", left_out);
  if (left_out == 0) return Status::ok();
  return Status::warning("the point map is full with " + std::to_string(points_.size()) +
                         " points: new ones are left out; raise point_map.max_points or "
                         "point_map.fusion_distance");
}

std::uint64_t PointMap::fuse(const LaserFan& fan, const Pose2& T_map_base) {
  const Pose2 T_map_sensor = T_map_base * fan.sensor_pose;
  std::uint64_t left_out = 0;
  for (const auto& beam : fan.beams) {
    if (!beam.hit) continue;
    const Eigen::Vector2d end = T_map_sensor.transform(beam.end());
    if (const auto near = fusion_->match(end, points_))
      points_.fuse(*near, end);
    else if (points_.size() < config_.max_points)
      points_.append(end);
    else
      ++left_out;
  }
  return left_out;
}

Counters PointMap::counters() const {
  Counters all = counters_;
  all.add(collator_.counters());
  all.add("set_aside", collator_.setAside());
  return all;
}

Component::Figures PointMap::figures() const {
  return {{"points", static_cast<double>(points().size())}};
}

void PointMap::save(const std::string& folder) const { savePcd(folder + "/points.pcd", points()); }

std::uint64_t PointMap::dropped() const {
  const auto& collated = collator_.counters();
  return collated["late"] + collated["lost"] + collated["overflow"] + collated["stamp_jump"] +
         collator_.setAside() + counters_["invalid_motion"];
}

void PointMap::saveState(ArchiveWriter& archive) const { archive(*this); }

void PointMap::restoreState(ArchiveReader& archive) { archive(*this); }

}  // namespace slam::point_map
