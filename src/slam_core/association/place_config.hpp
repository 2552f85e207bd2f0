// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "slam_core/common/config_fields.hpp"

namespace slam::association {

/// What the policies that go by places have in common; part of a back-end's configuration, where
/// each key begins with `association_`.
struct PlaceConfig {
  double ring = 1.5;
  double ambiguity = 6.0;
  int nodes = 2000;
  int sightings = 3;

  void describe(Fields& fields);
};

/// All that a policy gets at the beginning.
struct PolicyConfig {
  double gate_probability = 0.9999;  ///< that a right observation lies within the gate, in (0, 1)
  PlaceConfig places;
};

}  // namespace slam::association
