// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <set>

#include "slam_core/association/test/toy_policies.hpp"
#include "slam_core/association/test/two_landmarks.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/ekf/candidates.hpp"
#include "slam_core/ekf/ekf_slam.hpp"
#include "slam_core/models/test/simulated_world.hpp"

namespace slam::ekf {
namespace {

using association::AssociationPolicy;
using association::Candidate;
using association::test::addClutter;
using association::test::addStray;
using association::test::observationsOf;
using association::test::removeIds;
using association::test::ToyNearest;
using association::test::ToyNonsense;
using association::test::twoLandmarks;
using test::SimulatedStep;
using test::SimulatedWorld;

const Registrar<AssociationPolicy, ToyNearest> kRegistrar("toy_nearest");

/// The same drive with ids, and without them by distance.
class EkfAssociationTest : public testing::Test {
 protected:
  void configure(const EkfConfig& chosen = EkfConfig()) {
    auto config = chosen;
    with_ids.configure(config);
    config.association = "toy_nearest";
    config.places.sightings = 1;
    by_distance.configure(config);
  }
  static void take(EkfSlam& ekf, const SimulatedStep& step) {
    ekf.set(step.motion);
    ekf.set(step.observations);
    EXPECT_TRUE(ekf.execute().isOk());
  }
  void drive(int steps) {
    for (int i = 0; i < steps; ++i) {
      auto step = world.next();
      take(with_ids, step);
      removeIds(step.observations);
      take(by_distance, step);
      truth = step.truth;
      unknown += as<LandmarkMapper>(by_distance).statistics().unknown;
    }
  }

