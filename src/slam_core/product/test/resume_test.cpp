// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "slam_core/common/random.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/contract/odometry_source.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/product/meta_coordinator.hpp"
#include "slam_core/product/test/ceiling_drive.hpp"
#include "slam_core/product/test/product_drives.hpp"
#include "slam_core/product/test/report_line.hpp"

namespace slam {
namespace {

using test::lineOf;
using test::ProductInput;

/// A product and the drive that it is resumed on.
struct ResumedProduct {
  std::string name;
  std::vector<std::string> settings;
  std::function<std::vector<ProductInput>(std::uint64_t seed)> inputs;
  int resumptions = 3;
};

std::unique_ptr<MetaCoordinator> made(const ResumedProduct& product) {
  Settings settings({}, {}, product.settings);
  auto coordinator = std::make_unique<MetaCoordinator>();
  coordinator->configure(settings);
  return coordinator;
}

std::string executed(MetaCoordinator& coordinator) {
  std::string lines;
  while (true) {
    const auto status = coordinator.execute();
    if (!status.isOk()) lines += status.message + "\n";
    if (!coordinator.estimator().report()) return lines;
    lines += lineOf(*coordinator.estimator().report());
  }
}

/// What a run has told until an input, and the product's state there.
struct Interruption {
  std::size_t inputs = 0;
  bool is_executed = false;  ///< the steps that the last input made due have been taken
  std::string state;
  std::string before;
};

class ResumeTest : public testing::TestWithParam<ResumedProduct> {
 protected:
  /// Runs without a stop, and notes the state in passing.
  void drive(const std::vector<ProductInput>& inputs, std::vector<Interruption>& stops) {
    const auto coordinator = made(GetParam());
    ASSERT_EQ(notResumable(coordinator->wiring()), "");
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      inputs[i](*coordinator);
      note(*coordinator, i + 1, false, stops);
      told_ += executed(*coordinator);
      note(*coordinator, i + 1, true, stops);
    }
    end_ = stateOf(*coordinator);
    counters_ = coordinator->counters().all();
  }
  void note(const MetaCoordinator& coordinator, std::size_t inputs, bool is_executed,
            std::vector<Interruption>& stops) const {
    for (auto& stop : stops) {
      if (stop.inputs != inputs || stop.is_executed != is_executed) continue;
      stop.state = stateOf(coordinator);
      stop.before = told_;
    }
  }

