// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/fiducial/fiducial_config.hpp"

#include <algorithm>

namespace slam::fiducial {

void FiducialConfig::describe(Fields& fields) {
  fields.add("marker_size", &marker_size, "edge of a marker's black square")
      .unit("m")
      .in(Range::above(0))
      .ofRobot();
  fields.add("marker_sizes", &marker_sizes, "edges of markers of another size, by id")
      .unit("m")
      .in(Range::above(0))
      .ofRobot();
  fields.add("ids", &ids, "the markers there are; none listed: any")
      .in(Range::atLeast(0))
      .ofRobot();
  fields
      .add("corner_sigma", &corner_sigma,
           "standard deviation of a marker's corner in the image, in each direction")
      .unit("px")
      .in(Range::above(0))
      .ofRobot();
  fields
      .add("sigma_range_relative", &sigma_range_relative,
           "further standard deviation of a range, as a share of it: of markers that are printed "
           "a little too large or small, and of a camera whose focal length is a little off")
      .unit("1")
      .in(Range::closed(0, 1))
      .ofRobot();
  fields.add("min_side", &min_side, "markers whose sides are shorter on average are rejected")
      .unit("px")
      .in(Range::atLeast(0));
  fields
      .add("max_obliqueness", &max_obliqueness,
           "markers whose normal points further away from the camera are rejected")
      .unit("rad")
      .in(Range::closed(0, 1.5707963));
  fields
      .add("border", &border,
           "markers with a corner nearer to the border of the image than this and a twentieth of "
           "a side are rejected: part of them may be cut off")
      .unit("px")
      .in(Range::atLeast(0));
  fields
      .add(
          "max_reprojection_error", &max_reprojection_error,
          "markers whose corners lie further from those of a square are rejected, root mean square")
      .unit("px")
      .in(Range::above(0));
  fields
      .add("max_relative_sigma", &max_relative_sigma,
           "markers whose horizontal position has a standard deviation over this share of their "
           "range are rejected: too far, or right above the camera")
      .unit("1")
      .in(Range::open(0, 1));
}

double FiducialConfig::sizeOf(LandmarkId id) const {
  const auto found = marker_sizes.find(id);
  return found == marker_sizes.end() ? marker_size : found->second;
}

bool FiducialConfig::isListed(LandmarkId id) const {
  return ids.empty() || std::count(ids.begin(), ids.end(), id) > 0;
}

}  // namespace slam::fiducial