  EkfSlam with_ids, by_distance;
  SimulatedWorld world{4};
  Pose2 truth;
  int unknown = 0;
};

TEST_F(EkfAssociationTest, APolicyThatPairsByDistanceNeedsNoIds) {
  configure();
  drive(300);
  const auto expected = with_ids.pose(), pose = by_distance.pose();
  EXPECT_EQ(as<LandmarkMapper>(by_distance).landmarks().size(),
            as<LandmarkMapper>(with_ids).landmarks().size());
  EXPECT_EQ(unknown, 0);
  EXPECT_LT((pose.pose.vector() - expected.pose.vector()).norm(), 1e-6);
  EXPECT_LT((pose.covariance - expected.covariance).norm(), 1e-6 * expected.covariance.norm());
  EXPECT_LT(test::nees(truth, pose.pose, pose.covariance), 16.0);
}

TEST_F(EkfAssociationTest, LandmarksWithoutIdsAreGivenSomeOfTheirOwn) {
  configure();
  drive(50);
  std::set<LandmarkId> ids;
  for (const auto& landmark : as<LandmarkMapper>(by_distance).landmarks()) ids.insert(landmark.id);
  EXPECT_EQ(ids.size(), as<LandmarkMapper>(by_distance).landmarks().size()) << "each has its own";
  EXPECT_GE(*ids.begin(), 0);
  for (const auto& innovation : as<LandmarkMapper>(by_distance).statistics().innovations)
    EXPECT_EQ(ids.count(innovation.id), 1u) << innovation.id;
}

/// A neighbourhood of four landmarks is renewed all the time: what is seen again comes back into it
/// by its place.
TEST_F(EkfAssociationTest, LandmarksComeIntoTheNeighbourhoodByPlace) {
  EkfConfig config;
  config.neighbourhood = 4;
  configure(config);
  drive(300);
  EXPECT_EQ(as<LandmarkMapper>(by_distance).landmarks().size(),
            as<LandmarkMapper>(with_ids).landmarks().size());
  EXPECT_LT((by_distance.pose().pose.vector() - with_ids.pose().pose.vector()).norm(), 1e-6);
}

TEST_F(EkfAssociationTest, AFixedMapStaysAsItIs) {
  configure();
  drive(200);
  EkfConfig config;
  config.mode = BackendMode::kLocalization;
  config.association = "toy_nearest";
  EkfSlam localizer;
  localizer.configure(config);
  as<MapKeeper>(localizer).set(as<MapKeeper>(by_distance).state());
  for (int i = 0; i < 50; ++i) {
    auto step = world.next();
    removeIds(step.observations);
    if (i == 10) addStray(step.observations);
    take(localizer, step);
    truth = step.truth;
  }
  EXPECT_EQ(as<LandmarkMapper>(localizer).landmarks().size(),
            as<LandmarkMapper>(by_distance).landmarks().size());
  EXPECT_EQ(localizer.counters()["not_in_map"], 1u);
  const auto pose = localizer.pose();
  EXPECT_LT(test::nees(truth, pose.pose, pose.covariance), 16.0);
}

TEST_F(EkfAssociationTest, APolicyThatTalksNonsenseSpoilsNoFixedMap) {
  const Registrar<AssociationPolicy, ToyNonsense> registrar("toy_nonsense");
  configure();
  drive(50);
  EkfConfig config;
  config.mode = BackendMode::kLocalization;
  config.association = "toy_nonsense";
  EkfSlam localizer;
  localizer.configure(config);
  as<MapKeeper>(localizer).set(as<MapKeeper>(with_ids).state());
  for (int i = 0; i < 30; ++i) take(localizer, world.next());
  EXPECT_EQ(as<LandmarkMapper>(localizer).landmarks().size(),
            as<LandmarkMapper>(with_ids).landmarks().size());
  EXPECT_EQ(as<LandmarkMapper>(localizer).statistics().used, 0);
  EXPECT_GT(localizer.counters()["not_in_map"], 0u);
  EXPECT_GT(localizer.counters()["unknown_id"], 0u);
}

TEST_F(EkfAssociationTest, APolicyThatIsNotKnownIsNamedWithThoseThereAre) {
  EkfConfig config;
  config.association = "known_idz";
  try {
    EkfSlam().configure(config);
    FAIL();
  } catch (const ConfigError& error) {
    const std::string fault = error.what();
    EXPECT_NE(fault.find("association 'known_idz'"), std::string::npos) << fault;
    EXPECT_NE(fault.find("known_ids"), std::string::npos) << fault;
  }
}

/// The policies that there are, with something that comes by now and then.
class EkfPlacePolicyTest : public testing::TestWithParam<const char*> {
 protected:
  void configure(BackendMode mode = BackendMode::kSlam) {
    EkfConfig config;
    config.association = GetParam();
    config.mode = mode;
    ekf.configure(config);
  }
  void drive(int steps) {
    for (int i = 0; i < steps; ++i) {
      auto step = world.next();
      removeIds(step.observations);
      if (i % 3 == 0) addClutter(i, step.observations);
      ekf.set(step.motion);
      ekf.set(step.observations);
      ekf.execute();
      truth = step.truth;
    }
  }
  double error(const Landmark& landmark) const {
    double error = 1e9;
    for (const auto& [id, place] : world.landmarks())
      error = std::min(error, (place - landmark.position).norm());
    return error;
  }

