// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "viewed_surface.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace slam::sim {
namespace {

constexpr double kNearestPlane = 1e-4;  // a camera nearer to a plane than this sees its edge [m]

LinearForm toForm(const Eigen::RowVector3d& row) {
  return {static_cast<float>(row.x()), static_cast<float>(row.y()), static_cast<float>(row.z())};
}

std::optional<PlaneView> viewPlane(const Surface& surface,
                                   const Eigen::Isometry3d& T_world_camera) {
  const Rectangle& rectangle = surface.rectangle;
  const Eigen::Vector3d normal = rectangle.normal();
  const Eigen::Vector3d from_origin = T_world_camera.translation() - rectangle.origin;
  const double in_front = normal.dot(from_origin);
  if (surface.two_sided ? std::abs(in_front) < kNearestPlane : in_front < kNearestPlane) {
    return std::nullopt;
  }
  const Eigen::Matrix3d R = T_world_camera.linear();
  const Eigen::RowVector3d w = -normal.transpose() * R / in_front;
  const auto coordinate = [&](const Eigen::Vector3d& axis) -> Eigen::RowVector3d {
    return axis.dot(from_origin) * w + axis.transpose() * R;
  };
  return PlaneView{toForm(w), toForm(coordinate(rectangle.eu)), toForm(coordinate(rectangle.ev))};
}

}  // namespace

float LinearForm::minOver(const RayBounds& rays) const {
  return at(x > 0.0F ? rays.x_min : rays.x_max, y > 0.0F ? rays.y_min : rays.y_max);
}

float LinearForm::maxOver(const RayBounds& rays) const {
  return at(x > 0.0F ? rays.x_max : rays.x_min, y > 0.0F ? rays.y_max : rays.y_min);
}

LinearForm LinearForm::operator+(const LinearForm& other) const {
  return {x + other.x, y + other.y, c + other.c};
}

LinearForm LinearForm::operator-(const LinearForm& other) const {
  return {x - other.x, y - other.y, c - other.c};
}

LinearForm LinearForm::operator*(float factor) const {
  return {x * factor, y * factor, c * factor};
}

ViewedSurface::Cover ViewedSurface::coverOf(const RayBounds& rays, std::size_t sample) const {
  const PlaneView& view = views[sample];
  const LinearForm inside[] = {view.w, view.uw, view.w * width - view.uw, view.vw,
                               view.w * height - view.vw};
  Cover cover = Cover::kFull;
  for (const LinearForm& form : inside) {
    if (form.maxOver(rays) < 0.0F) return Cover::kNone;
    if (form.minOver(rays) <= 0.0F) cover = Cover::kPart;
  }
  return cover;
}

bool ViewedSurface::mayBeMetBy(const RayBounds& rays) const {
  for (std::size_t sample = 0; sample < views.size(); ++sample) {
    if (coverOf(rays, sample) != Cover::kNone) return true;
  }
  return false;
}

std::vector<ViewedSurface> viewedSurfaces(const std::vector<Surface>& surfaces,
                                          const std::vector<Eigen::Isometry3d>& T_world_cameras,
                                          const RayBounds& rays) {
  std::vector<ViewedSurface> viewed;
  for (const Surface& surface : surfaces) {
    ViewedSurface candidate{&surface,
                            static_cast<float>(surface.rectangle.width),
                            static_cast<float>(surface.rectangle.height),
                            {}};
    for (const auto& T_world_camera : T_world_cameras) {
      const auto view = viewPlane(surface, T_world_camera);
      if (!view) break;
      candidate.views.push_back(*view);
    }
    // A surface seen edge-on in part of the exposure is left out of all of it.
    if (candidate.views.size() < T_world_cameras.size()) continue;
    if (candidate.mayBeMetBy(rays)) viewed.push_back(std::move(candidate));
  }
  return viewed;
}

}  // namespace slam::sim
