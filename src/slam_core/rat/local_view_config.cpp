// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/rat/local_view_config.hpp"

#include "slam_core/common/config_error.hpp"

namespace slam::rat {

void LocalViewConfig::describe(Fields& fields) {
  fields.add("columns", &columns, "an image is reduced to so many columns")
      .unit("px")
      .in(Range::closed(8, 256));
  fields.add("rows", &rows, "and so many rows").unit("px").in(Range::closed(4, 256));
  fields.add("crop_top", &crop_top, "this share of the image is left out above: the ceiling")
      .unit("1")
      .in(Range::closed(0, 0.9));
  fields.add("crop_bottom", &crop_bottom, "and this one below: the floor before the robot")
      .unit("1")
      .in(Range::closed(0, 0.9));
  fields
      .add("largest_shift", &largest_shift,
           "two views are compared with either moved sideways by up to so much")
      .unit("px")
      .in(Range::closed(0, 64));
  fields
      .add(
          "largest_difference", &largest_difference,
          "views are the same whose mean absolute difference is not larger, in standard deviations "
          "of an image's grays")
      .unit("1")
      .in(Range::open(0, 2));
  fields
      .add("least_contrast", &least_contrast,
           "an image whose grays, reduced, have a smaller standard deviation shows nothing: a dark "
           "room, a blank wall")
      .unit("1 of 255")
      .in(Range::closed(0.1, 100));
  fields
      .add("most_views", &most_views,
           "so many views are remembered; what is seen beyond them is recognised or nothing")
      .unit("1")
      .in(Range::closed(1, 100000));
}

void requireUsable(const LocalViewConfig& config) {
  validate(config);
  FaultCollector faults;
  if (config.crop_top + config.crop_bottom > 0.95)
    faults.add("local_view: crop_top and crop_bottom leave nothing of the image");
  if (2 * config.largest_shift >= config.columns)
    faults.add("local_view: largest_shift must be smaller than half of columns");
  faults.raise();
}

}  // namespace slam::rat
