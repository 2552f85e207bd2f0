// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <memory>

#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/meta_coordinator.hpp"
#include "slam_core/product/test/fault_world.hpp"

namespace slam {
namespace {

using test::SimulatedStep;
using test::SimulatedWorld;

/// More than a lap; then the process is killed, the robot drives on, and another process goes on.
class LiveResume : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    estimator = configured();
    for (int i = 0; i < 130; ++i) take(world.next());
    known = landmarks();
    ArchiveWriter archive;
    estimator->saveState(archive);
    state = archive.take();
    resumeAfter(Interruption::kOfAll);
  }
  void resumeAfter(Interruption interruption) {
    estimator = configured();
    ArchiveReader reader(state);
    estimator->restoreState(reader);
    goOnLive(*estimator, interruption);
    was_doubtful = false;
  }
  static std::unique_ptr<Estimator> configured() {
    auto made = std::make_unique<Estimator>();
    Settings settings;
    made->use(Registry<Backend>::instance().create(GetParam()));
    made->configure(settings);
    return made;
  }
  /// The robot drives on while no process listens.
  void miss(int steps) {
    for (int i = 0; i < steps; ++i) last = world.next();
  }
  void take(SimulatedStep step) {
    last = step;
    step.motion.start += clock_shift;
    step.motion.end += clock_shift;
    step.observations.stamp += clock_shift;
    step.motion.odometry_start = T_new_old * step.motion.odometry_start;
    step.motion.odometry_end = T_new_old * step.motion.odometry_end;
    estimator->set(step.motion);
    estimator->set(step.observations);
    for (auto status = estimator->execute(); estimator->report(); status = estimator->execute()) {
      report = *estimator->report();
      was_restarted = was_restarted || report.restarted;
      was_doubtful =
          was_doubtful || (report.trust == Trust::kDoubtful && report.pose.covariance(0, 0) > 9.0);
      if (!status.isOk()) said += status.message + "\n";
    }
  }
  /// Until there are steps again; stamps that jump ahead are not believed at once.
  void goOn() {
    const auto saved = report.stamp;
    for (int i = 0; i < 30 && report.stamp == saved; ++i) take(world.next());
    ASSERT_NE(report.stamp, saved);
    expectHonest();
  }
  void expectHonest() const {
    const auto& P = report.pose.covariance;
    const double error = (report.pose.pose.position() - last.truth.position()).norm();
    EXPECT_LT(error, std::max(0.2, 3.0 * std::sqrt(P(0, 0) + P(1, 1))));
  }
  void expectFound() {
    for (int i = 0; i < 30; ++i) {
      take(world.next());
      expectHonest();
    }
    EXPECT_EQ(report.trust, Trust::kConfident) << report.doubt;
    EXPECT_LT((report.pose.pose.position() - last.truth.position()).norm(), 0.3);
    EXPECT_EQ(landmarks(), known);
  }
  std::size_t landmarks() const {
    return estimator->capabilities().find<LandmarkMapper>()->landmarks().size();
  }

  SimulatedWorld world{3};
  std::string state;
  std::unique_ptr<Estimator> estimator;
  StepReport report;
  SimulatedStep last;
  std::string said;
  bool was_restarted = false;
  bool was_doubtful = false;  ///< in a step since the resumption
  std::size_t known = 0;
  Duration clock_shift{};
  Pose2 T_new_old;
};

TEST_P(LiveResume, BridgesWhatItMissedByAnOdometryThatWentOn) {
  resumeAfter(Interruption::kOfThisProcess);
  miss(60);
  goOn();
  EXPECT_FALSE(was_doubtful) << report.doubt;
  EXPECT_EQ(estimator->counters()["bridged"], 1u);
  expectFound();
}

TEST_P(LiveResume, BridgesWhatItMissedWhereTheFirstMessagesChangePlaces) {
  resumeAfter(Interruption::kOfThisProcess);
  miss(80);
  const auto first = world.next(), second = world.next();
  take(second);
  take(first);
  goOn();
  expectFound();
}

