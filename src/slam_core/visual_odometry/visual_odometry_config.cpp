// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/visual_odometry/visual_odometry_config.hpp"

#include "slam_core/common/config_error.hpp"

namespace slam::visual_odometry {
namespace {

void describeImages(VisualOdometryConfig& config, Fields& fields) {
  fields.add("features", &config.features, featureNames(),
             "what is found again from image to image");
  fields.add("max_features", &config.max_features, "of an image").in(Range::closed(20, 5000));
  fields
      .add("min_inliers", &config.min_inliers,
           "matches that must agree on one motion; with fewer the image is not used")
      .in(Range::atLeast(5));
  fields
      .add("keyframe_share", &config.keyframe_share,
           "a new keyframe is taken when fewer matches agree than this share of the first ones")
      .unit("1")
      .in(Range::open(0, 1));
  fields
      .add("inlier_distance", &config.inlier_distance,
           "matches agree when they are not farther off than this; coarse ones in proportion more")
      .unit("px")
      .in(Range::above(0));
  fields
      .add("scale_tolerance", &config.scale_tolerance,
           "by how much the ceiling's distance may seem to change; beyond, another surface is seen")
      .unit("1")
      .in(Range::open(0, 1));
  fields
      .add(
          "patience", &config.patience,
          "for how long images are compared with a keyframe that they do not fit; then one of them "
          "takes its place")
      .unit("s")
      .in(Range::above(0));
}

void describeRobot(VisualOdometryConfig& config, Fields& fields) {
  fields
      .add("ceiling_height", &config.ceiling_height,
           "of the ceiling above the camera, where it differs from ceiling_camera.ceiling_height; "
           "0: it does not")
      .unit("m")
      .in(Range::atLeast(0))
      .ofRobot();
  fields.add("max_speed", &config.max_speed, "the robot is never faster")
      .unit("m/s")
      .in(Range::above(0))
      .ofRobot();
  fields.add("max_turn_rate", &config.max_turn_rate, "the robot never turns faster")
      .unit("rad/s")
      .in(Range::above(0))
      .ofRobot();
  fields
      .add("pixel_sigma", &config.pixel_sigma,
           "least standard deviation of a feature in the image, however well the matches agree")
      .unit("px")
      .in(Range::above(0))
      .ofRobot();
  fields
      .add("alpha_translation", &config.alpha_translation,
           "variance by the way, of what matches do not tell: a ceiling that is not flat, a height "
           "that is not exact")
      .unit("m^2/m")
      .in(Range::atLeast(0))
      .ofRobot();
  fields
      .add("alpha_rotation", &config.alpha_rotation,
           "variance of the heading by the way, of what matches do not tell: the lens")
      .unit("rad^2/m")
      .in(Range::atLeast(0))
      .ofRobot();
  fields
      .add("floor_position", &config.floor_position,
           "standard deviation of the position after one second, standing or not")
      .unit("m/sqrt(s)")
      .in(Range::above(0))
      .ofRobot();
  fields
      .add("floor_heading", &config.floor_heading,
           "standard deviation of the heading after one second, standing or not")
      .unit("rad/sqrt(s)")
      .in(Range::above(0))
      .ofRobot();
}

}  // namespace

const Names<FeatureKind>& featureNames() {
  static const Names<FeatureKind> kNames = {{"orb", FeatureKind::kOrb},
                                            {"klt", FeatureKind::kKlt},
                                            {"akaze", FeatureKind::kAkaze},
                                            {"sift", FeatureKind::kSift},
                                            {"surf", FeatureKind::kSurf}};
  return kNames;
}

void VisualOdometryConfig::describe(Fields& fields) {
  describeImages(*this, fields);
  describeRobot(*this, fields);
}

void VisualOdometryConfig::requireHeight() const {
  if (ceiling_height > 0.0) return;
  throw ConfigError(
      "ceiling_camera.ceiling_height is 0: visual odometry needs the height of the ceiling above "
      "the camera [m], above 0, in the robot file");
}

}  // namespace slam::visual_odometry
