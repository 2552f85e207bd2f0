// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/estimator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "slam_core/contract/registry.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/run_writer.hpp"

namespace slam {
namespace {

using test::SimulatedStep;
using test::SimulatedWorld;

std::vector<SimulatedStep> simulate(std::uint64_t seed, int steps) {
  SimulatedWorld world(seed);
  std::vector<SimulatedStep> all;
  for (int i = 0; i < steps; ++i) {
    all.push_back(world.next());
    // within the increments, as a camera's stamps lie
    all.back().observations.stamp -= std::chrono::milliseconds(1 + 7 * (i % 10));
  }
  return all;
}

class EstimatorTest : public testing::Test {
 protected:
  void SetUp() override { configure(estimator); }
  static void configure(Estimator& any, Settings settings = {}) {
    any.use(Registry<Backend>::instance().create("ekf"));
    any.configure(settings);
  }
  void drain() {
    do {
      estimator.execute();
      if (estimator.report()) reports.push_back(*estimator.report());
    } while (estimator.report());
  }
  void take(const SimulatedStep& step) {
    estimator.set(step.motion);
    estimator.set(step.observations);
    drain();
  }
  LandmarkMap landmarks() const {
    return estimator.capabilities().find<LandmarkMapper>()->landmarks();
  }
  std::string trajectory() const {
    std::string lines;
    for (const auto& report : reports) lines += tumLine(report.stamp, report.pose.pose);
    return lines;
  }

