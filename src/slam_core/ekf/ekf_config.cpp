// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/ekf/ekf_config.hpp"

#include "slam_core/ekf/gaussian_transform.hpp"
#include "slam_core/ekf/linearization.hpp"

namespace slam::ekf {

void EkfConfig::describe(Fields& fields) {
  JointMapConfig::describe(fields);
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
}

}  // namespace slam::ekf
