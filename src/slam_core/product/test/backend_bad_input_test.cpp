// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/estimator.hpp"

namespace slam {
namespace {

using test::SimulatedStep;
using test::SimulatedWorld;

/// A good run of landmarks in which a few steps are spoilt: it must go on, say so and end near the
/// truth.
class BackendBadInput : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    Settings settings;
    estimator.use(Registry<Backend>::instance().create(GetParam()));
    estimator.configure(settings);
  }
  void drain() {
    do {
      const auto status = estimator.execute();
      if (!status.isOk()) sentences.push_back(status.message);
    } while (estimator.report());
  }
  LandmarkMap landmarks() const {
    return estimator.capabilities().find<LandmarkMapper>()->landmarks();
  }
  void runSpoilt(const std::function<void(SimulatedStep&)>& spoil) {
    SimulatedWorld world(12);
    Pose2 truth;
    for (int i = 0; i < 60; ++i) {
      auto step = world.next();
      truth = step.truth;
      if (i % 20 == 10) spoil(step);
      estimator.set(step.motion);
      estimator.set(step.observations);
      drain();
    }
    const auto estimate = estimator.backend().pose();
    ASSERT_TRUE(estimate.pose.isFinite());
    EXPECT_TRUE(isCovariance(estimate.covariance));
    EXPECT_LT((estimate.pose.position() - truth.position()).norm(), 0.3);
    for (const auto& landmark : landmarks()) {
      EXPECT_TRUE(landmark.position.allFinite());
      EXPECT_TRUE(isCovariance(landmark.covariance));
    }
  }
  void runWithObservation(const std::function<void(LandmarkObservation&)>& spoil) {
    runSpoilt([&](SimulatedStep& step) { spoil(step.observations.observations.front()); });
  }

  /// One variance of each observation is this, of the range and then of the bearing.
  void runWithVariances(const std::vector<double>& variances) {
    for (const double variance : variances)
      for (const int axis : {0, 1}) {
        SetUp();
        runSpoilt([&](SimulatedStep& step) {
          for (auto& z : step.observations.observations) {
            z.covariance = 1e-4 * Eigen::Matrix2d::Identity();
            z.covariance(axis, axis) = variance;
          }
        });
        EXPECT_GE(estimator.counters()["invalid_observation"], 3u);
      }
  }

  Estimator estimator;
  std::vector<std::string> sentences;
};

TEST_P(BackendBadInput, MotionThatIsNotANumber) {
  runSpoilt([](SimulatedStep& step) { step.motion.increment = Pose2(std::nan(""), 0, 0); });
  EXPECT_EQ(estimator.counters()["invalid_motion"], 3u);
  EXPECT_TRUE(test::oneSays(sentences, {"motion", "not a number", "left out"}));
}

TEST_P(BackendBadInput, MotionOfANegativeInterval) {
  runSpoilt([](SimulatedStep& step) { std::swap(step.motion.start, step.motion.end); });
  EXPECT_EQ(estimator.counters()["invalid_motion"], 3u);
  EXPECT_TRUE(test::oneSays(sentences, {"ends before it starts"}));
}

TEST_P(BackendBadInput, MotionWithoutACovariance) {
  runSpoilt([](SimulatedStep& step) { step.motion.covariance.setZero(); });
  EXPECT_EQ(estimator.counters()["invalid_motion"], 3u);
}

TEST_P(BackendBadInput, ObservationThatIsNotANumber) {
  runWithObservation([](LandmarkObservation& z) { z.bearing = std::nan(""); });
  EXPECT_EQ(estimator.counters()["invalid_observation"], 3u);
  EXPECT_TRUE(test::oneSays(sentences, {"observation of landmark", "not a number", "left out"}));
}

TEST_P(BackendBadInput, ObservationOfANegativeRange) {
  runWithObservation([](LandmarkObservation& z) { z.range = -z.range; });
  EXPECT_EQ(estimator.counters()["invalid_observation"], 3u);
  EXPECT_TRUE(test::oneSays(sentences, {"range that is not positive"}));
}

TEST_P(BackendBadInput, ObservationWhoseCovarianceIsNone) {
  runWithObservation([](LandmarkObservation& z) { z.covariance(1, 1) = -1e-3; });
  EXPECT_EQ(estimator.counters()["invalid_observation"], 3u);
  EXPECT_TRUE(test::oneSays(sentences, {"not positive definite"}));
}

