// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/grid_map/scan_points.hpp"

#include <cmath>
#include <optional>

namespace slam::grid_map {
namespace {

std::optional<ScanPoints::Beam> beamOf(const LaserBeam& beam, const LaserFan& fan,
                                       const BeamModel& model) {
  const double range = beam.range;
  if (!std::isfinite(beam.bearing) || !(range > 0.0)) return std::nullopt;
  const bool is_hit = beam.hit && range <= model.usableRange();
  const double free = beam.hit ? model.usableRange() : std::min(range, model.freeRange());
  const double length = is_hit ? range : free;
  if (!(length > 0.0)) return std::nullopt;
  const Eigen::Vector2d direction(std::cos(double{beam.bearing}), std::sin(double{beam.bearing}));
  const Eigen::Vector2d end = fan.sensor_pose.transform(length * direction);
  const double sigma = fan.relative_sigma * range;
  if (!is_hit) return ScanPoints::Beam{end / model.resolution(), LogOdds{0}, 0.0};
  return ScanPoints::Beam{end / model.resolution(), model.gainOf(sigma),
                          sigma / model.resolution()};
}

/// Of ends in the order of the sweep, those that lie about `apart` apart. Whether an end is kept is
/// decided by those before it: who waits until an end is far enough away keeps those whose noise
/// points ahead, and with that sees all walls turned.
class Thinning {
 public:
  explicit Thinning(double apart) : apart_(apart) {}

  bool keeps(const Eigen::Vector2d& end) {
    const bool is_kept = is_first_ || (last_ - kept_).norm() + step_ >= apart_ ||
                         (end - kept_).norm() >= kJump * apart_;
    step_ = is_first_ ? 0.0 : (end - last_).norm();
    is_first_ = false;
    last_ = end;
    if (is_kept) kept_ = end;
    return is_kept;
  }

 private:
  static constexpr double kJump = 4.0;  // of `apart`: to something else
  double apart_;
  bool is_first_ = true;
  Eigen::Vector2d kept_ = Eigen::Vector2d::Zero(), last_ = Eigen::Vector2d::Zero();
  double step_ = 0.0;  ///< to the last end
};

void add(const LaserFan& fan, const BeamModel& model, double spacing, ScanPoints& points) {
  if (!points.isOnMap(fan.sensor_pose)) return;
  points.startFan(fan.sensor_pose.position() / model.resolution(), fan.relative_sigma);
  points.beams.reserve(points.beams.size() + fan.beams.size());
  Thinning thinning(spacing / model.resolution());
  for (const auto& read : fan.beams) {
    const auto beam = beamOf(read, fan, model);
    if (!beam) continue;
    points.beams.push_back(*beam);
    if (beam->isHit() && thinning.keeps(beam->end)) points.ends.push_back(beam->end);
  }
}

}  // namespace

bool ScanPoints::isOnMap(const Pose2& pose) const {
  constexpr double kMostCells = 1 << 28;
  return pose.isFinite() && (cells_per_metre * pose.position()).cwiseAbs().maxCoeff() < kMostCells;
}

ScanPoints pointsOf(const LaserScan& scan, const BeamModel& model, double spacing) {
  ScanPoints points;
  points.cells_per_metre = 1.0 / model.resolution();
  forEachFan(scan, [&](const LaserFan& fan) { add(fan, model, spacing, points); });
  return points;
}

}  // namespace slam::grid_map
