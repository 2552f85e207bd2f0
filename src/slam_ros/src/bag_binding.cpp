// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/bag_binding.hpp"

namespace slam_ros {

BagBindings& BagBindings::instance() {
  static BagBindings bindings;
  return bindings;
}

const BagBinding* BagBindings::find(slam::Kind kind) const {
  const auto found = bindings_.find(kind);
  return found == bindings_.end() ? nullptr : &found->second;
}

}  // namespace slam_ros
