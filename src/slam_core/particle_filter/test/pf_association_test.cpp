// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "slam_core/association/test/toy_policies.hpp"
#include "slam_core/association/test/two_landmarks.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/particle_filter/filter/fast_slam.hpp"
#include "slam_core/particle_filter/landmarks/particle_candidates.hpp"

namespace slam::particle_filter {
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
using slam::test::SimulatedStep;
using slam::test::SimulatedWorld;

/// So narrow that right observations are taken for new landmarks, by some particles and not by
/// others.
class ToyNarrow final : public ToyNearest {
 public:
  ToyNarrow() : ToyNearest(6.0) {}
};

const Registrar<AssociationPolicy, ToyNearest> kNearest("toy_nearest");
const Registrar<AssociationPolicy, ToyNarrow> kNarrow("toy_narrow");
const Registrar<AssociationPolicy, ToyNonsense> kNonsense("toy_nonsense");

PfConfig configOf(const std::string& association) {
  PfConfig config;
  config.association = association;
  if (association.rfind("toy", 0) == 0) config.places.sightings = 1;
  return config;
}

/// The same drive with ids, and without them by place.
class PfAssociationTest : public testing::Test {
 protected:
  static std::unique_ptr<FastSlam> filterOf(const PfConfig& config) {
    auto filter = std::make_unique<FastSlam>();
    filter->configure(config);
    return filter;
  }
  static void take(FastSlam& filter, const SimulatedStep& step) {
    give(step.motion, filter);
    give(step.observations, filter);
    EXPECT_TRUE(filter.execute().isOk());
  }
  void drive(int steps) {
    for (int i = 0; i < steps; ++i) {
      auto step = world.next();
      take(*with_ids, step);
      removeIds(step.observations);
      take(*by_place, step);
      truth = step.truth;
      unknown += as<LandmarkMapper>(*by_place).statistics().unknown;
    }
  }
  /// The distance of a landmark of the map from the nearest one of the world [m].
  double error(const Landmark& landmark) const {
    double error = 1e9;
    for (const auto& [id, place] : world.landmarks())
      error = std::min(error, (place - landmark.position).norm());
    return error;
  }

  std::unique_ptr<FastSlam> with_ids = filterOf({}), by_place = filterOf(configOf("toy_nearest"));
  SimulatedWorld world{4};
  Pose2 truth;
  int unknown = 0;
};

TEST_F(PfAssociationTest, APolicyThatPairsByDistanceNeedsNoIds) {
  drive(300);
  const auto pose = by_place->pose();
  EXPECT_EQ(as<LandmarkMapper>(*by_place).landmarks().size(),
            as<LandmarkMapper>(*with_ids).landmarks().size());
  EXPECT_EQ(as<LandmarkMapper>(*by_place).statistics().landmarks,
            as<LandmarkMapper>(*with_ids).statistics().landmarks);
  EXPECT_EQ(unknown, 0);
  EXPECT_LT((pose.pose.vector() - with_ids->pose().pose.vector()).norm(), 0.1);
  EXPECT_LT(slam::test::nees(truth, pose.pose, pose.covariance), 16.0);
  for (const auto& landmark : as<LandmarkMapper>(*by_place).landmarks())
    EXPECT_LT(error(landmark), 0.3);
}

TEST_F(PfAssociationTest, LandmarksWithoutIdsAreGivenSomeOfTheirOwn) {
  drive(50);
  std::set<LandmarkId> ids;
  for (const auto& landmark : as<LandmarkMapper>(*by_place).landmarks()) ids.insert(landmark.id);
  EXPECT_EQ(ids.size(), as<LandmarkMapper>(*by_place).landmarks().size()) << "each has its own";
  EXPECT_GE(*ids.begin(), 0);
  EXPECT_FALSE(as<LandmarkMapper>(*by_place).statistics().innovations.empty());
  for (const auto& innovation : as<LandmarkMapper>(*by_place).statistics().innovations)
    EXPECT_EQ(ids.count(innovation.id), 1u) << innovation.id;
}

TEST_F(PfAssociationTest, EachParticleHasItsOwnLandmarks) {
  by_place = filterOf(configOf("toy_narrow"));
  std::set<std::size_t> sizes;
  for (int i = 0; i < 100; ++i) {
    drive(1);
    const auto& particles = by_place->particleSet();
    for (std::size_t k = 0; k < particles.size(); ++k) sizes.insert(particles[k].map.size());
    const auto told = as<LandmarkMapper>(*by_place).landmarks();
    EXPECT_EQ(told.size(), particles[particles.best()].map.size());
    for (const auto& landmark : told) EXPECT_LT(error(landmark), 1.0);
  }
  EXPECT_GT(sizes.size(), 3u);
  const auto pose = by_place->pose();
  EXPECT_LT((pose.pose.vector() - truth.vector()).norm(), 0.5);
}

TEST_F(PfAssociationTest, ParticlesThatDisagreeHaveTheSameBitsWithAnyNumberOfThreads) {
  auto config = configOf("toy_narrow");
  by_place = filterOf(config);
  config.threads = 3;
  with_ids = filterOf(config);
  for (int i = 0; i < 60; ++i) {
    auto step = world.next();
    removeIds(step.observations);
    take(*by_place, step);
    take(*with_ids, step);
  }
  EXPECT_EQ(by_place->pose().pose.vector(), with_ids->pose().pose.vector());
  EXPECT_EQ(by_place->pose().covariance, with_ids->pose().covariance);
  const auto one = as<LandmarkMapper>(*by_place).landmarks(),
             three = as<LandmarkMapper>(*with_ids).landmarks();
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].position, three[i].position);
}

