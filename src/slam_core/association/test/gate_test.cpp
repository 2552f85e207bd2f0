// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/gate.hpp"

#include <gtest/gtest.h>

namespace slam::association {
namespace {

/// From tables of the chi-square distribution with 2, 4, 10 and 40 degrees of freedom.
TEST(JointGate, IsTheQuantileOfTheChiSquareDistribution) {
  EXPECT_NEAR(jointGateOf(0.95, 1), 5.991, 1e-3);
  EXPECT_NEAR(jointGateOf(0.95, 2), 9.488, 1e-3);
  EXPECT_NEAR(jointGateOf(0.95, 5), 18.307, 1e-3);
  EXPECT_NEAR(jointGateOf(0.999, 20), 73.402, 1e-3);
  EXPECT_EQ(jointGateOf(0.9999, 1), gateOf(0.9999));
}

}  // namespace
}  // namespace slam::association
