// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/feature_file.hpp"

#include <gtest/gtest.h>

namespace slam {
namespace {

TEST(FeatureTable, HasALineForEachFeature) {
  MappedFeature feature;
  feature.id = 7;
  feature.position = {1.5, -2.0, 0.65};
  feature.covariance = Eigen::Vector3d(0.04, 0.01, -1e-18).asDiagonal();
  EXPECT_EQ(featureTable({feature}),
            "id,x,y,z,sigma_x,sigma_y,sigma_z\n"
            "7,1.500000,-2.000000,0.650000,0.200000,0.100000,0.000000\n");
  EXPECT_EQ(featureTable({}), "id,x,y,z,sigma_x,sigma_y,sigma_z\n");
}

}  // namespace
}  // namespace slam
