// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <string>

#include "slam_core/contract/association_chooser.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/contract/landmark_remover.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/estimator.hpp"

namespace slam {
namespace {

using test::SimulatedStep;
using test::SimulatedWorld;

/// Removes landmarks while the back-ends associate by place.
class LandmarkRemoval : public testing::TestWithParam<std::string> {
 protected:
  void configure(const std::vector<std::string>& settings) {
    Settings configured({}, {}, settings);
    estimator.use(Registry<Backend>::instance().create(GetParam()));
    estimator.configure(configured);
  }
  void take(const SimulatedStep& step) {
    estimator.set(step.motion);
    estimator.set(step.observations);
    do estimator.execute();
    while (estimator.report());
  }
  LandmarkMap map() const { return estimator.capabilities().find<LandmarkMapper>()->landmarks(); }
  /// The landmark of the map that is nearest to a place [m].
  Landmark nearest(const Eigen::Vector2d& place) const {
    Landmark best;
    for (const auto& landmark : map())
      if (best.id == kUnknownId ||
          (landmark.position - place).norm() < (best.position - place).norm())
        best = landmark;
    return best;
  }
  Estimator estimator;
  SimulatedWorld world{3};
};

TEST_P(LandmarkRemoval, WhatIsRemovedByPlaceComesBackAfterANewTrialOnly) {
  configure({"association=jcbb", GetParam() + ".association_sightings=10"});
  auto step = world.next();
  for (int i = 0; i < 100; ++i) take(step = world.next());
  const auto in_view = step.observations.observations.front();
  const auto mark = nearest(world.landmarks().at(in_view.id));
  const auto size = map().size();
  const auto status = removeLandmark(mark.id, estimator);
  ASSERT_TRUE(status.isOk()) << status.message;
  for (int i = 0; i < 5; ++i) take(world.next());
  EXPECT_EQ(map().size(), size - 1);
  EXPECT_GT((nearest(mark.position).position - mark.position).norm(), 0.5);
  for (int i = 0; i < 150; ++i) take(world.next());
  EXPECT_LT((nearest(mark.position).position - mark.position).norm(), 0.3)
      << "it is there, so that it is found again";
  EXPECT_NE(nearest(mark.position).id, mark.id);
}

TEST_P(LandmarkRemoval, IsRefusedWhereTheMapIsFixed) {
  configure({GetParam() + ".mode=localization"});
  MapState map;
  map.robot.covariance = 0.01 * Eigen::Matrix3d::Identity();
  map.landmarks = {{7, {1.0, 2.0}, 0.01 * Eigen::Matrix2d::Identity()}};
  estimator.set(map);
  const auto status = removeLandmark(7, estimator);
  EXPECT_EQ(status.level, Status::Level::kError);
  EXPECT_EQ(status.message,
            "the map is fixed in the mode localization: remove the landmark while mapping, or from "
            "the map's file");
  EXPECT_EQ(this->map().size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Backends, LandmarkRemoval, testing::Values("ekf", "pf", "graph", "seif"),
                         [](const auto& backend) { return backend.param; });

TEST(LandmarkRemovalOfAGrid, IsRefusedByABackEndWithoutLandmarks) {
  Estimator estimator;
  Settings settings({}, {}, {"backend=grid", "map=grid"});
  estimator.use(Registry<Backend>::instance().create("grid"));
  estimator.configure(settings);
  EXPECT_EQ(removeLandmark(7, estimator).message,
            "this back-end removes no landmarks: use ekf, pf or graph");
}

}  // namespace
}  // namespace slam
