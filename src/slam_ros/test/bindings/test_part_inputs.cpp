// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "slam_ros/part_inputs.hpp"

namespace slam_ros {
namespace {

struct Ping {};
struct Depth {};
struct Transducer {};

/// Waits for something for ever.
class Silent final : public InputBinding {
 public:
  explicit Silent(std::string topic) : topic_(std::move(topic)) {}
  const std::string& topic() const override { return topic_; }
  std::string waiting() const override { return "waiting for " + topic_; }

 private:
  std::string topic_;
};

template <class T>
slam::InputPort portOf(const std::string& name) {
  slam::Ports ports;
  return ports.takes<T>(name, "data", [](const T&) {});
}

class PartInputsTest : public testing::Test {
 protected:
  PartInputsTest() {
    inputs.add(portOf<Ping>("sonar"), std::make_unique<Silent>("pings"));
    inputs.add(portOf<Depth>("sonar"), std::make_unique<Silent>("depths"));
    inputs.add(portOf<Depth>("lead").optional(), std::make_unique<Silent>("lead"));
  }

  PartInputs inputs;
};

TEST_F(PartInputsTest, OneNameOfTwoKindsHasTwoBindings) {
  EXPECT_EQ(inputs.of("sonar", slam::kindOf<Ping>()).topic(), "pings");
  EXPECT_EQ(inputs.of("sonar", slam::kindOf<Depth>()).topic(), "depths");
  EXPECT_TRUE(inputs.takes("sonar", slam::kindOf<Ping>()));
  EXPECT_FALSE(inputs.takes("lead", slam::kindOf<Ping>()));
}

TEST_F(PartInputsTest, WhatComesAlongIsBroughtByABindingOfTheSameName) {
  EXPECT_FALSE(inputs.takes("lead", slam::kindOf<Transducer>()));
  EXPECT_EQ(inputs.of("lead", slam::kindOf<Transducer>()).topic(), "lead");
  EXPECT_THROW(inputs.of("plummet", slam::kindOf<Depth>()), std::out_of_range);
}

TEST_F(PartInputsTest, WaitForEachKindOfAMandatoryInputThatIsNotNeedless) {
  EXPECT_EQ(inputs.waiting(), "waiting for pings");
  EXPECT_EQ(inputs.waiting({portOf<Ping>("sonar")}), "waiting for depths");
  EXPECT_EQ(inputs.waiting({portOf<Depth>("sonar")}), "waiting for pings");
  EXPECT_EQ(inputs.waiting({portOf<Ping>("sonar"), portOf<Depth>("sonar")}), "")
      << "the third one is optional";
}

}  // namespace
}  // namespace slam_ros
