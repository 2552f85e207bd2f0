// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <string>

#include "slam_core/contract/registry.hpp"
#include "slam_core/product/estimator.hpp"
#include "slam_core/product/test/grove.hpp"

namespace slam {
namespace {

/// A robot that drives in a circle among trees with ids.
class LostById : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    Settings settings({}, {}, {"association=known_ids"});
    estimator.use(Registry<Backend>::instance().create(GetParam()));
    estimator.configure(settings);
  }
  void drive(int steps) {
    for (int i = 0; i < steps; ++i) {
      estimator.set(grove.drive());
      estimator.set(grove.look(true));
      while (true) {
        estimator.execute();
        if (!estimator.report()) break;
        report = *estimator.report();
      }
      lost += isLost() ? 1 : 0;
      wrong += !isLost() && error() > 0.5 ? 1 : 0;
    }
  }
  bool isLost() const { return report.trust == Trust::kLost; }
  double error() const {
    const Pose2 in_map = start.inverse() * grove.truth;
    return (report.pose.pose.position() - in_map.position()).norm();
  }

  const Pose2 start{15.0, 7.0, 0.0};
  static constexpr int kLap = 252;  // steps
  test::Grove grove{1};
  Estimator estimator;
  StepReport report;
  int lost = 0, wrong = 0;  ///< steps; wrong without being lost
};

/// It is carried to where it has never been, so that all that it sees there is new.
TEST_P(LostById, NoticesThatItWasCarriedBeyondItsMap) {
  drive(kLap / 4);
  ASSERT_EQ(wrong, 0);
  ASSERT_EQ(lost, 0);
  grove.truth = grove.truth * Pose2::exp(80 * Eigen::Vector3d(0.2, 0.0, 0.025));
  drive(40);
  EXPECT_LE(wrong, 3) << "three views show it";
  EXPECT_TRUE(isLost());
  drive(kLap / 2);
  EXPECT_LE(wrong, 3);
  EXPECT_FALSE(isLost()) << "it is where its map began";
  for (const auto& landmark : estimator.capabilities().find<LandmarkMapper>()->landmarks()) {
    const auto& tree = grove.trees()[static_cast<std::size_t>(landmark.id)];
    EXPECT_LT((landmark.position - start.inverse().transform(tree)).norm(), 0.5) << landmark.id;
  }
}

TEST_P(LostById, IsNotLostOnLapsThatNothingDisturbs) {
  drive(3 * kLap);
  EXPECT_EQ(lost, 0);
  EXPECT_EQ(wrong, 0);
}

INSTANTIATE_TEST_SUITE_P(Backends, LostById, testing::Values("ekf", "pf", "graph", "seif"));

}  // namespace
}  // namespace slam
