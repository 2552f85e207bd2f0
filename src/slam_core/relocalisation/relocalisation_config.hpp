// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/config_fields.hpp"

namespace slam::relocalisation {

struct RelocalisationConfig {
  static constexpr const char* kSection = "relocalisation";

  bool enabled = true;
  double odds = 100.0;
  double outlier_share = 0.05;
  double confirmation = 1.0;
  double local_way = 4.0;
  double search_distance = 0.5;

  void describe(Fields& fields);
};

}  // namespace slam::relocalisation
