// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "slam_core/camera/normalised_camera.hpp"
#include "slam_core/mono_graph/descriptor.hpp"

namespace slam::mono_graph {

/// A robot on the plane does not roll: so far may a feature be turned in another image [rad].
constexpr double kLargestRoll = 0.35;

/// A corner of an image, without the lens.
struct Feature {
  Eigen::Vector2d seen;   ///< on the plane z = 1 before the camera
  Eigen::Vector2d pixel;  ///< in the raw image [px]
  double sigma = 0.0;     ///< standard deviation of `seen` along each axis
  double angle = 0.0;     ///< orientation in the image [rad], 0 to 2 pi
  int level = 0;          ///< of the pyramid, 0 the finest
  Descriptor descriptor{};

  template <class Archive>
  void persist(Archive& archive) {
    archive(seen, pixel, sigma, angle, level, descriptor);
  }
};

/// @return the angle between two orientations in the image, which are in [0, 2 pi) [rad]
inline double turnBetween(double a, double b) {
  const double apart = std::abs(a - b);
  return std::min(apart, 2.0 * M_PI - apart);
}

/// The features of an image, found by their place.
class Features {
 public:
  Features() = default;
  /// @param focal [px] of the camera, sigma [px] of a feature of the finest level
  Features(std::vector<Feature> features, const NormalisedCamera& camera, double focal);

  std::size_t size() const { return features_.size(); }
  const Feature& operator[](std::size_t i) const { return features_[i]; }
  const std::vector<Feature>& all() const { return features_; }
  const NormalisedCamera& camera() const { return camera_; }
  double focal() const { return focal_; }  ///< [px]

  /// Appends the features within a distance [px] of a point of the plane z = 1, in a fixed order.
  void near(const Eigen::Vector2d& seen, double radius, std::vector<std::size_t>& found) const;
  /// Appends those in a box of the plane z = 1, in a fixed order.
  void within(const Eigen::AlignedBox2d& box, std::vector<std::size_t>& found) const;
  /// Whether the point lies where there are features: within their bounding box.
  bool covers(const Eigen::Vector2d& seen) const;

  template <class Archive>
  void persist(Archive& archive) {
    archive(features_, camera_, focal_);
    if constexpr (Archive::kReads) sort();
  }

 private:
  void sort();
  int column(double x) const;
  int row(double y) const;

  std::vector<Feature> features_;
  NormalisedCamera camera_;
  double focal_ = 1.0;
  Eigen::Vector2d least_ = Eigen::Vector2d::Zero(), most_ = Eigen::Vector2d::Zero();
  int columns_ = 0, rows_ = 0;
  std::vector<std::size_t> begins_;  ///< of each cell in members_, and the end
  std::vector<std::size_t> members_;
};

}  // namespace slam::mono_graph