TEST_P(BackendBadInput, ObservationsFromASensorThatIsNowhere) {
  runSpoilt([](SimulatedStep& step) { step.observations.sensor_pose = Pose2(0, 0, std::nan("")); });
  EXPECT_GE(estimator.counters()["invalid_observation"], 3u);
  EXPECT_TRUE(test::oneSays(sentences, {"sensor pose", "not a number"}));
}

/// What it sees is new, and would lie where squares of coordinates are no numbers.
TEST_P(BackendBadInput, ObservationsFromASensorThatIsFarFromTheRobot) {
  for (const double distance : {1e4, 1e12, 1e155, 1e300}) {
    SetUp();
    runSpoilt([&](SimulatedStep& step) {
      step.observations.sensor_pose = Pose2(0, -distance, 0);
      for (auto& z : step.observations.observations) z.id += 1000;
    });
    EXPECT_GE(estimator.counters()["invalid_observation"], 3u);
  }
  EXPECT_TRUE(test::oneSays(sentences, {"sensor pose", "more than 1000 m", "left out"}));
}

TEST_P(BackendBadInput, TwoObservationsOfOneId) {
  runSpoilt([](SimulatedStep& step) {
    auto twin = step.observations.observations.front();
    twin.range += 3;
    step.observations.observations.push_back(twin);
  });
  EXPECT_EQ(estimator.counters()["duplicate"], 3u);
}

TEST_P(BackendBadInput, ObservationsBeforeAnyMotion) {
  SimulatedWorld world(13);
  auto early = world.next().observations;
  early.stamp -= std::chrono::seconds(3);
  estimator.set(early);
  drain();
  EXPECT_TRUE(landmarks().empty());
  runSpoilt([](SimulatedStep&) {});
  EXPECT_EQ(estimator.counters()["before_start"], 1u);
}

TEST_P(BackendBadInput, StampsThatGoBack) {
  runSpoilt([](SimulatedStep& step) { step.observations.stamp -= std::chrono::seconds(2); });
  EXPECT_EQ(estimator.counters()["late"], 3u);
  EXPECT_EQ(estimator.dropped(), 3u);
}

TEST_P(BackendBadInput, ARangeThatCannotBeReckonedWith) {
  runWithObservation([](LandmarkObservation& z) { z.range = 1e155; });
  EXPECT_EQ(estimator.counters()["invalid_observation"], 3u);
  EXPECT_TRUE(test::oneSays(sentences, {"range that no sensor reaches", "left out"}));
}

TEST_P(BackendBadInput, ARangeFarOutsideTheWorld) {
  runWithObservation([](LandmarkObservation& z) { z.range = 1e12; });
  EXPECT_GE(estimator.counters()["gated"], 1u);
}

TEST_P(BackendBadInput, ObservationsWhoseCovarianceIsAbsurdlyLarge) {
  runWithVariances({1e12, 1e100, 1.7e308});
  EXPECT_TRUE(test::oneSays(sentences, {"observation of landmark", "standard deviation"}));
}

TEST_P(BackendBadInput, ObservationsWhoseCovarianceIsAbsurdlySmall) {
  runWithVariances({1e-300, 1e-100, 1e-20});
  EXPECT_TRUE(test::oneSays(sentences, {"observation of landmark", "less than 1e-09"}));
}

TEST_P(BackendBadInput, MotionWhoseCovarianceIsAbsurdlyLarge) {
  for (const double variance : {1e12, 1e100, 1.7e308})
    for (const int axis : {0, 1, 2}) {
      SetUp();
      runSpoilt([&](SimulatedStep& step) { step.motion.covariance(axis, axis) = variance; });
      EXPECT_EQ(estimator.counters()["invalid_motion"], 3u);
    }
  EXPECT_TRUE(test::oneSays(sentences, {"motion", "standard deviation"}));
}

/// What is just accepted must not be too much for the filter either.
TEST_P(BackendBadInput, TheLargestCovariancesThatAreAccepted) {
  runSpoilt([](SimulatedStep& step) {
    for (auto& z : step.observations.observations)
      z.covariance = Eigen::Vector2d(1e6, 100.0).asDiagonal();
  });
  EXPECT_EQ(estimator.counters()["invalid_observation"], 0u);
}