/// Which way the robot took in a pause nobody knows.
TEST_P(LiveResume, LeavesOutWhatWasSeenInThePause) {
  resumeAfter(Interruption::kOfThisProcess);
  miss(40);
  const auto seen = world.next().observations;
  miss(40);
  estimator->set(seen);
  goOn();
  EXPECT_EQ(estimator->counters()["in_gap"], 1u);
  expectFound();
}

TEST_P(LiveResume, DoubtsThePoseWhereTheOdometryWasRestarted) {
  resumeAfter(Interruption::kOfThisProcess);
  miss(60);
  T_new_old = last.motion.odometry_end.inverse();
  goOn();
  EXPECT_TRUE(was_doubtful);
  expectFound();
}

/// The computer was started anew, and its driver has gone on a bit before there were steps.
TEST_P(LiveResume, DoubtsThePoseWhereAllWasRestarted) {
  miss(40);
  T_new_old = last.motion.odometry_end.inverse();
  miss(10);
  goOn();
  EXPECT_TRUE(was_doubtful);
  expectFound();
}

/// It was switched off, carried on by somebody, and switched on hours later.
TEST_P(LiveResume, DoubtsThePoseAfterAnHour) {
  miss(40);
  clock_shift = std::chrono::hours(1);
  goOn();
  EXPECT_TRUE(was_doubtful);
  expectFound();
}

/// A computer without a battery for its clock.
TEST_P(LiveResume, KeepsTheMapWhereTheClockWasSetBack) {
  miss(40);
  T_new_old = last.motion.odometry_end.inverse();
  clock_shift = -std::chrono::minutes(10);
  goOn();
  EXPECT_TRUE(was_restarted);
  EXPECT_NE(said.find("time begins anew with its map"), std::string::npos) << said;
  EXPECT_TRUE(was_doubtful);
  EXPECT_EQ(landmarks(), known);
  expectFound();
}

/// Once it has gone on, time begins anew as ever.
TEST_P(LiveResume, ForgetsTheMapWhereTheClockIsSetBackLater) {
  for (int i = 0; i < 5; ++i) take(world.next());
  clock_shift = -std::chrono::minutes(10);
  for (int i = 0; i < 10 && !was_restarted; ++i) take(world.next());
  EXPECT_TRUE(was_restarted);
  EXPECT_LT(landmarks(), known);
}

INSTANTIATE_TEST_SUITE_P(Backends, LiveResume, testing::Values("ekf", "pf", "graph", "seif"));

/// What a laser saw before a pause is of another place than what it sees afterwards.
TEST(LiveResumeOfAProduct, BeginsAnewWithAnOdometryThatGoesByWhatItSaw) {
  constexpr int kBefore = 60, kMissed = 48, kAfter = 20;
  Settings settings({}, {}, {"backend=grid", "map=grid", "odometry=laser"});
  MetaCoordinator saved, resumed;
  for (auto* product : {&saved, &resumed}) product->configure(settings);
  test::FaultWorld world(3, true, true);
  for (const auto& input : world.begin()) input(saved);
  const auto take = [&world](MetaCoordinator& product) {
    for (const auto& message : world.next())
      std::visit([&product](const auto& value) { product.set(value); }, message);
    while (product.execute().level != Status::Level::kError && product.estimator().report()) {
      const auto& [pose, P] = product.estimator().report()->pose;
      const double error = (pose.position() - world.truth().position()).norm();
      EXPECT_LT(error, std::max(0.2, 3.0 * std::sqrt(P(0, 0) + P(1, 1))));
    }
  };
  for (int i = 0; i < kBefore; ++i) take(saved);
  restore(stateOf(saved), resumed);
  goOnLive(resumed, Interruption::kOfThisProcess);
  for (int i = 0; i < kMissed; ++i) world.next();
  for (int i = 0; i < kAfter; ++i) take(resumed);
}

}  // namespace
}  // namespace slam
