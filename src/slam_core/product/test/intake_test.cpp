// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/intake.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/contract/ports.hpp"
#include "slam_core/models/laser_scan.hpp"

namespace slam::test {

/// A kind of the test's own, of which the product knows nothing.
struct Echo {
  Stamp stamp;
  std::uint64_t sequence = 0;
  double range = 1.0;
};

std::string faultOf(const Echo& echo) {
  return echo.range > 0.0 ? "" : "an echo with a range that is not positive";
}

namespace {

Stamp at(int milliseconds) {
  return stampFromNanoseconds(1000000000) + std::chrono::milliseconds(milliseconds);
}

Motion motion(int start, int end, std::uint64_t sequence) {
  Motion motion;
  motion.sequence = sequence;
  motion.start = at(start);
  motion.end = at(end);
  motion.increment = Pose2(0.001 * (end - start), 0, 0);
  motion.covariance = 1e-4 * Eigen::Matrix3d::Identity();
  return motion;
}

class IntakeTest : public testing::Test {
 protected:
  void configure(const std::vector<std::string>& overrides = {}) {
    Settings settings({}, {}, overrides);
    intake.configure(settings, ports);
  }
  void configureWithMotion() {
    ports.takes<Motion>("motion", "motion", [](const Motion&) {}).carrier();
    ports.takes<Echo>("sonar", "echoes", [](const Echo&) {});
    configure();
  }
  template <class T>
  void take(const T& value) {
    intake.take(kindOf<T>(), &value);
  }
  template <class T>
  void take(const std::string& input, const T& value) {
    intake.take(input, kindOf<T>(), &value);
  }
  std::vector<Intake::Step> drain() {
    std::vector<Intake::Step> steps;
    while (auto step = intake.next()) steps.push_back(*step);
    return steps;
  }
  static double rangeOf(const Intake::Step& step) {
    return static_cast<const Echo*>(step.trigger->value.get())->range;
  }