TEST_P(BackendBadInput, TheSmallestCovariancesThatAreAccepted) {
  runWithObservation(
      [](LandmarkObservation& z) { z.covariance = 1.1e-18 * Eigen::Matrix2d::Identity(); });
  EXPECT_EQ(estimator.counters()["invalid_observation"], 0u);
}

TEST_P(BackendBadInput, ALandmarkThatIsFirstSeenAsUnsurelyAsIsAccepted) {
  SimulatedWorld world(12);
  for (int i = 0; i < 60; ++i) {
    auto step = world.next();
    if (i < 3)
      for (auto& z : step.observations.observations)
        z.covariance = Eigen::Vector2d(1e6, 100.0).asDiagonal();
    estimator.set(step.motion);
    estimator.set(step.observations);
    drain();
    ASSERT_TRUE(estimator.backend().pose().pose.isFinite()) << i;
    ASSERT_TRUE(isCovariance(estimator.backend().pose().covariance)) << i;
  }
  for (const auto& landmark : landmarks()) {
    EXPECT_TRUE(landmark.position.allFinite());
    EXPECT_TRUE(isCovariance(landmark.covariance));
  }
}

TEST_P(BackendBadInput, AnArrayOfVeryManyNewLandmarks) {
  runSpoilt([](SimulatedStep& step) {
    for (LandmarkId id = 1000; id < 101000; ++id) {
      auto z = step.observations.observations.front();
      z.id = id;
      step.observations.observations.push_back(z);
    }
  });
  EXPECT_GT(estimator.counters()["observations_beyond_limit"], 3u * 99000u);
  EXPECT_GT(estimator.counters()["new_landmarks_beyond_limit"], 0u);
  EXPECT_LE(landmarks().size(), 16 + 3 * ObservationIntake::kMostNewLandmarks);
  EXPECT_TRUE(test::oneSays(sentences, {"observations", "more than the 500", "left out"}));
}

TEST_P(BackendBadInput, AnArrayOfManyNewLandmarks) {
  runSpoilt([](SimulatedStep& step) {
    for (LandmarkId id = 1000; id < 1300; ++id) {
      auto z = step.observations.observations.front();
      z.id = id;
      step.observations.observations.push_back(z);
    }
  });
  EXPECT_EQ(estimator.counters()["new_landmarks_beyond_limit"], 100u);
  EXPECT_TRUE(test::oneSays(sentences, {"300 new landmarks", "more than the 200"}));
}

TEST_P(BackendBadInput, AnInitialPoseAsUnsureAsCanBe) {
  for (const double variance : {1e12, 1e100, 1.7e308}) {
    SetUp();
    runSpoilt([](SimulatedStep&) {});
    auto place = estimator.backend().pose();
    place.covariance = variance * Eigen::Matrix3d::Identity();
    estimator.set(place);
    EXPECT_TRUE(estimator.backend().pose().pose.isFinite()) << variance;
    EXPECT_TRUE(isCovariance(estimator.backend().pose().covariance)) << variance;
    SimulatedWorld world(12);
    for (int i = 0; i < 70; ++i) {
      const auto step = world.next();
      if (i < 60) continue;
      estimator.set(step.motion);
      estimator.set(step.observations);
      drain();
      EXPECT_TRUE(estimator.backend().pose().pose.isFinite()) << variance;
      EXPECT_TRUE(isCovariance(estimator.backend().pose().covariance)) << variance;
    }
  }
}

std::vector<std::string> backendsThatMapLandmarks() {
  const auto& registry = Registry<Backend>::instance();
  auto names = registry.names();
  const auto maps_none = [&registry](const std::string& name) {
    return capabilitiesOf(*registry.create(name)).find<LandmarkMapper>() == nullptr;
  };
  names.erase(std::remove_if(names.begin(), names.end(), maps_none), names.end());
  return names;
}

INSTANTIATE_TEST_SUITE_P(All, BackendBadInput, testing::ValuesIn(backendsThatMapLandmarks()),
                         [](const auto& name) { return name.param; });

}  // namespace
}  // namespace slam