  std::string told_, end_;
  std::map<std::string, std::uint64_t> counters_;
};

std::vector<ProductInput> scans(std::uint64_t seed) { return test::scanInputs(seed, 60); }

std::vector<ProductInput> scansBesideImu(std::uint64_t seed) {
  return test::scanInputs(seed, 60, test::HangingImu(seed));
}

std::vector<ProductInput> lap(std::uint64_t seed) { return test::scanInputs(seed, 170); }

const std::vector<std::string> kSmallPf = {"backend=pf", "pf.particles=12"};

std::vector<std::string> with(std::vector<std::string> settings,
                              const std::vector<std::string>& more) {
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

std::vector<ResumedProduct> products() {
  using namespace test;
  const std::vector<std::string> visual = {"backend=ekf", "odometry=visual",
                                           "visual_odometry.ceiling_height=1.7"};
  return {
      {"ekf", {"backend=ekf"}, landmarkInputs},
      {"ekf_nearest", {"backend=ekf", "association=nearest"}, landmarkInputs},
      {"ekf_jcbb",
       {"backend=ekf", "association=jcbb", "ekf.linearization=right_invariant"},
       landmarkInputs},
      {"ekf_unscented",
       {"backend=ekf", "association=nearest", "ekf.filter=unscented"},
       landmarkInputs},
      {"ekf_carried_away", {"backend=ekf"}, carriedInputs},
      {"ekf_wheel_imu", {"backend=ekf", "odometry=wheel_imu"}, gyroInputs},
      {"ekf_command", {"backend=ekf", "odometry=command"}, commandInputs},
      {"grid", {"backend=grid", "map=grid"}, scans},
      {"grid_without_odometry", {"backend=grid", "map=grid", "odometry=none"}, scans},
      {"grid_laser_odometry", {"backend=grid", "map=grid", "odometry=laser"}, scans},
      {"grid_laser_wheel_odometry", {"backend=grid", "map=grid", "odometry=laser_wheel"}, scans},
      {"grid_laser_imu_odometry",
       {"backend=grid", "map=grid", "odometry=laser_imu"},
       scansBesideImu},
      {"pf", kSmallPf, landmarkInputs},
      {"pf_kld", with(kSmallPf, {"pf.size=kld", "pf.min_particles=5"}), landmarkInputs},
      {"pf_nearest", with(kSmallPf, {"association=nearest"}), landmarkInputs},
      {"pf_grid", with(kSmallPf, {"map=grid"}), scans, 2},
      {"graph", {"backend=graph"}, landmarkInputs},
      {"seif", {"backend=seif", "seif.interval_nodes=5"}, landmarkInputs},
      {"seif_nearest",
       {"backend=seif", "association=nearest", "seif.interval_nodes=5"},
       landmarkInputs},
      {"seif_carried_away", {"backend=seif"}, carriedInputs},
      {"graph_nearest", {"backend=graph", "association=nearest"}, landmarkInputs},
      {"graph_carried_away", {"backend=graph"}, carriedInputs},
      {"graph_grid", {"backend=graph", "map=grid", "graph.submap_way=1.5"}, lap, 2},
      {"visual", visual, ceilingInputs},
      {"visual_tracked", with(visual, {"visual_odometry.features=klt"}), ceilingInputs},
      {"visual_imu", with(visual, {"odometry=visual_imu"}), ceilingInputs},
      {"visual_wheel", with(visual, {"odometry=visual_wheel"}), ceilingInputs},
      {"ceiling",
       {"backend=ekf", "detector=ceiling_features", "association=descriptor",
        "ceiling_camera.ceiling_height=1.7"},
       ceilingInputs},
      {"trunks", {"backend=ekf", "detector=laser_trunks", "association=nearest"}, scans},
      {"pointmap", {"backend=grid", "map=grid", "pointmap=true"}, scans},
      {"pointmap_aligned",
       {"backend=grid", "map=grid", "pointmap=true", "point_map.fusion=aligned"},
       scans},
  };
}

INSTANTIATE_TEST_SUITE_P(Products, ResumeTest, testing::ValuesIn(products()),
                         [](const auto& product) { return product.param.name; });

TEST_P(ResumeTest, GoesOnBitByBitAsIfNeverStopped) {
  const auto inputs = GetParam().inputs(7);
  RandomStream random(5, 0);
  std::vector<Interruption> stops(static_cast<std::size_t>(GetParam().resumptions));
  for (auto& stop : stops) {
    stop.inputs = 1 + static_cast<std::size_t>(random.uniform() * double(inputs.size() - 1));
    stop.is_executed = random.uniform() < 0.5;
  }
  drive(inputs, stops);
  for (const auto& stop : stops) {
    const auto coordinator = made(GetParam());
    restore(stop.state, *coordinator);
    EXPECT_TRUE(stateOf(*coordinator) == stop.state) << "after " << stop.inputs;
    auto told = stop.before;
    if (!stop.is_executed) told += executed(*coordinator);
    for (std::size_t i = stop.inputs; i < inputs.size(); ++i) {
      inputs[i](*coordinator);
      told += executed(*coordinator);
    }
    EXPECT_EQ(told, told_) << "after " << stop.inputs;
    EXPECT_TRUE(stateOf(*coordinator) == end_) << "after " << stop.inputs;
    EXPECT_EQ(coordinator->counters().all(), counters_);
  }
}

TEST_P(ResumeTest, ACutStateIsRefusedAndTheProductCanBeConfiguredAnew) {
  auto inputs = GetParam().inputs(3);
  inputs.resize(inputs.size() / 4);
  std::vector<Interruption> stops(1);
  stops[0].inputs = inputs.size();
  drive(inputs, stops);
  const auto& state = stops[0].state;
  const auto coordinator = made(GetParam());
  for (std::size_t part = 0; part < 40; ++part) {
    const auto cut = state.substr(0, state.size() * part / 40);
    EXPECT_THROW(restore(cut, *coordinator), std::runtime_error) << part;
  }
  EXPECT_THROW(restore(state + '\0', *coordinator), std::runtime_error);
  Settings settings({}, {}, GetParam().settings);
  coordinator->configure(settings);
  std::string told;
  for (const auto& input : inputs) {
    input(*coordinator);
    told += executed(*coordinator);
  }
  EXPECT_EQ(told, told_);
}

/// A source of odometry that somebody else has written.
class OwnOdometry final : public OdometrySource {
 public:
  void describe(Ports& ports) override { ports.makes<Motion>("motion", motion_); }
  void configure(Settings&) override {}
  Status execute() override { return Status::ok(); }
  const std::optional<Motion>& motion() const override { return motion_; }
  Counters counters() const override { return {}; }
  void reset() override {}

 private:
  std::optional<Motion> motion_;
};

const Registrar<OdometrySource, OwnOdometry> kOwnOdometry("own_odometry");

TEST(Resume, NamesTheComponentThatCannotBeResumed) {
  Settings settings({}, {}, {"odometry=own_odometry"});
  MetaCoordinator coordinator;
  coordinator.configure(settings);
  EXPECT_EQ(notResumable(coordinator.wiring()), "odometry source 'own_odometry'");
}

/// Time begins anew with the map that the first part of the run was given.
TEST(Resume, KeepsTheMapThatTheRunBeganWith) {
  Settings settings;
  MetaCoordinator first, second;
  first.configure(settings);
  second.configure(settings);
  MapState map;
  map.landmarks.resize(2);
  map.landmarks[0].id = 7;
  map.landmarks[1].id = 9;
  map.landmarks[1].position = {3.0, 1.0};
  for (auto& landmark : map.landmarks) landmark.covariance.setIdentity();
  ASSERT_NE(first.estimator().startWith(map).level, Status::Level::kError);
  restore(stateOf(first), second);
  second.reset();
  EXPECT_EQ(second.estimator().capabilities().find<LandmarkMapper>()->landmarks().size(), 2u);
}

}  // namespace
}  // namespace slam
