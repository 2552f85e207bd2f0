// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/mono_ekf_config.hpp"

#include "slam_core/common/config_error.hpp"

namespace slam::mono_ekf {

namespace {

/// These say which features the map has.
void describeMap(MonoEkfConfig& config, Fields& fields) {
  fields
      .add("features_in_view", &config.features_in_view,
           "so many features are measured in an image; where there are fewer, new ones begin")
      .unit("1")
      .in(Range::closed(4, 200));
  fields
      .add("most_features", &config.most_features,
           "so many features are kept in the map; beyond them those that were seen least give way")
      .unit("1")
      .in(Range::closed(4, 2000));
  fields
      .add("pixel_sigma", &config.pixel_sigma,
           "least standard deviation of where a feature is found in an image, however well the "
           "matches agree; where they agree less, up to 25 times as much is estimated")
      .unit("px")
      .in(Range::closed(0.05, 5));
  fields
      .add("nearest", &config.nearest,
           "a new feature is not nearer than this, with 95 %; it may be at infinity")
      .unit("m")
      .in(Range::closed(0.01, 100));
  fields
      .add("typical_distance", &config.typical_distance,
           "a new feature is taken to be at this distance until more is known")
      .unit("m")
      .in(Range::closed(0.01, 1000));
}

/// These say how a feature is found, and when its depth is known.
void describeSearch(MonoEkfConfig& config, Fields& fields) {
  fields
      .add("least_correlation", &config.least_correlation,
           "a patch is found where it correlates with the image by at least so much")
      .unit("1")
      .in(Range::closed(0.3, 0.999));
  fields
      .add("least_gradient", &config.least_gradient,
           "a corner has at least this gradient in each direction: more than noise has")
      .unit("1 of 255 per px")
      .in(Range::closed(0.5, 200));
  fields.add("spacing", &config.spacing, "features are at least so far apart in an image")
      .unit("px")
      .in(Range::closed(4, 200));
  fields
      .add("largest_search", &config.largest_search,
           "the few features that are known best are searched so far from where they are predicted "
           "while the pose is uncertain, all others up to a fifth of it")
      .unit("px")
      .in(Range::closed(4, 400));
  fields
      .add("largest_view_change", &config.largest_view_change,
           "a feature is not searched from a direction that differs by more than this")
      .unit("rad")
      .in(Range::closed(0.05, 1.5));
  fields
      .add("largest_linearity_index", &config.largest_linearity_index,
           "a feature becomes a point in metres when its linearity index is below this")
      .unit("1")
      .in(Range::closed(0, 1));
}

/// These say how odometry errs.
void describeOdometry(MonoEkfConfig& config, Fields& fields) {
  fields
      .add("systematic_share", &config.systematic_share,
           "of the variance that odometry claims for its heading so much is the same error on the "
           "whole way, as of wheels of slightly wrong sizes; it is estimated")
      .unit("1")
      .in({0.0, 1.0, false, true});
}

}  // namespace

void MonoEkfConfig::describe(Fields& fields) {
  fields.add("mode", &mode, backendModeNames(),
             "build the map; to keep a map of image features fixed is not possible");
  describeMap(*this, fields);
  describeSearch(*this, fields);
  describeOdometry(*this, fields);
}

void requireUsable(const MonoEkfConfig& config) {
  validate(config);
  if (config.mode != BackendMode::kSlam)
    throw ConfigError(
        "mono_ekf.mode: the monocular EKF cannot keep its map fixed and localise in it: set mode "
        "to slam, or take another back-end");
  if (config.most_features < config.features_in_view)
    throw ConfigError(
        "mono_ekf.most_features: the map must hold the features of one image: set it to "
        "mono_ekf.features_in_view or more");
  if (config.nearest >= config.typical_distance)
    throw ConfigError(
        "mono_ekf.nearest: it must be below mono_ekf.typical_distance, since features are nearer "
        "and farther than that");
}

}  // namespace slam::mono_ekf
