// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

#include "slam_core/contract/registry.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/estimator.hpp"
#include "slam_core/product/run_writer.hpp"
#include "slam_core/product/test/component_driver.hpp"

namespace slam {
namespace {

using test::SimulatedStep;
using test::SimulatedWorld;

/// The EKF, which a scan only leads on to its stamp.
class EkfCarriedByScans : public Backend {
 public:
  void configure(Settings& settings) override { ekf_->configure(settings); }
  void describe(Ports& ports) override {
    ekf_->describe(ports);
    ports.takes<LaserScan>("scan", "laser scans",
                           [this](const LaserScan& scan) { beams_ += scan.beams.size(); });
  }
  void describe(Capabilities& capabilities) override { ekf_->describe(capabilities); }
  void set(const PoseEstimate& initial_pose) override { ekf_->set(initial_pose); }
  Status execute() override { return ekf_->execute(); }
  PoseEstimate pose() const override { return ekf_->pose(); }
  Counters counters() const override { return ekf_->counters(); }
  Figures figures() const override { return {{"beams", static_cast<double>(beams_)}}; }
  void reset() override { ekf_->reset(); }

 private:
  std::unique_ptr<Backend> ekf_ = Registry<Backend>::instance().create("ekf");
  std::size_t beams_ = 0;
};

class EstimatorScansTest : public testing::Test {
 protected:
  void SetUp() override { configure(std::make_unique<EkfCarriedByScans>()); }
  void configure(std::unique_ptr<Backend> backend) {
    Settings settings;
    estimator.use(std::move(backend));
    estimator.configure(settings);
    text.clear();
  }
  void drain() {
    do {
      const auto status = estimator.execute();
      if (!status.isOk()) warning = status.message;
      if (!estimator.report()) return;
      const auto& report = *estimator.report();
      text += report.trigger == "scan" ? "s" : "o";
      trajectory += tumLine(report.stamp, report.pose.pose);
      last = report;
    } while (true);
  }
  static LaserScan scanAt(Stamp stamp, std::uint64_t sequence) {
    LaserScan scan;
    scan.stamp = stamp;
    scan.sequence = sequence;
    scan.beams = {{0.1f, 2.0f, true}, {0.2f, 3.0f, false}};
    return scan;
  }
  double beams() const { return test::figureOf(estimator, "beams"); }