TEST_F(PfAssociationTest, AFixedMapStaysAsItIs) {
  drive(200);
  auto config = configOf("toy_nearest");
  config.mode = BackendMode::kLocalization;
  const auto localizer = filterOf(config);
  as<MapKeeper>(*localizer).set(as<MapKeeper>(*by_place).state());
  for (int i = 0; i < 50; ++i) {
    auto step = world.next();
    removeIds(step.observations);
    if (i == 10) addStray(step.observations);
    take(*localizer, step);
    truth = step.truth;
  }
  EXPECT_EQ(as<LandmarkMapper>(*localizer).landmarks().size(),
            as<LandmarkMapper>(*by_place).landmarks().size());
  EXPECT_EQ(localizer->counters()["not_in_map"], 1u);
  EXPECT_LT((localizer->pose().pose.vector() - truth.vector()).norm(), 0.5);
}

TEST_F(PfAssociationTest, APolicyThatTalksNonsenseSpoilsNoFixedMap) {
  drive(50);
  auto config = configOf("toy_nonsense");
  config.mode = BackendMode::kLocalization;
  const auto localizer = filterOf(config);
  as<MapKeeper>(*localizer).set(as<MapKeeper>(*with_ids).state());
  for (int i = 0; i < 30; ++i) take(*localizer, world.next());
  EXPECT_EQ(as<LandmarkMapper>(*localizer).landmarks().size(),
            as<LandmarkMapper>(*with_ids).landmarks().size());
  EXPECT_EQ(as<LandmarkMapper>(*localizer).statistics().used, 0);
  EXPECT_GT(localizer->counters()["not_in_map"], 0u);
  EXPECT_GT(localizer->counters()["unknown_id"], 0u);
}

TEST_F(PfAssociationTest, ThePoliciesMapTheWorldWithoutIds) {
  for (const std::string policy : {"nearest", "jcbb"}) {
    by_place = filterOf(configOf(policy));
    world = SimulatedWorld(4);
    for (int i = 0; i < 300; ++i) {
      auto step = world.next();
      removeIds(step.observations);
      if (i % 3 == 0) addClutter(i, step.observations);
      take(*by_place, step);
      truth = step.truth;
    }
    const auto told = as<LandmarkMapper>(*by_place).landmarks();
    EXPECT_EQ(told.size(), world.landmarks().size()) << policy;
    for (const auto& landmark : told) EXPECT_LT(error(landmark), 0.4) << policy;
    EXPECT_LT((by_place->pose().pose.vector() - truth.vector()).norm(), 0.3) << policy;
    EXPECT_FALSE(as<LandmarkMapper>(*by_place).statistics().associations.empty());
  }
}

