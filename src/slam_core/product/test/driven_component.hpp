// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "slam_core/contract/registry.hpp"
#include "slam_core/models/filter_pose.hpp"
#include "slam_core/models/odometry_sample.hpp"
#include "slam_core/models/test/simulated_room.hpp"
#include "slam_core/models/velocity_command.hpp"
#include "slam_core/product/test/component_driver.hpp"

// The contracts of odometry sources, detectors and additional modules share this file. The contract
// of back-ends is in backend_contract.hpp.

namespace slam::test {

/// A component of a role by its name in the registry, and settings that change how it works.
struct RoleVariant {
  std::string component, name;
  std::vector<std::string> settings = {};
};

inline std::string roleVariantName(const testing::TestParamInfo<RoleVariant>& variant) {
  return variant.param.name;
}

/// A component of a role, driven through a room: it gets what it takes in of the wheels' odometry,
/// the commands, the motion, the laser's scans and the back-end's poses, in this order.
template <class Role>
class DrivenComponent {
 public:
  explicit DrivenComponent(const RoleVariant& variant)
      : variant_(variant),
        component_(Registry<Role>::instance().create(variant.component)),
        inputs_(*component_) {
    configure();
  }

  void configure() {
    Settings settings({}, {}, variant_.settings);
    component_->configure(settings);
  }
  /// @param took is called after each execute()
  template <class Took>
  void step(const RoomDrive::Step& step, Took took) {
    OdometrySample sample;
    sample.stamp = step.motion.end;
    sample.pose = step.motion.odometry_end;
    sample.odometry_frame = step.motion.odometry_frame;
    sample.base_frame = step.motion.base_frame;
    give(sample, took);
    const double interval = seconds(step.motion.end - step.motion.start);
    give(VelocityCommand{step.motion.start, step.motion.increment.log() / interval}, took);
    give(step.motion, took);
    give(step.scan, took);
    give(FilterPose::of(step.scan.stamp, step.truth), took);
  }
  template <class Took>
  void run(std::uint64_t seed, int steps, Took took) {
    RoomDrive drive(seed);
    for (int i = 0; i < steps; ++i) step(drive.next(), took);
  }
  void run(std::uint64_t seed, int steps) {
    run(seed, steps, [] {});
  }

  const ComponentDriver& inputs() const { return inputs_; }
  Role& operator*() const { return *component_; }
  Role* operator->() const { return component_.get(); }

 private:
  template <class Value, class Took>
  void give(const Value& value, Took took) {
    if (!inputs_.takes<Value>()) return;
    inputs_.set(value);
    do {
      const auto status = component_->execute();
      ASSERT_TRUE(status.isOk()) << status.message;
      took();
    } while (component_->isBusy());
  }

  RoleVariant variant_;
  std::unique_ptr<Role> component_;
  ComponentDriver inputs_;
};

/// Components that have to do the same from here on: a new one, and two that were driven elsewhere,
/// one then reset, the other configured again.
template <class Role>
struct RestartedComponents {
  explicit RestartedComponents(const RoleVariant& variant)
      : fresh(variant), reset(variant), configured(variant) {
    reset.run(4, 30);
    reset->reset();
    EXPECT_TRUE(reset->counters().all().empty());
    configured.run(4, 30);
    configured.configure();
  }
  DrivenComponent<Role> fresh, reset, configured;
};

}  // namespace slam::test