  Estimator estimator;
  std::string text;        ///< o and s: steps of observations and scans
  std::string trajectory;  ///< of all steps
  std::string warning;
  StepReport last;
};

TEST_F(EstimatorScansTest, TakesObservationsBeforeAScanOfTheSameStamp) {
  SimulatedWorld world(1);
  for (std::uint64_t i = 0; i < 3; ++i) {
    const auto step = world.next();
    estimator.set(step.motion);
    estimator.set(scanAt(step.observations.stamp, i));
    drain();
    estimator.set(step.observations);
    drain();
  }
  EXPECT_EQ(text, "ososos");
  EXPECT_EQ(beams(), 6);
}

TEST_F(EstimatorScansTest, GivesTheSameWhateverTheOrderOfArrival) {
  std::vector<SimulatedStep> steps;
  SimulatedWorld world(1);
  for (int i = 0; i < 60; ++i) steps.push_back(world.next());
  std::string expected;
  for (std::uint64_t shuffle = 0; shuffle < 20; ++shuffle) {
    configure(std::make_unique<EkfCarriedByScans>());
    trajectory.clear();
    RandomStream random(3, shuffle);
    std::array<std::size_t, 3> next{};
    while (next[0] + next[1] + next[2] < 3 * steps.size()) {
      const auto source = static_cast<std::size_t>(3 * random.uniform()) % 3;
      if (next[source] == steps.size()) continue;
      // no source runs ahead of the others as far as the time-out
      if (next[source] > *std::min_element(next.begin(), next.end()) + 7) continue;
      const auto& step = steps[next[source]];
      if (source == 0) estimator.set(step.motion);
      if (source == 1) estimator.set(step.observations);
      if (source == 2)
        estimator.set(scanAt(step.observations.stamp - std::chrono::milliseconds(30), next[2]));
      ++next[source];
      drain();
    }
    if (shuffle == 0) expected = trajectory;
    ASSERT_EQ(trajectory, expected) << "shuffle " << shuffle;
    ASSERT_EQ(text.size(), 2 * steps.size() - 1) << "an observation waits for the next scan";
  }
}

TEST_F(EstimatorScansTest, WithoutLandmarksScansWaitOnceForTheTimeOut) {
  SimulatedWorld world(1);
  for (std::uint64_t i = 0; i < 30; ++i) {
    const auto step = world.next();
    estimator.set(step.motion);
    estimator.set(scanAt(step.motion.end, i));
    drain();
    EXPECT_EQ(text.size(), i < 10 ? 0 : i + 1) << "after a second nobody waits any more";
  }
}

TEST_F(EstimatorScansTest, WithoutLandmarksToExpectScansDoNotWait) {
  estimator.intake().expectNothing("observations");
  for (int run = 0; run < 2; ++run) {
    text.clear();
    SimulatedWorld world(1);
    for (std::uint64_t i = 0; i < 5; ++i) {
      const auto step = world.next();
      estimator.set(step.motion);
      estimator.set(scanAt(step.motion.end, i));
      drain();
    }
    EXPECT_EQ(text, "sssss");
    estimator.reset();
  }
}

TEST_F(EstimatorScansTest, PausedIgnoresScansAndStillMoves) {
  estimator.intake().expectNothing("observations");
  estimator.pause(true);
  const auto step = SimulatedWorld(1).next();
  estimator.set(step.motion);
  estimator.set(scanAt(step.motion.end, 0));
  drain();
  EXPECT_EQ(text, "s");
  EXPECT_EQ(beams(), 0);
  EXPECT_GT(last.pose.pose.x(), 0.1);
  EXPECT_EQ(estimator.counters()["paused"], 1u);
}

TEST_F(EstimatorScansTest, TakesAScanWithValuesThatAreNoneAsEmpty) {
  estimator.intake().expectNothing("observations");
  const auto step = SimulatedWorld(1).next();
  estimator.set(step.motion);
  auto scan = scanAt(step.motion.end, 0);
  scan.beams[1].range = std::numeric_limits<float>::quiet_NaN();
  estimator.set(scan);
  drain();
  EXPECT_EQ(text, "s");
  EXPECT_EQ(beams(), 0);
  EXPECT_EQ(estimator.counters()["invalid_scan"], 1u);
  EXPECT_NE(warning.find("taken as empty"), std::string::npos) << warning;
}

TEST_F(EstimatorScansTest, SaysWhatWaitsForMotionThatHasStopped) {
  estimator.intake().expectNothing("observations");
  SimulatedWorld world(1);
  const auto first = world.next();
  estimator.set(first.motion);
  for (std::uint64_t i = 0; i < 40; ++i) {
    EXPECT_EQ(estimator.intake().arrivals().starving, "") << i;
    estimator.set(
        scanAt(first.motion.end + std::chrono::milliseconds(100) * static_cast<int>(i), i));
    drain();
    if (i == 31) break;
  }
  EXPECT_EQ(text, "s");
  EXPECT_EQ(estimator.intake().arrivals().starving.find("laser scans since "), 0u)
      << estimator.intake().arrivals().starving;
  EXPECT_NE(estimator.intake().arrivals().starving.find(" wait for motion"), std::string::npos);
  EXPECT_EQ(estimator.intake().arrivals().held()["laser scans"], 31u);
  auto array = first.observations;
  array.stamp = first.motion.end + std::chrono::seconds(4);
  estimator.set(array);
  EXPECT_EQ(estimator.intake().arrivals().starving.find("landmarks and laser scans since "), 0u);
  EXPECT_EQ(estimator.intake().arrivals().held()["landmarks"], 1u);
  estimator.reset();
  EXPECT_EQ(estimator.intake().arrivals().starving, "");
}

TEST_F(EstimatorScansTest, ABackEndThatUsesNoScansIsNotHeldBackByThem) {
  configure(Registry<Backend>::instance().create("ekf"));
  const auto step = SimulatedWorld(1).next();
  estimator.set(step.motion);
  estimator.set(scanAt(step.motion.start, 0));
  estimator.set(step.observations);
  drain();
  EXPECT_EQ(text, "o");
}

TEST(EstimatorWithOptionalMotion, TakesItInWhereTheProductHasAnOdometrySource) {
  for (const std::string odometry : {"wheel", "none"}) {
    Settings settings({}, {}, {"backend=grid", "map=grid", "odometry=" + odometry});
    Estimator estimator;
    estimator.use(Registry<Backend>::instance().create("grid"));
    estimator.configure(settings);
    const auto ports = portsOf(estimator);
    EXPECT_EQ(ports.input("motion", kindOf<Motion>()) != nullptr, odometry == "wheel");
    LaserScan scan;
    scan.stamp = stampFromNanoseconds(1000000000);
    scan.beams = {{0.1f, 2.0f, true}};
    estimator.set(scan);
    estimator.execute();
    EXPECT_EQ(estimator.report().has_value(), odometry == "none") << "it waits for the wheels";
  }
}

}  // namespace
}  // namespace slam