TEST_F(PfAssociationTest, TheStatisticsSayHowOftenARightObservationPasses) {
  auto config = configOf("known_ids");
  config.gate_probability = 0.995;
  with_ids = filterOf(config);
  drive(1);
  EXPECT_EQ(as<LandmarkMapper>(*with_ids).statistics().gate_probability, 0.995);
}

TEST_F(PfAssociationTest, APolicyThatIsNotKnownIsNamedWithThoseThereAre) {
  try {
    filterOf(configOf("known_idz"));
    FAIL();
  } catch (const ConfigError& error) {
    const std::string fault = error.what();
    EXPECT_NE(fault.find("association 'known_idz'"), std::string::npos) << fault;
    EXPECT_NE(fault.find("known_ids"), std::string::npos) << fault;
  }
}

/// What a policy is told of a particle's map of two landmarks and their observations.
class PfCandidatesTest : public testing::Test {
 protected:
  PfCandidatesTest() {
    prior.covariance = Eigen::Vector3d(0.01, 0.01, 0.001).asDiagonal();
    index.append(30);
    for (const auto& place : twoLandmarks()) {
      LandmarkEstimate landmark(place, 0.004 * Eigen::Matrix2d::Identity());
      landmark.number = static_cast<std::uint32_t>(index.size());
      index.append(40 + static_cast<LandmarkId>(index.size()));
      map.push_back(landmark);
    }
  }

  RangeBearingModel model;
  ParticleMap::Memory memory;
  ParticleMap map{memory};
  LandmarkIndex index;
  PoseGaussian prior;
  LandmarkObservationArray array = observationsOf(twoLandmarks());
  association::DescriptorMap descriptors;
  PlaceCandidates source{array, index, descriptors, map, prior, model, 18.0};
};

TEST_F(PfCandidatesTest, AreTheLandmarksAroundWithTheirInnovation) {
  EXPECT_EQ(source.size(), 2u);
  EXPECT_EQ(source.find(30), std::nullopt) << "another particle's";
  EXPECT_EQ(source.find(42), 1u);
  for (std::size_t i = 0; i < 2; ++i) {
    std::vector<Candidate> candidates;
    source.candidates(i, candidates);
    ASSERT_EQ(candidates.size(), 1u);
    EXPECT_EQ(candidates[0].landmark, i);
    EXPECT_NEAR(candidates[0].nu.x(), 0.02, 1e-12);
    EXPECT_NEAR(candidates[0].nu.y(), 0.0, 1e-12);
    const auto e = expect(model, prior.mean, array.sensor_pose, map[i], array.observations[i]);
    EXPECT_EQ(candidates[0].S,
              Eigen::Matrix2d(e->H_robot * prior.covariance * e->H_robot.transpose() + e->R));
  }
}

TEST_F(PfCandidatesTest, FarFromTheMapThereAreNone) {
  array.observations[0].range = 30.0;
  std::vector<Candidate> candidates;
  source.candidates(0, candidates);
  EXPECT_TRUE(candidates.empty());
}

TEST_F(PfCandidatesTest, OfAnExactPoseHaveNothingInCommon) {
  EXPECT_GT(source.crossCovariance({0, 0}, {1, 1}).norm(), 1e-3);
  EXPECT_TRUE(source.crossCovariance({1, 1}, {0, 0})
                  .isApprox(source.crossCovariance({0, 0}, {1, 1}).transpose(), 1e-12));
  prior.covariance.setZero();
  EXPECT_EQ(source.crossCovariance({0, 0}, {1, 1}).norm(), 0.0);
}

}  // namespace
}  // namespace slam::particle_filter
