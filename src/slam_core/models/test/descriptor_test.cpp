// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/descriptor.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace slam {
namespace {

Descriptor constant(int elements, float value, float sigma, int sigmas) {
  return {Descriptor::Vector::Constant(elements, value),
          Descriptor::Vector::Constant(sigmas, sigma)};
}

TEST(Descriptor, CanBeUsedOrEmpty) {
  EXPECT_EQ(faultOf(Descriptor()), "");
  EXPECT_TRUE(Descriptor().isEmpty());
  EXPECT_EQ(faultOf(descriptorOf(0.2, 0.01)), "");
  EXPECT_EQ(faultOf(constant(8, 0.0F, 1.0F, 8)), "");
}

TEST(Descriptor, ThatCannotBeUsedIsReportedWithTheCause) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const auto* const not_a_number = " has a descriptor that holds a value that is not a number";
  EXPECT_EQ(faultOf(descriptorOf(kNan, 0.1)), not_a_number);
  EXPECT_EQ(faultOf(descriptorOf(0.1, kNan)), not_a_number);
  EXPECT_EQ(faultOf(descriptorOf(kInfinity, 0.1)), not_a_number);
  EXPECT_EQ(faultOf(descriptorOf(0.1, 0.0)), " has a descriptor with a sigma that is not positive");
  EXPECT_EQ(faultOf(descriptorOf(0.1, -0.1)),
            " has a descriptor with a sigma that is not positive");
  EXPECT_EQ(faultOf(descriptorOf(1e20, 0.1)),
            " has a descriptor beyond 1e+09, or a sigma below 1e-09");
  EXPECT_EQ(faultOf(constant(2, 0.1F, 0.1F, 1)), " has a descriptor of 2 elements and sigmas of 1");
  EXPECT_EQ(faultOf(constant(0, 0.1F, 0.1F, 1)), " has a descriptor of 0 elements and sigmas of 1");
  EXPECT_EQ(faultOf(constant(9, 0.1F, 0.1F, 9)), " has a descriptor of more than 8 elements");
}

}  // namespace
}  // namespace slam
