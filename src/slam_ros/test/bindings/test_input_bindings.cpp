// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "slam_core/common/config_error.hpp"
#include "slam_ros/input_bindings.hpp"

namespace slam_ros {
namespace {

struct Sonar {};

std::string faultOf(const InputBindings& bindings) {
  try {
    bindings.createInBag(BagContext(), "sonar", slam::kindOf<Sonar>());
  } catch (const slam::ConfigError& error) {
    return error.what();
  }
  return "";
}

const InputBindings::Binding kNothing{[](const auto&, const auto&) { return nullptr; },
                                      [](const auto&, const auto&) { return nullptr; }};

TEST(InputBindings, OneForAKindIsAsked) {
  InputBindings bindings;
  bindings.add(slam::kindOf<Sonar>(), kNothing);
  EXPECT_TRUE(bindings.has(slam::kindOf<Sonar>()));
  EXPECT_EQ(faultOf(bindings), "");
}

TEST(InputBindings, TwoForOneKindAreRefused) {
  InputBindings bindings;
  for (int i = 0; i < 2; ++i) bindings.add(slam::kindOf<Sonar>(), kNothing);
  EXPECT_EQ(faultOf(bindings), "2 bindings bring data for the input 'sonar' (" +
                                   slam::nameOf(slam::kindOf<Sonar>()) +
                                   "); leave all but one of their libraries out of the product");
  EXPECT_EQ(bindings.kinds().size(), 1u) << "a kind is listed once";
}

TEST(InputBindings, AKindThatNobodyBringsIsToldWithThoseThereAre) {
  InputBindings bindings;
  bindings.add(slam::kindOf<int>(), kNothing);
  const auto fault = faultOf(bindings);
  EXPECT_NE(fault.find("no binding brings them from a topic; there are bindings for int: name the "
                       "library that has one"),
            std::string::npos)
      << fault;
}

TEST(InputBindings, WhatRobotFilesNameHasOne) {
  for (const auto& [input, kind] : TopicsConfig::inputs())
    EXPECT_TRUE(InputBindings::instance().has(kind)) << input;
}

/// What a robot file with this name of a topic is refused with.
std::string faultOfTopic(const std::string& name) {
  TopicsConfig topics;
  topics.scan = name;
  try {
    slam::validate(topics);
  } catch (const slam::ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(TopicsConfig, RefusesNamesThatRosCouldNotUse) {
  for (const auto* name : {"scan", "/scan", "robot1/base_scan", "/2d/scan"})
    EXPECT_EQ(faultOfTopic(name), "") << name;
  EXPECT_EQ(
      faultOfTopic(""),
      "topics.scan: '' is no name of a topic; write letters, digits, '_' and '/' between them, "
      "with a letter or '/' first");
  for (const auto* name : {"/", "scan/", "a//b", "~scan", "2d", "_scan", "base scan", "base-scan"})
    EXPECT_NE(faultOfTopic(name), "") << name;
}

}  // namespace
}  // namespace slam_ros
