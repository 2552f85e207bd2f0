// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "corridor_world.hpp"

#include <algorithm>
#include <cmath>

namespace slam::eval {
namespace {

constexpr double kHalfWidth = 1.5, kNicheWidth = 1.0, kNicheSpacing = 3.0;  // [m]
constexpr double kSigmaRange = 0.01;                                        // [m]
constexpr double kSigmaPosition = 0.005, kSigmaHeading = 0.005;             // of a step [m], [rad]

/// Of the niche of a number on a side, 1 or -1 [m].
double depthOf(std::int64_t niche, int side) {
  RandomStream random(static_cast<std::uint64_t>(niche + (1 << 20)),
                      static_cast<std::uint64_t>(side + 1));
  return 0.3 + 0.9 * random.uniform();
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

std::vector<Corridor::Segment> Corridor::near(double x) {
  std::vector<Segment> segments;
  const auto first = static_cast<std::int64_t>(std::floor((x - kReach) / kNicheSpacing));
  const auto last = static_cast<std::int64_t>(std::ceil((x + kReach) / kNicheSpacing));
  for (auto niche = first; niche <= last; ++niche) {
    for (const int side : {1, -1}) {
      const double begin = static_cast<double>(niche) * kNicheSpacing, end = begin + kNicheWidth;
      const double wall = side * kHalfWidth, back = side * (kHalfWidth + depthOf(niche, side));
      const Eigen::Vector2d corners[] = {
          {begin, wall}, {begin, back}, {end, back}, {end, wall}, {begin + kNicheSpacing, wall}};
      for (std::size_t i = 1; i < std::size(corners); ++i)
        segments.emplace_back(corners[i - 1], corners[i]);
    }
  }
  return segments;
}

double Corridor::range(const Eigen::Vector2d& from, double direction) const {
  const Eigen::Vector2d ray(std::cos(direction), std::sin(direction));
  double nearest = kReach;
  for (const auto& [a, b] : near(from.x())) {
    const Eigen::Vector2d along = b - a, start = a - from;
    const double denominator = cross(ray, along);
    if (denominator == 0.0) continue;
    const double t = cross(start, along) / denominator, u = cross(start, ray) / denominator;
    if (t >= 0.0 && u >= 0.0 && u <= 1.0) nearest = std::min(nearest, t);
  }
  return nearest;
}

LaserScan CorridorDrive::look(Stamp stamp) {
  LaserScan scan;
  scan.sequence = static_cast<std::uint64_t>(count_);
  scan.stamp = stamp;
  scan.sensor_frame = "laser";
  for (int i = 0; i < beams_; ++i) {
    const double bearing = M_PI * (static_cast<double>(i) / (beams_ - 1) - 0.5);
    const double range = corridor_.range(truth_.position(), truth_.theta() + bearing);
    const bool hit = range < Corridor::kReach;
    const double measured = hit ? range + kSigmaRange * random_.gaussian() : range;
    scan.beams.push_back({static_cast<float>(bearing), static_cast<float>(measured), hit});
  }
  return scan;
}

CorridorDrive::Step CorridorDrive::step(double way) {
  Step result;
  auto& motion = result.motion;
  motion.sequence = static_cast<std::uint64_t>(count_);
  motion.start = stamp();
  ++count_;
  motion.end = stamp();
  const Eigen::Vector3d sigma(kSigmaPosition, kSigmaPosition, kSigmaHeading);
  motion.covariance = sigma.cwiseAbs2().asDiagonal();
  const Eigen::Vector3d white(random_.gaussian(), random_.gaussian(), random_.gaussian());
  motion.increment = Pose2::fromVector(Eigen::Vector3d(way, 0.0, 0.0) + sigma.cwiseProduct(white));
  motion.odometry_frame = "odom";
  motion.base_frame = "base_link";
  motion.odometry_start = odometry_;
  motion.odometry_end = odometry_ = odometry_ * motion.increment;
  truth_ = truth_ * Pose2(way, 0.0, 0.0);
  result.scan = look(motion.end);
  result.truth = truth_;
  return result;
}

}  // namespace slam::eval