  Ports ports;
  Intake intake;
};

TEST_F(IntakeTest, LeavesOutAndCountsWhatTheKindCallsAFault) {
  configureWithMotion();
  take(motion(0, 100, 0));
  take(Echo{at(20), 0, -1.0});
  EXPECT_EQ(intake.counters()["invalid_sonar"], 1u);
  EXPECT_TRUE(oneSays({intake.takeFault()}, {"range that is not positive", "left out"}));
  EXPECT_EQ(intake.takeFault(), "") << "said once";
  EXPECT_TRUE(drain().empty());
  take(Echo{at(40), 1, 2.0});
  EXPECT_EQ(drain().size(), 1u);
  EXPECT_EQ(intake.counters()["invalid_sonar"], 1u);
}

TEST_F(IntakeTest, WhatIsLeftOutForAFaultDoesNotCountAsLostAsWell) {
  configureWithMotion();
  take(motion(0, 100, 0));
  take(Echo{at(20), 0, 1.0});
  take(Echo{at(40), 1, -1.0});
  take(Echo{at(60), 2, 1.0});
  auto broken = motion(100, 200, 1);
  broken.increment = Pose2(std::nan(""), 0, 0);
  take(broken);
  take(motion(200, 300, 2));
  EXPECT_EQ(intake.counters()["invalid_sonar"], 1u);
  EXPECT_EQ(intake.counters()["invalid_motion"], 1u);
  EXPECT_EQ(intake.counters()["lost"], 0u);
}

TEST_F(IntakeTest, AnInputThatIsLatchedGetsNoFaultEither) {
  std::vector<double> got;
  ports.takes<Echo>("calibration", "echoes", [&](const Echo& echo) { got.push_back(echo.range); })
      .latched();
  configure();
  take("calibration", Echo{at(0), 0, -1.0});
  EXPECT_TRUE(oneSays({intake.takeFault()}, {"range that is not positive", "left out"}));
  take("calibration", Echo{at(0), 0, 2.0});
  EXPECT_EQ(got, std::vector<double>{2.0});
  EXPECT_EQ(intake.counters()["invalid_calibration"], 1u);
}

TEST_F(IntakeTest, CollatesItWithMotionWhateverTheOrderOfArrival) {
  configureWithMotion();
  take(Echo{at(50), 0, 1.0});
  take(Echo{at(130), 1, 2.0});
  EXPECT_TRUE(drain().empty()) << "motion has not come";
  EXPECT_EQ(intake.arrivals().held()["echoes"], 2u);
  take(motion(0, 100, 0));
  auto steps = drain();
  ASSERT_EQ(steps.size(), 1u);
  EXPECT_EQ(steps[0].stamp, at(50));
  EXPECT_EQ(steps[0].trigger->port->name, "sonar");
  EXPECT_EQ(rangeOf(steps[0]), 1.0);
  ASSERT_EQ(steps[0].motions.size(), 1u);
  EXPECT_NEAR(steps[0].motions[0].increment.x(), 0.05, 1e-12) << "split at the stamp";
  take(motion(100, 200, 1));
  steps = drain();
  ASSERT_EQ(steps.size(), 1u);
  EXPECT_EQ(rangeOf(steps[0]), 2.0);
  EXPECT_EQ(steps[0].motions.size(), 2u);
  EXPECT_EQ(intake.arrivals().held()["echoes"], 0u);
  EXPECT_EQ(intake.arrivals().lastOf("sonar"), at(130));
  EXPECT_EQ(intake.arrivals().motion, at(200));
}

TEST_F(IntakeTest, CountsWhatIsLateAndWhatIsLost) {
  configureWithMotion();
  take(motion(0, 100, 0));
  take(Echo{at(50), 0, 1.0});
  take(Echo{at(60), 3, 1.0});
  take(Echo{at(55), 4, 1.0});
  EXPECT_EQ(intake.counters()["lost"], 2u);
  EXPECT_EQ(intake.counters()["late"], 1u);
  EXPECT_EQ(intake.dropped(), 3u);
  intake.reset();
  EXPECT_TRUE(intake.counters().all().empty());
  EXPECT_FALSE(intake.arrivals().lastOf("sonar"));
}

TEST_F(IntakeTest, WaitsForEachInputUnlessNothingIsExpectedThere) {
  ports.takes<Motion>("motion", "motion", [](const Motion&) {}).carrier();
  ports.takes<Echo>("left", "echoes on the left", [](const Echo&) {});
  ports.takes<Echo>("right", "echoes on the right", [](const Echo&) {});
  configure();
  take(motion(0, 100, 0));
  take("left", Echo{at(50), 0, 1.0});
  EXPECT_TRUE(drain().empty()) << "the right one may still send something older";
  take("right", Echo{at(40), 0, 2.0});
  const auto steps = drain();
  ASSERT_EQ(steps.size(), 1u);
  EXPECT_EQ(steps[0].trigger->port->name, "right") << "inputs of one kind stay apart";
  intake.reset();
  intake.expectNothing("right");
  for (int run = 0; run < 2; ++run) {
    take(motion(0, 100, 0));
    take("left", Echo{at(50), 0, 1.0});
    EXPECT_EQ(drain().size(), 1u);
    intake.reset();
  }
}

TEST_F(IntakeTest, NamesWhatWaitsForMotionThatHasStopped) {
  configureWithMotion();
  take(motion(0, 100, 0));
  take(Echo{at(200), 0, 1.0});
  EXPECT_EQ(intake.arrivals().starving, "");
  take(Echo{at(3500), 1, 1.0});
  EXPECT_EQ(intake.arrivals().starving, "echoes since 1.2 wait for motion");
}

TEST_F(IntakeTest, WithoutMotionTheTriggersAreTheClock) {
  ports.takes<Echo>("sonar", "echoes", [](const Echo&) {});
  configure();
  take(motion(0, 100, 0));
  for (int i = 0; i < 3; ++i) {
    take(Echo{at(100 * i), static_cast<std::uint64_t>(i), 1.0 + i});
    const auto steps = drain();
    ASSERT_EQ(steps.size(), 1u) << "each is due at once";
    EXPECT_EQ(steps[0].stamp, at(100 * i));
    EXPECT_EQ(rangeOf(steps[0]), 1.0 + i);
    EXPECT_TRUE(steps[0].motions.empty());
  }
  EXPECT_FALSE(intake.arrivals().motion) << "nobody takes it";
  EXPECT_EQ(intake.arrivals().starving, "");
  EXPECT_TRUE(intake.counters().all().empty());
}

TEST_F(IntakeTest, WhatIsLatchedGoesStraightToTheBackEnd) {
  double range = 0.0;
  ports.takes<Echo>("echo", "the echo of the wall", [&](const Echo& echo) { range = echo.range; })
      .latched();
  configure();
  take(Echo{at(5), 0, 3.0});
  EXPECT_EQ(range, 3.0);
  take(Echo{at(4), 0, 2.0});
  EXPECT_EQ(range, 2.0) << "whatever its stamp";
  EXPECT_TRUE(drain().empty());
}

TEST_F(IntakeTest, RefusesInputsThatCannotBeOrdered) {
  ports.takes<int>("button", "presses", [](int) {});
  ports.takes<Echo>("sonar", "echoes", [](const Echo&) {}).carrier();
  const auto faults = faultsOf([&] { configure(); });
  EXPECT_EQ(faults.size(), 2u);
  EXPECT_TRUE(oneSays(faults, {"'button' triggers steps", "int has no stamp"}));
  EXPECT_TRUE(oneSays(faults, {"'sonar' carries time on", "only slam::Motion"}));
}

}  // namespace
}  // namespace slam::test
