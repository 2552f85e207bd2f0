// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>

#include "slam_core/point_map/fusion_policy.hpp"
#include "slam_core/point_map/scan_alignment.hpp"
#include "slam_core/point_map/surface_line.hpp"

namespace slam::point_map {
namespace {

constexpr double kSurfaceRadius = 0.2;  ///< of the points that a surface is known by [m]
constexpr std::uint32_t kSettled = 20;  ///< so many end points make a point of a surface
constexpr std::uint32_t kStray = 4;     ///< a point of so much less counts as noise beside it

/// The last scan's correction is the next one's first guess: the map's own errors, which the filter
/// does not know, last longer than a scan. Where one cannot be aligned the filter's pose counts and
/// the correction is over: it turns about the map's origin, so that far from where it was found it
/// would be another.
class AlignedFusion final : public FusionPolicy {
 public:
  explicit AlignedFusion(const PointMapConfig& config) : config_(config), alignment_(config) {}

  Pose2 place(const LaserScan& scan, const Pose2& T_map_base, const PointSet& map) override {
    const Pose2 guess = correction_ * T_map_base;
    const auto aligned = alignment_.align(scan, guess, T_map_base, map);
    correction_ = aligned ? *aligned * T_map_base.inverse() : Pose2();
    return aligned.value_or(T_map_base);
  }

  std::optional<std::uint32_t> match(const Eigen::Vector2d& end, PointSet& map) override {
    const auto near = map.nearest(end, config_.surface_distance);
    if (!near) return std::nullopt;
    const auto settled = settledOnSurface(end, map);
    if (!settled) return map.nearest(end, config_.fusion_distance);
    const bool is_stray = *near != *settled &&
                          map.points()[*near].count * kStray <= map.points()[*settled].count &&
                          isAcross(*near, *settled, map);
    return is_stray ? map.join(*settled, *near) : settled;
  }

  void reset() override { correction_ = Pose2(); }
  void saveState(ArchiveWriter& archive) const override { archive(correction_); }
  void restoreState(ArchiveReader& archive) override { archive(correction_); }

 private:
  /// Of the points beside an end point along a surface that is known well, the best known.
  std::optional<std::uint32_t> settledOnSurface(const Eigen::Vector2d& end, const PointSet& map) {
    line_ = surfaceLine(end, kSurfaceRadius, kHeavy, map);
    if (!line_.is_line) return std::nullopt;
    const double reach = std::hypot(config_.surface_distance, config_.fusion_distance);
    std::optional<std::uint32_t> best;
    map.visitNear(end, reach, [&](std::uint32_t point) {
      const auto& [position, count] = map.points()[point];
      if (count < kSettled || alongSurface(position - end) > config_.fusion_distance) return;
      if (best && (count < map.points()[*best].count ||
                   (count == map.points()[*best].count && point > *best)))
        return;
      best = point;
    });
    return best;
  }

  bool isAcross(std::uint32_t a, std::uint32_t b, const PointSet& map) const {
    return alongSurface(map.points()[a].position - map.points()[b].position) <=
           config_.fusion_distance;
  }

  /// The part of a way that runs along the surface in hand [m].
  double alongSurface(const Eigen::Vector2d& way) const {
    return std::abs(way.x() * line_.normal.y() - way.y() * line_.normal.x());
  }

  static constexpr std::uint32_t kHeavy = 1000000;

  PointMapConfig config_;
  ScanAlignment alignment_;
  Pose2 correction_;  ///< of the filter's poses, in the map frame
  SurfaceLine line_;  ///< at the end point in hand
};

}  // namespace

std::unique_ptr<FusionPolicy> makeAlignedFusion(const PointMapConfig& config) {
  return std::make_unique<AlignedFusion>(config);
}

}  // namespace slam::point_map
