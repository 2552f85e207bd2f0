// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/event_watch.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "slam_core/common/config_error.hpp"
#include "slam_core/common/test/faults.hpp"
#include "slam_core/contract/lost_reporter.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/estimator.hpp"

namespace slam {
namespace {

using EventKind = Event::Kind;

/// A back-end's own account of its steps.
class Account final : public EventReporter {
 public:
  std::vector<Event> events() const override { return told; }
  std::vector<Event> told;
};

class EventWatchTest : public testing::Test {
 protected:
  void SetUp() override { backend.offer<EventReporter>(account); }

  /// A step after 0.1 m ahead, whose pose is off by so much [m].
  StepReport step(double off, Trust trust = Trust::kConfident) {
    Motion motion;
    motion.increment = {0.1, 0, 0};
    motion.covariance = 1e-4 * Eigen::Matrix3d::Identity();
    watch.predict(motion);
    report.stamp += interval;
    report.events.clear();
    x += 0.1 + off;
    report.pose = {Pose2(x, 0, 0), variance * Eigen::Matrix3d::Identity()};
    report.trust = trust;
    watch.complete(report, backend);
    return report;
  }

  Account account;
  Capabilities backend;
  EventWatch watch;
  StepReport report;
  double x = 0.0, variance = 1e-4;
  Duration interval = std::chrono::seconds(1);
};

TEST_F(EventWatchTest, SaysNothingOfSmallCorrections) {
  variance = 1e-8;
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(step(0.04).events.empty());
}

TEST_F(EventWatchTest, SaysNothingOfCorrectionsThatTheUncertaintyExplains) {
  variance = 1.0;
  step(0.0);
  const auto corrected = step(1.5);
  EXPECT_TRUE(corrected.events.empty());
  ASSERT_TRUE(corrected.correction);
  EXPECT_NEAR(corrected.correction->distance, 1.5, 1e-12);
}

TEST_F(EventWatchTest, ReportsAJumpThatNoUncertaintyExplains) {
  step(0.0);
  const auto jumped = step(0.5);
  ASSERT_EQ(jumped.events.size(), 1u);
  EXPECT_EQ(jumped.events[0].kind, EventKind::kJump);
  EXPECT_EQ(jumped.events[0].stamp, jumped.stamp);
  EXPECT_NEAR(jumped.events[0].distance, 0.5, 1e-12);
}

TEST_F(EventWatchTest, ReportsEveryRelocationWithItsReason) {
  step(0.0);
  watch.relocate("the robot was put there");
  const auto relocated = step(0.01);
  ASSERT_EQ(relocated.events.size(), 1u);
  EXPECT_EQ(relocated.events[0].reason, "the robot was put there");
  EXPECT_TRUE(relocated.is_relocated);
  EXPECT_FALSE(step(0.0).is_relocated);
}

TEST_F(EventWatchTest, SaysNothingOfTheFirstStep) {
  watch.relocate("a map was loaded");
  EXPECT_TRUE(step(5.0).events.empty());
}

TEST_F(EventWatchTest, ReportsLoopsThatMovedThePoseAndThoseTakenBack) {
  account.told = {{EventKind::kLoopClosed, 0.01, 0.001, "small", {}}};
  EXPECT_TRUE(step(0.0).events.empty());
  account.told = {{EventKind::kLoopClosed, 0.5, 0.001, "large", {}},
                  {EventKind::kLoopTakenBack, 0.01, 0.001, "small", {}}};
  const auto events = step(0.5).events;
  ASSERT_EQ(events.size(), 2u) << "and what the loop explains is no jump beside it";
  EXPECT_EQ(events[0].reason, "large");
  EXPECT_EQ(events[1].kind, EventKind::kLoopTakenBack);
}

TEST_F(EventWatchTest, ReportsThatTheRobotIsLostAndFoundOnceEach) {
  std::vector<EventKind> kinds;
  std::string reason;
  const auto well = Trust::kConfident, lost = Trust::kLost;
  for (const auto trust : {well, lost, lost, lost, well, well})
    for (const auto& event : step(0.0, trust).events) {
      kinds.push_back(event.kind);
      reason = event.reason;
    }
  EXPECT_EQ(kinds, (std::vector<EventKind>{EventKind::kLost, EventKind::kFound}));
  EXPECT_NE(reason.find("after 3.0 s"), std::string::npos) << reason;
}

TEST_F(EventWatchTest, ReportsADoubtAndItsEndOnceEach) {
  std::vector<EventKind> kinds;
  const auto well = Trust::kConfident, doubt = Trust::kDoubtful, lost = Trust::kLost;
  report.doubt = "something";
  for (const auto trust : {well, doubt, doubt, well, well, doubt, lost, lost, doubt, well})
    for (const auto& event : step(0.0, trust).events) {
      kinds.push_back(event.kind);
      if (event.kind == EventKind::kDoubtful) {
        EXPECT_EQ(event.reason, "something");
      }
    }
  using Kind = EventKind;
  EXPECT_EQ(kinds,
            (std::vector<EventKind>{Kind::kDoubtful, Kind::kConfident, Kind::kDoubtful, Kind::kLost,
                                    Kind::kFound, Kind::kDoubtful, Kind::kConfident}));
}

TEST_F(EventWatchTest, HoldsADoubtForASecond) {
  interval = std::chrono::milliseconds(300);
  std::vector<Trust> trusts;
  const auto well = Trust::kConfident, doubt = Trust::kDoubtful;
  for (const auto trust : {well, doubt, well, well, well, well})
    trusts.push_back(step(0.0, trust).trust);
  EXPECT_EQ(trusts, (std::vector<Trust>{well, doubt, doubt, doubt, doubt, well}));
}

TEST(EventsConfig, RefusesLimitsBelowZero) {
  EventsConfig config;
  config.jump_position = -0.1;
  EXPECT_TRUE(test::oneSays({test::sentenceOf([&] { validate(config); })},
                            {"events.jump_position", ">= 0"}));
}

/// The EKF has no account of its own: what is told comes from its pose.
TEST(EventsOfAnEstimator, AreTheRelocationsOfARobotThatDrivesWell) {
  Estimator estimator;
  Settings settings;
  estimator.use(Registry<Backend>::instance().create("ekf"));
  estimator.configure(settings);
  test::SimulatedWorld world(1);
  std::vector<Event> events;
  for (int i = 0; i < 200; ++i) {
    const auto step = world.next();
    estimator.set(step.motion);
    estimator.set(step.observations);
    if (i == 150) estimator.set(PoseEstimate{Pose2(1, 2, 0.5), Eigen::Matrix3d::Identity()});
    for (estimator.execute(); estimator.report(); estimator.execute())
      for (const auto& event : estimator.report()->events) events.push_back(event);
  }
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].kind, EventKind::kJump);
  EXPECT_EQ(events[0].reason, "the robot was put there");
}

}  // namespace
}  // namespace slam
