// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <vector>

#include "slam_core/camera/pose_fit.hpp"
#include "slam_core/mono_ekf/active_search.hpp"
#include "slam_core/mono_ekf/patch_descriptor.hpp"

namespace slam::mono_ekf {

/// A pose from which the map would look as an image does.
struct FoundPlace {
  Pose2 pose;                    ///< T_map_base, the map taken as exact
  std::vector<Search> searches;  ///< from there; those that fit it are kMatched
};

/// The prior of a robot that an image shows at this pose, relative to the map: uncertain by a metre
/// and half a radian.
PoseEstimate anywhereNear(const Pose2& pose);

/// Searches the whole map for a lost robot. The features with depth are compared with all corners
/// of an image by their surroundings (PatchDescriptor). Each pair of features that can be seen from
/// one place suggests a pose, in a fixed order. The poses that most other features fit (consensus:
/// Fischler and Bolles 1981) are tested by an active search for all features in view. A place
/// counts where most of them are found. Then the features that are not in view from there are
/// searched for a place of their own that looks alike: if it, or another one that was tested, has
/// half as many matches, the robot is found in none.
class PlaceSearch {
 public:
  /// @param state its map stays as it is while the robot is lost @param sigma of pixels [px]
  PlaceSearch(const MonoEkfConfig& config, const MonoState& state, double sigma);

  /// @param state the same map
  std::optional<FoundPlace> find(const MonoState& state, const PlanarCamera& camera,
                                 const cv::Mat& gray) const;

 private:
  /// A feature with depth.
  struct Known {
    std::size_t feature;
    Eigen::Vector3d point;        ///< map frame [m]
    Eigen::Vector3d centre, ray;  ///< of its first sight
    PatchDescriptor descriptor;
  };
  struct Comparison {
    std::vector<Eigen::Vector2d> corners;  ///< of an image
    Eigen::MatrixXf correlations;          ///< of each feature, a row each, with each corner
  };
  /// A corner that looks like a feature.
  struct Alike {
    std::size_t known, corner;
    float correlation;
    Eigen::Vector2d pixel;
    PoseSighting sighting;
  };
  struct Hypothesis {
    Pose2 pose;
    std::size_t fits = 0;
  };
  struct Tested {
    FoundPlace place;
    std::size_t matched = 0;
    bool is_good = false;
  };

  Comparison compare(const cv::Mat& gray) const;
  std::vector<Alike> alike(const Comparison& comparison, const PlanarCamera& camera,
                           const std::vector<bool>& is_considered) const;
  std::vector<Hypothesis> hypotheses(const NormalisedCamera& camera,
                                     const std::vector<Alike>& matches) const;
  std::optional<Pose2> poseOf(const NormalisedCamera& camera, const Alike& a, const Alike& b) const;
  bool isSeenAlike(const NormalisedCamera& camera, const Pose2& pose, const Known& known) const;
  static std::vector<Alike> fittingOnes(const NormalisedCamera& camera,
                                        const std::vector<Alike>& matches, const Pose2& pose);
  std::vector<Tested> placesOf(const MonoState& state, const PlanarCamera& camera,
                               const cv::Mat& gray, const std::vector<Alike>& matches) const;
  MonoState placed(const MonoState& state, const Pose2& pose, const PlanarCamera& camera,
                   const std::vector<Alike>& fitting, std::vector<std::size_t>& features) const;
  Tested test(const MonoState& state, const Pose2& pose, const PlanarCamera& camera,
              const cv::Mat& gray, const std::vector<Alike>& fitting) const;

  MonoEkfConfig config_;
  double sigma_;
  ActiveSearch active_search_;
  std::vector<Known> known_;
  Eigen::MatrixXf descriptors_;  ///< of those, a column each
};

}  // namespace slam::mono_ekf
