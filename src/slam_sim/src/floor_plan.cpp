// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/floor_plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace slam::sim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRetroreflection = 30.0;  // of tape, against a white wall

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Distance along the ray to the face, infinity where it is missed.
double hit(const Eigen::Vector2d& origin, const Eigen::Vector2d& direction, const Face& face) {
  const Eigen::Vector2d along = face.to - face.from, start = face.from - origin;
  const double denominator = cross(direction, along);
  if (denominator == 0.0) return kInfinity;
  const double t = cross(start, along) / denominator, u = cross(start, direction) / denominator;
  return t >= 0.0 && u >= 0.0 && u <= 1.0 ? t : kInfinity;
}

}  // namespace

std::string pointText(const Eigen::Vector2d& point) {
  std::ostringstream text;
  text << "(" << point.x() << ", " << point.y() << ")";
  return text.str();
}

std::vector<Eigen::Vector2d> cornersOf(const Box& box) {
  const Eigen::Rotation2Dd R(box.yaw);
  const double x = box.size.x() / 2.0, y = box.size.y() / 2.0;
  std::vector<Eigen::Vector2d> corners;
  for (const auto& corner : {Eigen::Vector2d(-x, -y), Eigen::Vector2d(x, -y), Eigen::Vector2d(x, y),
                             Eigen::Vector2d(-x, y)})
    corners.push_back(box.centre + R * corner);
  return corners;
}

double distanceToSegment(const Eigen::Vector2d& point, const Eigen::Vector2d& from,
                         const Eigen::Vector2d& to) {
  const Eigen::Vector2d along = to - from;
  const double length2 = along.squaredNorm();
  const double share =
      length2 > 0.0 ? std::clamp((point - from).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (from + share * along - point).norm();
}

FloorPlan::FloorPlan(const World& world) : furniture_(world.furniture) {
  for (const auto& wall : world.walls) {
    faces_.push_back({wall.from, wall.to, wall.height,
                      "the wall from " + pointText(wall.from) + " to " + pointText(wall.to),
                      wall.is_reflector ? kRetroreflection : wall.gray});
    has_reflectors_ = has_reflectors_ || wall.is_reflector;
  }
  for (const auto& box : world.furniture) {
    const auto corners = cornersOf(box);
    for (std::size_t i = 0; i < corners.size(); ++i)
      faces_.push_back({corners[i], corners[(i + 1) % corners.size()], box.size.z(),
                        "the furniture at " + pointText(box.centre), box.gray});
  }
}

FloorPlan::RayEnd FloorPlan::rayEnd(const Eigen::Vector2d& origin, const Eigen::Vector2d& direction,
                                    double z) const {
  RayEnd end{kInfinity, nullptr};
  for (const auto& face : faces_) {
    if (face.height < z) continue;
    const double distance = hit(origin, direction, face);
    if (distance < end.distance) end = {distance, &face};
  }
  return end;
}

const Face* FloorPlan::nearest(const Eigen::Vector2d& point, double z, double* distance) const {
  const Face* best = nullptr;
  double best_distance = kInfinity;
  for (const auto& face : faces_) {
    const double d = distanceToSegment(point, face.from, face.to);
    if (face.height < z || d >= best_distance) continue;
    best = &face;
    best_distance = d;
  }
  if (distance != nullptr) *distance = best_distance;
  return best;
}

const Face* FloorPlan::crossed(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                               double z) const {
  const double length = (to - from).norm();
  if (length == 0.0) return nullptr;
  const Eigen::Vector2d direction = (to - from) / length;
  const auto found = std::find_if(faces_.begin(), faces_.end(), [&](const Face& face) {
    return face.height >= z && hit(from, direction, face) <= length;
  });
  return found == faces_.end() ? nullptr : &*found;
}

const Box* FloorPlan::containing(const Eigen::Vector2d& point, double z) const {
  const auto found = std::find_if(furniture_.begin(), furniture_.end(), [&](const Box& box) {
    const Eigen::Vector2d local = Eigen::Rotation2Dd(-box.yaw) * (point - box.centre);
    return box.size.z() >= z && 2.0 * std::abs(local.x()) <= box.size.x() &&
           2.0 * std::abs(local.y()) <= box.size.y();
  });
  return found == furniture_.end() ? nullptr : &*found;
}

}  // namespace slam::sim
