// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/test/fuzz/fuzz_target.hpp"
#include "slam_core/product/test/fuzz/fuzz_drive.hpp"

/// Odometry and a laser's sweeps, maps and poses, in products that use scans.
SLAM_FUZZ_TARGET(scan_drive) {
  static const std::string kCoarse = "grid_map.resolution=0.2";  // takes a fraction of the time
  static const std::vector<slam::test::FuzzedProduct> kProducts = {
      {{"backend=grid", "map=grid", kCoarse}, true, 15},
      {{"backend=grid", "map=grid", "odometry=laser_wheel", "pointmap=true", kCoarse}, true, 15},
      {{"backend=grid", "map=grid", "odometry=laser", kCoarse}, true, 15},
      {{"backend=pf", "map=grid", "pf.particles=2", kCoarse}, true, 10},
      {{"backend=graph", "map=grid", kCoarse}, true, 10},
      {{"backend=ekf", "detector=laser_trunks", "association=nearest"}, true, 20},
      {{"backend=ekf", "detector=laser_corners", "association=nearest"}, true, 20},
      {{"backend=ekf", "detector=laser_lines", "association=nearest"}, true, 20}};
  slam::test::driveOneOf(kProducts, {bytes, size});
}
