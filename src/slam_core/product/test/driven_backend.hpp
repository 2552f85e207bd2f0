// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/map_keeper.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/models/test/simulated_room.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/test/component_driver.hpp"

namespace slam::test {

/// A simulated robot that drives round and round.
class SimulatedDrive {
 public:
  virtual ~SimulatedDrive() = default;
  /// Sets what the sensors gave in the next interval. @return T_map_base at its end
  virtual Pose2 give(ComponentDriver& inputs) = 0;
  virtual int stepsOfALap() const = 0;
};

using MakeDrive = std::function<std::unique_ptr<SimulatedDrive>(std::uint64_t seed)>;

/// A world whose steps give motion, where it is taken, and what one sensor sees.
/// @tparam kSensor the member of a step that the sensor gives @tparam kStepsOfALap once round
template <class World, auto kSensor, int kStepsOfALap>
class DriveThrough final : public SimulatedDrive {
 public:
  explicit DriveThrough(std::uint64_t seed) : world_(seed) {}

  Pose2 give(ComponentDriver& inputs) override {
    const auto step = world_.next();
    inputs.offer(step.motion);
    inputs.set(step.*kSensor);
    return step.truth;
  }
  int stepsOfALap() const override { return kStepsOfALap; }

 private:
  World world_;
};

using LandmarkDrive = DriveThrough<SimulatedWorld, &SimulatedStep::observations, 126>;
using ScanDrive = DriveThrough<RoomDrive, &RoomDrive::Step::scan, 145>;

/// A back-end as it comes, or with settings that change how it works.
struct Variant {
  std::string backend, name;
  std::vector<std::string> settings;
  std::optional<MapKind> map = {};  ///< of a back-end that has several to choose from
  /// What it is driven by. Empty: scans where it takes them, else landmarks.
  MakeDrive drive = nullptr;
};

inline std::string variantName(const testing::TestParamInfo<Variant>& variant) {
  return variant.param.name;
}

/// A back-end as contracts see it: its inputs are its ports, what it can do are its capabilities.
class DrivenBackend {
 public:
  explicit DrivenBackend(const Variant& variant)
      : variant_(variant),
        backend_(created(variant)),
        inputs_(*backend_),
        capabilities_(capabilitiesOf(*backend_)) {
    configure();
  }

  void configure() {
    Settings settings({}, {}, variant_.settings);
    backend_->configure(settings);
  }
  /// @return T_map_base after the step
  Pose2 step(SimulatedDrive& drive) {
    const auto truth = drive.give(inputs_);
    execute();
    return truth;
  }
  void run(std::uint64_t seed, int steps) {
    const auto drive = this->drive(seed);
    for (int i = 0; i < steps; ++i) step(*drive);
  }
  void execute() {
    const auto status = backend_->execute();
    ASSERT_TRUE(status.isOk()) << status.message;
  }
  std::unique_ptr<SimulatedDrive> drive(std::uint64_t seed) const {
    if (variant_.drive) return variant_.drive(seed);
    if (inputs_.takes<LaserScan>()) return std::make_unique<ScanDrive>(seed);
    return std::make_unique<LandmarkDrive>(seed);
  }

  Backend& operator*() const { return *backend_; }
  Backend* operator->() const { return backend_.get(); }
  ComponentDriver& inputs() { return inputs_; }
  /// Null where it is not offered.
  template <class Capability>
  Capability* find() const {
    return capabilities_.find<Capability>();
  }
  template <class Capability>
  Capability& as() const {
    return *capabilities_.find<Capability>();
  }

 private:
  static std::unique_ptr<Backend> created(const Variant& variant) {
    auto backend = Registry<Backend>::instance().create(variant.backend);
    if (variant.map) capabilitiesOf(*backend).find<MapChooser>()->useMap(*variant.map);
    return backend;
  }

  Variant variant_;
  std::unique_ptr<Backend> backend_;
  ComponentDriver inputs_;
  Capabilities capabilities_;
};

/// Those of the variants that offer a capability.
template <class Capability>
std::vector<Variant> offering(const std::vector<Variant>& variants) {
  std::vector<Variant> able;
  for (const auto& variant : variants)
    if (DrivenBackend(variant).find<Capability>() != nullptr) able.push_back(variant);
  return able;
}

/// The fixture of all contracts.
class ContractTest : public testing::TestWithParam<Variant> {
 protected:
  static DrivenBackend make() { return DrivenBackend(GetParam()); }
};

}  // namespace slam::test
