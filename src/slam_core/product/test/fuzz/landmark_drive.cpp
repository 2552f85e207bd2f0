// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/test/fuzz/fuzz_target.hpp"
#include "slam_core/product/test/fuzz/fuzz_drive.hpp"

/// Odometry, motions and observations of landmarks, maps and poses, in products with landmarks.
SLAM_FUZZ_TARGET(landmark_drive) {
  static const std::vector<slam::test::FuzzedProduct> kProducts = {
      {{"backend=ekf"}, false, 40},
      {{"backend=ekf", "association=jcbb"}, false, 30},
      {{"backend=ekf", "association=nearest"}, false, 30},
      {{"backend=pf", "pf.particles=5"}, false, 40},
      {{"backend=pf", "pf.particles=5", "association=nearest"}, false, 30},
      {{"backend=graph"}, false, 30},
      {{"backend=graph", "association=nearest"}, false, 30}};
  slam::test::driveOneOf(kProducts, {bytes, size});
}
