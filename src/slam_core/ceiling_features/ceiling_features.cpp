// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ceiling_features/ceiling_features.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "slam_core/camera/camera_config.hpp"
#include "slam_core/ceiling_features/drawing.hpp"
#include "slam_core/ceiling_features/feature_observation.hpp"
#include "slam_core/ceiling_features/ring_descriptor.hpp"
#include "slam_core/common/config_error.hpp"
#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam::ceiling_features {
namespace {

const Registrar<LandmarkDetector, CeilingFeatures> kRegistrar("ceiling_features");
const SectionRegistrar<CeilingFeaturesConfig> kSection;

constexpr double kWorthAWord = 0.35;  // of the camera's tilt [rad]
constexpr double kMaxTilt = 1.05;     // beyond, hardly anything of the ceiling is seen [rad]

bool isLandmark(const CeilingFeature& feature) { return feature.rejection.empty(); }

}  // namespace

void CeilingFeatures::configure(const CeilingFeaturesConfig& config, double height) {
  validate(config);
  if (!(height > 0.0))
    throw ConfigError(
        "ceiling_camera.ceiling_height is 0: landmarks on the ceiling need its height above the "
        "camera [m], above 0, in the robot file");
  config_ = config;
  height_ = height;
  reset();
}

void CeilingFeatures::configure(Settings& settings) {
  CeilingFeaturesConfig config;
  CeilingCameraConfig camera;
  FaultCollector faults;
  faults.attempt([&] { config = settings.read<CeilingFeaturesConfig>(); });
  faults.attempt([&] { camera = settings.read<CeilingCameraConfig>(); });
  faults.raise();
  configure(config, camera.ceiling_height);
}

void CeilingFeatures::describe(Ports& ports) {
  ports.takes<CameraView>(CeilingCameraConfig::kSection, "images of the ceiling", this);
  ports.makes<LandmarkObservationArray>("observations", observations_);
}

void CeilingFeatures::reset() {
  next_view_.reset();
  view_.reset();
  ceiling_ = {};
  features_.clear();
  observations_.reset();
  next_sequence_ = 0;
  counters_.clear();
}

Status CeilingFeatures::execute() {
  observations_.reset();
  view_ = std::exchange(next_view_, std::nullopt);
  if (!view_) return Status::ok();
  features_.clear();
  auto& array = observations_.emplace();
  array.sequence = next_sequence_++;
  array.stamp = view_->stamp;
  array.sensor_frame = view_->image.frame;
  if (!view_->isUsable()) return Status::ok();  // its input gate has reported why

  look();
  count();
  return explain();
}

void CeilingFeatures::look() {
  ceiling_ = CeilingView(*view_->camera, view_->mount.T_base_camera, height_);
  observations_->sensor_pose = Pose2(ceiling_.origin().x(), ceiling_.origin().y(), 0.0);
  if (ceiling_.tilt() > kMaxTilt) return;
  const auto& gray = view_->image.gray;
  if (isSpotTooLarge()) return;
  const ScaledImage image(gray, sigmaOfSpot());
  features_ = selectFeatures(image.spots(config_.min_contrast), gray.size(), ceiling_, config_);
  observe(image);
}

double CeilingFeatures::sigmaOfSpot() const {
  return config_.size * height_ / ceiling_.metresPerPixel();
}

bool CeilingFeatures::isSpotTooLarge() const {
  const auto& gray = view_->image.gray;
  return !(sigmaOfSpot() < std::min(gray.cols, gray.rows));
}

void CeilingFeatures::observe(const ScaledImage& image) {
  for (auto& feature : features_) {
    if (!isLandmark(feature)) continue;
    auto z = observationOf(feature.spot.pixel, ceiling_, config_);
    const auto descriptor = describeSurroundings(image, view_->image.gray.size(), ceiling_,
                                                 feature.point, config_.spacing * height_);
    if (!z || !descriptor || !faultOf(*z).empty()) {
      feature.rejection = "cut_off";
      continue;
    }
    z->descriptor = *descriptor;
    observations_->observations.push_back(*z);
  }
}

void CeilingFeatures::count() {
  for (const auto& feature : features_)
    if (!isLandmark(feature)) counters_.add(feature.rejection);
}

Status CeilingFeatures::explain() const {
  if (ceiling_.tilt() > kWorthAWord)
    return Status::warning(fmt::format(
        "the ceiling camera does not look up: its mount says that it is tilted by {:.0f} "
        "deg; correct its transform to the robot's base frame",
        ceiling_.tilt() * 180.0 / M_PI));
  if (isSpotTooLarge())
    return Status::warning(fmt::format(
        "a spot of the ceiling would fill the image: by the camera's calibration a pixel sees "
        "{:.2g} m of the ceiling; correct the camera_info of the ceiling camera",
        ceiling_.metresPerPixel()));
  if (features_.empty())
    return Status::warning("the ceiling shows no spots: it is dark, blurred or bare");
  return Status::ok();
}

cv::Mat CeilingFeatures::drawing() const {
  return view_ ? draw(view_->image.gray, features_) : cv::Mat();
}

Component::Figures CeilingFeatures::figures() const {
  const auto landmarks = std::count_if(features_.begin(), features_.end(), isLandmark);
  return {{"spots", static_cast<double>(features_.size())},
          {"landmarks", static_cast<double>(landmarks)}};
}

void CeilingFeatures::saveState(ArchiveWriter& archive) const { archive(*this); }

void CeilingFeatures::restoreState(ArchiveReader& archive) { archive(*this); }

}  // namespace slam::ceiling_features
