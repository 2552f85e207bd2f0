// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ceiling_features/ceiling_features_config.hpp"

namespace slam::ceiling_features {
namespace {

void describeChoice(CeilingFeaturesConfig& config, Fields& fields) {
  fields
      .add("size", &config.size,
           "size of the spots that are searched for, as a share of the ceiling's height above the "
           "camera: the standard deviation of the Gaussian that the image is smoothed by")
      .unit("1")
      .in(Range::open(0, 0.2));
  fields
      .add("spacing", &config.spacing,
           "a landmark is the most distinct spot within this share of the ceiling's height, and is "
           "described by what surrounds it so far")
      .unit("1")
      .in(Range::above(0));
  fields
      .add("min_contrast", &config.min_contrast,
           "a spot that is brighter or darker than its surroundings by a smaller share is no "
           "landmark")
      .unit("1")
      .in(Range::open(0, 1));
  fields
      .add("min_range", &config.min_range,
           "a spot that is nearer to the point above the camera than this share of the ceiling's "
           "height is left out: its bearing is hardly defined")
      .unit("1")
      .in(Range::above(0));
  fields
      .add("max_features", &config.max_features,
           "an image gives so many landmarks at most, the most distinct ones")
      .unit("1")
      .in(Range::closed(1, 1000));
}

void describeNoise(CeilingFeaturesConfig& config, Fields& fields) {
  fields
      .add("pixel_sigma", &config.pixel_sigma,
           "standard deviation of a spot in the image, in each direction")
      .unit("px")
      .in(Range::above(0))
      .ofRobot();
  fields
      .add("relative_sigma", &config.relative_sigma,
           "further standard deviation of a spot's place as a share of the ceiling's height: of a "
           "ceiling that is not flat, a height that is not exact, a robot that tilts")
      .unit("1")
      .in(Range::closed(0, 1))
      .ofRobot();
}

}  // namespace

void CeilingFeaturesConfig::describe(Fields& fields) {
  describeChoice(*this, fields);
  describeNoise(*this, fields);
}

}  // namespace slam::ceiling_features
