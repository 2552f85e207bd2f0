// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "slam_core/mono_ekf/mono_ekf_config.hpp"
#include "slam_core/mono_ekf/mono_state.hpp"
#include "slam_core/mono_ekf/patch.hpp"

namespace slam::mono_ekf {

/// A feature that is predicted in an image, and what became of it.
struct Search {
  enum class Outcome { kNotFound, kRejected, kMatched };

  std::size_t feature = 0;  ///< which one of the state's
  Eigen::Vector2d predicted = Eigen::Vector2d::Zero();
  Eigen::Matrix2d S = Eigen::Matrix2d::Identity();  ///< innovation covariance [px^2]
  Outcome outcome = Outcome::kNotFound;
  Eigen::Vector2d found = Eigen::Vector2d::Zero();  ///< counts where the outcome is another one
};

/// Active search (Davison et al. 2007): of the features that the image should show, each is looked
/// for only where the filter expects it, by its patch as it should look from there.
///
/// The oldest ones come first, so that a robot that is back where it has been measures what it
/// mapped then, which is what closes a loop.
class ActiveSearch {
 public:
  /// This bounds a search: it looks for so many features, each within a reach of its prediction.
  struct Effort {
    std::size_t most;
    double largest_reach;  ///< semi-axis of the ellipse that holds 99 % [px]
  };

  ActiveSearch() = default;
  explicit ActiveSearch(const MonoEkfConfig& config) : config_(config) {}

  /// Few and far, where the pose is so uncertain that most features may be anywhere in a wide
  /// region, as after a turn of bad odometry: once these are measured, the others are near.
  /// The result is empty where the pose is known better.
  /// @param pixel_sigma of where a feature is found [px]
  std::vector<Search> searchFar(const MonoState& state, const PlanarCamera& camera,
                                const cv::Mat& gray, double pixel_sigma) const;
  /// The others, up to features_in_view together. Who was found counts as kRejected: nobody has
  /// agreed with it yet.
  /// @param before what was searched in this image already
  std::vector<Search> searchNear(const MonoState& state, const PlanarCamera& camera,
                                 const cv::Mat& gray, double pixel_sigma,
                                 const std::vector<Search>& before) const;

 private:
  std::vector<Search> expected(const MonoState& state, const PlanarCamera& camera,
                               const cv::Mat& gray, double pixel_sigma) const;
  std::vector<Search> find(std::vector<Search> candidates, const Effort& effort,
                           const MonoState& state, const PlanarCamera& camera, const cv::Mat& gray,
                           const std::vector<Search>& before) const;
  std::optional<Patch> patchOf(const MonoState& state, std::size_t which,
                               const PlanarCamera& camera) const;

  MonoEkfConfig config_;
};

}  // namespace slam::mono_ekf