  EkfSlam ekf;
  SimulatedWorld world{4};
  Pose2 truth;
};

INSTANTIATE_TEST_SUITE_P(Of, EkfPlacePolicyTest, testing::Values("nearest", "jcbb"),
                         [](const auto& policy) { return std::string(policy.param); });

TEST_P(EkfPlacePolicyTest, MapsTheWorldWithoutIdsAndClutterStaysOut) {
  configure();
  drive(400);
  const auto map = as<LandmarkMapper>(ekf).landmarks();
  EXPECT_EQ(map.size(), world.landmarks().size());
  for (const auto& landmark : map) EXPECT_LT(error(landmark), 0.4);
  EXPECT_GT(ekf.counters()["on_trial"], 0u);
  const auto pose = ekf.pose();
  EXPECT_LT(test::nees(truth, pose.pose, pose.covariance), 16.0);
}

TEST_P(EkfPlacePolicyTest, ToLocaliseInAnEmptyMapIsToldAndAddsNothing) {
  configure(BackendMode::kLocalization);
  auto step = world.next();
  removeIds(step.observations);
  ekf.set(step.motion);
  ekf.set(step.observations);
  EXPECT_EQ(ekf.execute().message, "there is no map to localise in; load one");
  EXPECT_TRUE(as<LandmarkMapper>(ekf).landmarks().empty());
}

TEST_P(EkfPlacePolicyTest, SaysWhatEachObservationWasTakenFor) {
  configure();
  drive(60);
  const auto statistics = as<LandmarkMapper>(ekf).statistics();
  int landmarks = 0;
  for (const auto& taken : statistics.associations) {
    EXPECT_EQ(taken.own_id, kUnknownId);
    const bool is_of_one =
        taken.taken_for == TakenFor::kLandmark || taken.taken_for == TakenFor::kNew;
    EXPECT_EQ(taken.landmark != kUnknownId, is_of_one);
    landmarks += taken.taken_for == TakenFor::kLandmark;
  }
  EXPECT_EQ(landmarks, statistics.used);
  EXPECT_GT(landmarks, 0);
}

/// What a policy is told of a map of two landmarks and their observations.
class PlaceCandidatesTest : public testing::Test {
 protected:
  PlaceCandidatesTest() {
    const PoseEstimate robot{Pose2(), Eigen::Vector3d(0.01, 0.01, 0.001).asDiagonal()};
    state = EkfState({makeLinearization("right_invariant")}, {}, robot);
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
      const auto& z = array.observations[i];
      RangeBearingModel::Jacobian23 J_robot;
      Eigen::Matrix2d J_z;
      model.invert(Pose2(), Pose2(), z.vector(), &J_robot, &J_z);
      state.append(state.freeId(), {landmarks[i], J_robot, J_z * z.covariance * J_z.transpose()});
    }
    near = landmarksByPlace(array, state, model, 18.0);
    state.take(near.all());
  }

  RangeBearingModel model;
  EkfState state;
  std::vector<Eigen::Vector2d> landmarks = twoLandmarks();
  LandmarkObservationArray array = observationsOf(landmarks);
  LandmarksByPlace near;
  association::DescriptorMap descriptors;
};

TEST_F(PlaceCandidatesTest, AreTheLandmarksAroundWithTheirInnovation) {
  const PlaceCandidates source(array, state, model, near, descriptors);
  EXPECT_EQ(source.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    std::vector<Candidate> candidates;
    source.candidates(i, candidates);
    ASSERT_EQ(candidates.size(), 1u);
    EXPECT_EQ(candidates[0].landmark, i);
    EXPECT_NEAR(candidates[0].nu.x(), 0.02, 1e-12);
    EXPECT_NEAR(candidates[0].nu.y(), 0.0, 1e-12);
    // the robot has not moved since it saw the landmark: only what it measured then is in doubt
    const Eigen::Matrix2d R = array.observations[i].covariance;
    EXPECT_LT((candidates[0].S - 2.0 * R).norm(), 0.05 * R.norm());
  }
}

TEST_F(PlaceCandidatesTest, TellHowTwoInnovationsBelongTogether) {
  Eigen::Matrix3d Q = Eigen::Vector3d(0.04, 0.02, 0.001).asDiagonal();
  state.predict(Pose2(0.5, 0.1, 0.1), Q);
  const PlaceCandidates source(array, state, model, near, descriptors);
  const Eigen::Matrix2d cross = source.crossCovariance({0, 0}, {1, 1});
  const std::vector<Match> both = {{state.slotOf(0), array.observations[0]},
                                   {state.slotOf(1), array.observations[1]}};
  const auto S = ObservationUpdate(model, state, array.sensor_pose, both, 1).joint().S;
  EXPECT_TRUE(cross.isApprox((S.block<2, 2>(0, 2)), 1e-12));
  EXPECT_GT(cross.norm(), 0.01) << "a wrong pose is common to both";
  EXPECT_TRUE(source.crossCovariance({1, 1}, {0, 0}).isApprox(cross.transpose(), 1e-12));
}

TEST_F(PlaceCandidatesTest, FarFromTheMapThereAreNone) {
  array.observations[0].range = 30.0;
  near = landmarksByPlace(array, state, model, 18.0);
  EXPECT_TRUE(near.of[0].empty());
  EXPECT_EQ(near.all().others, 1);
  EXPECT_EQ(near.all().landmarks, std::vector<Eigen::Index>{1});
}

}  // namespace
}  // namespace slam::ekf
