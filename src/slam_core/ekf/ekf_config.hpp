// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "slam_core/association/joint_map_config.hpp"
#include "slam_core/common/config_fields.hpp"
#include "slam_core/models/calibration.hpp"

namespace slam::ekf {

/// Which landmarks an update touches: those of the neighbourhood, or all.
enum class UpdateExtent { kCompressed, kDense };

struct EkfConfig : association::JointMapConfig {
  static constexpr const char* kSection = "ekf";

  std::string filter = "extended";
  std::string linearization = "right_invariant";
  int iterations = 5;
  UpdateExtent update = UpdateExtent::kCompressed;
  int neighbourhood = 64;
  CalibrationConfig calibration;  ///< a section of its own

  void describe(Fields& fields);
};

}  // namespace slam::ekf
