// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "part_ports.hpp"

namespace slam_pipes {
namespace {

/// "maker -> taker: port", a line for each.
std::string pipesOf(const slam::ProductConfig& product) {
  const auto parts = partsOf(product);
  std::string all;
  for (const auto& maker : parts)
    for (const auto& taker : parts)
      for (const auto& input : maker.inputsOf(taker))
        all += maker.key + " -> " + taker.key + ": " + input.name + "\n";
  return all;
}

TEST(PartPorts, SayWhichPipesThereAre) {
  slam::ProductConfig product;
  product.detector = "apriltag";
  EXPECT_EQ(pipesOf(product), "odometry -> backend: motion\ndetector -> backend: observations\n");
  product.modules["pointmap"] = true;
  EXPECT_EQ(pipesOf(product),
            "odometry -> backend: motion\nodometry -> pointmap: motion\n"
            "detector -> backend: observations\nbackend -> pointmap: pose\n");
}

TEST(PartPorts, OfAPartAreThoseOfItsInputGates) {
  slam::ProductConfig product;
  product.backend = "pf";
  product.map = slam::MapKind::kGrid;
  const auto parts = partsOf(product);
  const auto* backend = findPart(parts, "backend");
  ASSERT_NE(backend, nullptr);
  EXPECT_TRUE(backend->isBackend());
  EXPECT_NE(backend->input("scan", "slam::LaserSweep"), nullptr);
  EXPECT_NE(backend->input("scan", "slam::LaserMount"), nullptr);
  EXPECT_EQ(backend->input("scan", "slam::LaserScan"), nullptr);
  EXPECT_EQ(findPart(parts, "detector"), nullptr);
}

TEST(PartPorts, OfEveryShippedKindCanCrossAPipe) {
  for (const std::string odometry : {"wheel", "wheel_imu", "command", "visual_wheel", "visual_imu",
                                     "laser_wheel", "laser_imu"}) {
    slam::ProductConfig product;
    product.odometry = odometry;
    product.detector = "apriltag";
    product.modules["pointmap"] = true;
    for (const auto& part : partsOf(product))
      for (const auto& input : part.inputs) EXPECT_NO_THROW(requirePersistent(input, part));
  }
}

TEST(PartPorts, WithoutPersistAreRefused) {
  slam::ProductConfig product;
  const auto parts = partsOf(product);
  auto input = parts.front().inputs.front();
  input.traits.save = nullptr;
  try {
    requirePersistent(input, parts.front());
    FAIL();
  } catch (const slam::ConfigError& error) {
    EXPECT_STREQ(
        error.what(),
        "'odom' (slam::OdometrySample), which the odometry source 'wheel' takes in, cannot "
        "cross a pipe: give the type a persist(), or run the product without --middleware "
        "pipes");
  }
}

}  // namespace
}  // namespace slam_pipes
