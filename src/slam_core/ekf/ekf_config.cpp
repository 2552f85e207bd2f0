// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/ekf_config.hpp"

#include "slam_core/ekf/gaussian_transform.hpp"
#include "slam_core/ekf/linearization.hpp"
#include "slam_core/models/landmark_map.hpp"

namespace slam::ekf {

void EkfConfig::describe(Fields& fields) {
  fields.add("mode", &mode, backendModeNames(),
             "build the map, or keep a loaded one fixed and only localise in it");
  fields
      .add("filter", &filter,
           "how the Gaussian passes through motion and observation: by Jacobians (extended Kalman "
           "filter), or by sigma points (unscented Kalman filter)")
      .oneOf(transformNames());
  fields
      .add("linearization", &linearization,
           "where the Jacobians are evaluated and which error the covariance describes")
      .oneOf(linearizationNames());
  fields
      .add("iterations", &iterations,
           "an update is linearised at most so often, until its observations are linear in the "
           "correction")
      .unit("1")
      .in(Range::closed(1, 50));
  fields.add("update", &update,
             {{"compressed", UpdateExtent::kCompressed}, {"dense", UpdateExtent::kDense}},
             "compressed: an update touches only the landmarks of the neighbourhood; dense: all");
  fields
      .add("neighbourhood", &neighbourhood,
           "after so many different landmarks, or twice as many as are in view, the whole map is "
           "brought up to date and a new neighbourhood begins")
      .unit("1")
      .in(Range::atLeast(1));
  places.describe(fields);
  fields
      .add("gate_probability", &gate_probability,
           "an observation is left out when a right one would lie nearer with this probability")
      .unit("1")
      .in(Range::open(0, 1));
  fields
      .add("initial_sigma_position", &initial_sigma_position,
           "standard deviation of the first position; the first pose defines the map frame")
      .unit("m")
      .in({0, kLargestSigmaPosition, true, false});
  fields
      .add("initial_sigma_heading", &initial_sigma_heading,
           "standard deviation of the first heading; with pi nothing is known of it")
      .unit("rad")
      .in({0, kLargestSigmaHeading, true, false});
  fields
      .add("load_inflation", &load_inflation,
           "factor on the standard deviations of a loaded map that has no joint covariance")
      .unit("1")
      .in(Range::atLeast(1));
  fields
      .add("joint_limit", &joint_limit,
           "a map of more landmarks is saved without its joint covariance, which would fill a file "
           "of hundreds of megabytes")
      .unit("1")
      .in(Range::atLeast(0));
}

}  // namespace slam::ekf
