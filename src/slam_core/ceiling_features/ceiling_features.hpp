// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include "slam_core/camera/camera_view.hpp"
#include "slam_core/camera/ceiling_view.hpp"
#include "slam_core/camera/view_drawer.hpp"
#include "slam_core/ceiling_features/ceiling_features_config.hpp"
#include "slam_core/ceiling_features/feature_selection.hpp"
#include "slam_core/ceiling_features/scaled_image.hpp"
#include "slam_core/contract/landmark_detector.hpp"

namespace slam::ceiling_features {

/// Natural landmarks without ids: spots of a ceiling of known height that an upward-looking camera
/// sees. Since the height is known, so are the place of a spot in the robot's plane and the scale
/// at which the ceiling is examined: a spot looks the same from everywhere, but turned. Its
/// descriptor says what surrounds it (ring_descriptor.hpp).
///
/// A spot is a landmark where it is the most distinct one within the spacing, so that the same ones
/// are chosen in each image and are far enough apart to be told from one another. Spots that are no
/// landmarks are counted: "cut_off" (the image does not hold all that is within the spacing),
/// "not_distinct" (another spot within the spacing is nearly as distinct), "too_near" (to the point
/// above the camera), "too_many".
class CeilingFeatures final : public LandmarkDetector, public ViewDrawer {
 public:
  /// @param height of the ceiling above the camera, above 0 [m]
  void configure(const CeilingFeaturesConfig& config, double height);
  void configure(Settings& settings) override;
  LandmarkTraits traits() const override { return {true}; }
  void describe(Ports& ports) override;
  void set(const CameraView& view) { next_view_ = view; }
  Status execute() override;
  const std::optional<LandmarkObservationArray>& observations() const override {
    return observations_;
  }
  cv::Mat drawing() const override;
  Figures figures() const override;
  Counters counters() const override { return counters_; }
  void reset() override;
  bool canResume() const override { return true; }
  void saveState(ArchiveWriter& archive) const override;
  void restoreState(ArchiveReader& archive) override;

  template <class Archive>
  void persist(Archive& archive) {
    archive(next_sequence_, counters_);
  }

 private:
  void look();
  double sigmaOfSpot() const;   ///< [px]
  bool isSpotTooLarge() const;  ///< to be seen: it would fill the image
  void observe(const ScaledImage& image);
  void count();
  Status explain() const;

  CeilingFeaturesConfig config_;
  double height_ = 0.0;                         ///< of the ceiling above the camera [m]
  std::optional<CameraView> next_view_, view_;  ///< of the next step and of the last one
  CeilingView ceiling_;                         ///< of the last image that could be used
  std::vector<CeilingFeature> features_;        ///< of the last image, most distinct first
  std::optional<LandmarkObservationArray> observations_;
  std::uint64_t next_sequence_ = 0;
  Counters counters_;
};

}  // namespace slam::ceiling_features