  Estimator estimator;
  std::vector<StepReport> reports;
};

TEST_F(EstimatorTest, GivesTheSameTrajectoryWhateverTheOrderOfArrival) {
  const auto steps = simulate(1, 120);
  std::string expected;
  for (std::uint64_t shuffle = 0; shuffle < 20; ++shuffle) {
    configure(estimator);
    reports.clear();
    RandomStream random(2, shuffle);
    std::size_t motion = 0, observations = 0;
    while (motion < steps.size() || observations < steps.size()) {
      const bool motion_next = random.uniform() < 0.5;
      if (motion_next && motion < steps.size()) estimator.set(steps[motion++].motion);
      if (!motion_next && observations < steps.size())
        estimator.set(steps[observations++].observations);
      if (random.uniform() < 0.7) drain();
    }
    drain();
    if (shuffle == 0) expected = trajectory();
    ASSERT_EQ(trajectory(), expected) << "shuffle " << shuffle;
  }
  EXPECT_EQ(reports.size(), steps.size());
}

TEST_F(EstimatorTest, FindsItselfAgainWhereMessagesWereLostOnTheWay) {
  const auto steps = simulate(1, 400);
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (i < 200 || i >= 260) take(steps[i]);
  const auto counters = estimator.counters();
  EXPECT_EQ(counters["lost"], 120u);  // of motion and of observations
  EXPECT_EQ(counters["bridged"], 1u);
  EXPECT_EQ(reports.size(), 340u);
  const auto& last = reports.back().pose;
  EXPECT_LT((last.pose.position() - steps.back().truth.position()).norm(), 0.1);
  EXPECT_LT(test::nees(steps.back().truth, last.pose, last.covariance), 16.0);
}

/// Whether the run ends where the robot is, and knows how surely.
void expectAtHome(const std::vector<SimulatedStep>& steps, const StepReport& report) {
  EXPECT_LT((report.pose.pose.position() - steps.back().truth.position()).norm(), 0.1);
  EXPECT_LT(test::nees(steps.back().truth, report.pose.pose, report.pose.covariance), 16.0);
}

TEST_F(EstimatorTest, LosesOnlyObservationsThatWereStampedAhead) {
  auto steps = simulate(1, 400);
  for (std::size_t i : {100, 101}) steps[i].observations.stamp += std::chrono::seconds(100);
  for (const auto& step : steps) take(step);
  EXPECT_EQ(reports.size(), 398u);
  EXPECT_EQ(estimator.dropped(), 2u);
  expectAtHome(steps, reports.back());
}

TEST_F(EstimatorTest, LosesOnlyMotionThatWasStampedAhead) {
  auto steps = simulate(1, 400);
  steps[100].motion.end += std::chrono::seconds(100);
  for (std::size_t i : {101, 102}) {
    steps[i].motion.start += std::chrono::seconds(100);
    steps[i].motion.end += std::chrono::seconds(100);
  }
  for (const auto& step : steps) take(step);
  EXPECT_EQ(reports.size(), 400u);
  EXPECT_EQ(estimator.counters()["bridged"], 1u);
  EXPECT_EQ(estimator.dropped(), 3u);
  expectAtHome(steps, reports.back());
  for (const auto& report : reports)
    EXPECT_LT(report.pose.covariance(0, 0) + report.pose.covariance(1, 1), 0.05);
}

TEST_F(EstimatorTest, CountsWhatIsSetAsideForARestartThatNeverComes) {
  const auto steps = simulate(1, 200);
  for (std::size_t i = 0; i < 100; ++i) take(steps[i]);
  for (std::size_t i = 0; i < 20; ++i) estimator.set(steps[i].observations);
  drain();
  EXPECT_EQ(estimator.counters()["set_aside"], 20u);
  EXPECT_EQ(estimator.dropped(), 20u);
}

TEST_F(EstimatorTest, FindsItselfAgainWhereTheFrontEndWasRestarted) {
  auto steps = simulate(1, 400);
  for (std::size_t i = 260; i < steps.size(); ++i) {
    steps[i].motion.sequence = i - 260;
    steps[i].observations.sequence = i - 260;
  }
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (i < 200 || i >= 260) take(steps[i]);
  EXPECT_EQ(estimator.counters()["bridged"], 1u);
  EXPECT_EQ(estimator.counters()["lost"], 0u);
  expectAtHome(steps, reports.back());
}

TEST_F(EstimatorTest, OneMotionThatNoRobotDrivesIsMadeUpForByThePoses) {
  for (const double far : {1e6, 1e300}) {
    auto steps = simulate(1, 200);
    steps[100].motion.increment = Pose2(far, far, 1);
    steps[150].motion.covariance = far * Eigen::Matrix3d::Identity();
    SetUp();
    reports.clear();
    for (const auto& step : steps) take(step);
    EXPECT_EQ(estimator.counters()["invalid_motion"], 2u);
    EXPECT_EQ(reports.size(), steps.size());
    expectAtHome(steps, reports.back());
  }
}

TEST_F(EstimatorTest, TellsThatMissingMotionIsGuessedWhereThePosesAreOfNoUse) {
  auto steps = simulate(1, 200);
  for (std::size_t i = 100; i < steps.size(); ++i) {
    auto& motion = steps[i].motion;
    motion.odometry_start = Pose2(1e5, 0, 0) * motion.odometry_start;
    motion.odometry_end = Pose2(1e5, 0, 0) * motion.odometry_end;
  }
  for (std::size_t i = 0; i < 90; ++i) take(steps[i]);
  estimator.set(steps[100].motion);
  EXPECT_NE(estimator.execute().message.find("gone on at its last velocity"), std::string::npos);
  for (std::size_t i = 101; i < steps.size(); ++i) take(steps[i]);
  EXPECT_EQ(estimator.counters()["coasted"], 1u);
  expectAtHome(steps, reports.back());
}

TEST_F(EstimatorTest, DoesNotMindTheOrderWithinAnArray) {
  const auto steps = simulate(1, 60);
  for (const auto& step : steps) take(step);
  const auto expected = trajectory();
  configure(estimator);
  reports.clear();
  for (auto step : steps) {
    auto& all = step.observations.observations;
    std::reverse(all.begin(), all.end());
    take(step);
  }
  EXPECT_EQ(trajectory(), expected);
}

TEST_F(EstimatorTest, ReportsTheOdometryPoseOfTheVeryStamp) {
  const auto steps = simulate(1, 20);
  for (const auto& step : steps) {
    take(step);
    const auto& report = reports.back();
    const double share = seconds(report.stamp - step.motion.start) / 0.1;
    const Pose2 expected = step.motion.odometry_start * step.motion.increment.part(share);
    EXPECT_LT((report.odometry_pose.vector() - expected.vector()).norm(), 1e-9);
    EXPECT_EQ(report.odometry_frame, "odom");
    EXPECT_EQ(report.base_frame, "base_link");
    EXPECT_EQ(report.trigger, "observations");
  }
}

TEST_F(EstimatorTest, KnowsTheOdometryPoseAtTheVeryStartOfMotion) {
  auto step = simulate(1, 1)[0];
  step.motion.odometry_start = Pose2(7, 8, 1);
  step.motion.odometry_end = step.motion.odometry_start * step.motion.increment;
  step.observations.stamp = step.motion.start;
  take(step);
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_EQ(reports[0].odometry_pose.vector(), Eigen::Vector3d(7, 8, 1));
  EXPECT_EQ(reports[0].odometry_frame, "odom");
}

TEST_F(EstimatorTest, NamesTheFramesOfMotionThatHasNone) {
  auto step = simulate(1, 1)[0];
  step.motion.odometry_frame.clear();
  step.motion.base_frame.clear();
  take(step);
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_EQ(reports[0].odometry_frame, "odom");
  EXPECT_EQ(reports[0].base_frame, "base_link");
}

TEST_F(EstimatorTest, TellsOnceThatOdometryMovesAnotherFrame) {
  auto steps = simulate(3, 3);
  std::vector<std::string> sentences;
  for (auto& step : steps) {
    step.motion.base_frame = "base_footprint";
    estimator.set(step.motion);
    sentences.push_back(estimator.execute().message);
  }
  EXPECT_NE(sentences[0].find("set frames.base to 'base_footprint'"), std::string::npos);
  EXPECT_EQ(sentences[1] + sentences[2], "");
}

TEST_F(EstimatorTest, AppliesMotionAndNoObservationsWhilePaused) {
  const auto steps = simulate(1, 30);
  for (int i = 0; i < 10; ++i) take(steps[std::size_t(i)]);
  estimator.pause(true);
  const auto map = landmarks();
  const auto before = estimator.backend().pose();
  for (int i = 10; i < 20; ++i) take(steps[std::size_t(i)]);
  EXPECT_EQ(estimator.counters()["paused"], 10u);
  EXPECT_EQ(landmarks().size(), map.size());
  EXPECT_EQ(landmarks()[0].position, map[0].position);
  EXPECT_GT((estimator.backend().pose().pose.position() - before.pose.position()).norm(), 1.5);
  EXPECT_GT(estimator.backend().pose().covariance.trace(), before.covariance.trace());
  estimator.pause(false);
  take(steps[20]);
  EXPECT_GT(reports.back().statistics.used, 0);
}

TEST_F(EstimatorTest, BeginsAnewWhenTheBagIsPlayedAgain) {
  const auto steps = simulate(1, 100);
  for (const auto& step : steps) take(step);
  const auto first = trajectory();
  reports.clear();
  for (const auto& step : steps) take(step);
  EXPECT_EQ(trajectory(), first);
  EXPECT_TRUE(reports.front().restarted);
  EXPECT_FALSE(reports.back().restarted);
  EXPECT_EQ(estimator.counters()["restart"], 1u);
  EXPECT_EQ(estimator.dropped(), 0u);
}

TEST_F(EstimatorTest, IsFreshAfterReset) {
  const auto steps = simulate(1, 40);
  for (const auto& step : steps) take(step);
  const auto first = trajectory();
  estimator.reset();
  EXPECT_FALSE(estimator.report().has_value());
  EXPECT_FALSE(estimator.intake().arrivals().motion.has_value());
  EXPECT_TRUE(estimator.counters().all().empty());
  reports.clear();
  for (const auto& step : steps) take(step);
  EXPECT_EQ(trajectory(), first);
}

TEST_F(EstimatorTest, TakesAStartMapAgainWheneverItBeginsAnew) {
  MapState map;
  map.robot = {Pose2(1, 2, 0.5), 0.01 * Eigen::Matrix3d::Identity()};
  map.landmarks = {{900, {5, 5}, 0.01 * Eigen::Matrix2d::Identity()}};
  estimator.startWith(map);
  EXPECT_EQ(landmarks().size(), 1u);
  for (const auto& step : simulate(1, 80)) take(step);
  EXPECT_GT(landmarks().size(), 1u);
  estimator.reset();
  ASSERT_EQ(landmarks().size(), 1u);
  EXPECT_EQ(estimator.backend().pose().pose.vector(), Eigen::Vector3d(1, 2, 0.5));
}

TEST_F(EstimatorTest, GivesTheSensorsNoiseToObservationsWithoutOne) {
  auto with = simulate(1, 1)[0], without = with;
  const LandmarkSensorConfig sensor;
  for (auto& z : with.observations.observations)
    z.covariance =
        Eigen::Vector2d(std::pow(sensor.sigma_range, 2), std::pow(sensor.sigma_bearing, 2))
            .asDiagonal();
  for (auto& z : without.observations.observations) z.covariance << -1, 0, 0, 0;
  take(with);
  const auto expected = landmarks();
  configure(estimator);
  take(without);
  const auto map = landmarks();
  ASSERT_EQ(map.size(), expected.size());
  EXPECT_TRUE(map[0].covariance.isApprox(expected[0].covariance, 1e-12));
}

/// What steps of odometry that is three times worse than it says have led to.
class JudgedEstimatorTest : public EstimatorTest {
 protected:
  void SetUp() override {
    EstimatorTest::SetUp();
    for (auto& step : steps) step.motion.covariance /= 9.0;
    for (std::size_t i = 0; i < 60; ++i) judge(steps[i]);
  }
  void judge(const SimulatedStep& step) {
    reports.clear();
    take(step);
    for (const auto& report : reports) judged.add(report.statistics);
  }
  std::vector<SimulatedStep> steps = simulate(9, 80);
  ConsistencyMonitor judged;  ///< by what the steps tell alone
};

TEST_F(JudgedEstimatorTest, APoseThatIsSetEndsWhatTheOdometryErredBefore) {
  const PoseEstimate there{steps[59].truth, 0.01 * Eigen::Matrix3d::Identity()};
  EXPECT_TRUE(estimator.set(there).isOk());
  UpdateStatistics anew;
  anew.prediction.F.setZero();
  auto forgetful = judged;
  forgetful.add(anew);
  for (std::size_t i = 60; i < 70; ++i) {
    judge(steps[i]);
    for (const auto& report : reports) forgetful.add(report.statistics);
  }
  const auto sigma = [](const ConsistencyMonitor& monitor) {
    return monitor.factors()[ConsistencyMonitor::kMotion].sigma;
  };
  EXPECT_EQ(sigma(estimator.consistency()), sigma(forgetful));
  EXPECT_NE(sigma(estimator.consistency()), sigma(judged)) << "else this test shows nothing";
}

TEST_F(JudgedEstimatorTest, AMapThatIsLoadedIsJudgedAnew) {
  EXPECT_GT(estimator.consistency().updates(), 10);
  EXPECT_TRUE(estimator.set(estimator.capabilities().find<MapKeeper>()->state()).isOk());
  EXPECT_EQ(estimator.consistency().updates(), 0) << "they were of another map";
  judge(steps[60]);  // the place is recognised
  judge(steps[61]);
  EXPECT_EQ(estimator.consistency().updates(), 1);
}

TEST_F(EstimatorTest, WarnsOnceOfASigmaThatIsThreeTimesTooSmall) {
  configure(estimator, Settings({}, {}, {"consistency.adapt=false"}));
  std::vector<std::string> warnings;
  for (auto& step : simulate(9, 120)) {
    for (auto& z : step.observations.observations) z.covariance(1, 1) /= 9.0;
    estimator.set(step.motion);
    estimator.set(step.observations);
    do {
      if (const auto status = estimator.execute(); !status.isOk())
        warnings.push_back(status.message);
    } while (estimator.report());
  }
  ASSERT_FALSE(warnings.empty());
  EXPECT_NE(warnings.front().find("bearing sigma looks"), std::string::npos) << warnings.front();
  EXPECT_LE(warnings.size(), 3u) << "said again at every step";
  EXPECT_EQ(estimator.consistency().finding().find("bearing sigma looks"), 0u);
  estimator.reset();
  EXPECT_EQ(estimator.consistency().finding(), "");
}

TEST_F(EstimatorTest, ThatThePoseMayBeLostIsSaidByTheMonitorOnceAndHidesNothingGraver) {
  // else the robot finds itself before
  configure(estimator, Settings({}, {}, {"relocalisation.enabled=false"}));
  std::vector<Status> alarms;
  auto steps = simulate(9, 160);
  steps[80].motion.increment = steps[80].motion.increment * Pose2(2.0, 1.0, 0.7);
  for (const auto& step : steps) {
    estimator.set(step.motion);
    estimator.set(step.observations);
    do {
      const auto status = estimator.execute();
      if (status.message.find("failed the gate") != std::string::npos) alarms.push_back(status);
    } while (estimator.report());
  }
  ASSERT_EQ(alarms.size(), 1u);
  EXPECT_TRUE(alarms.front().isUrgent());
  EXPECT_EQ(estimator.consistency().fault(), ConsistencyMonitor::Fault::kLost);
  EXPECT_TRUE(moreUrgent(alarms.front(), Status::warning("of something else")).isUrgent());
  EXPECT_EQ(moreUrgent(alarms.front(), Status::error("of all")).message, "of all");
}

}  // namespace
}  // namespace slam
