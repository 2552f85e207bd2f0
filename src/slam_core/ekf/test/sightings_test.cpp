// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/sightings.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/ekf/ekf_slam.hpp"

namespace slam::ekf {
namespace {

constexpr LandmarkId kOdd = 77;
const Eigen::Vector2d kPlace(4, 1.5);

/// A robot that stands among three landmarks, and looks at a fourth.
class SightingsTest : public testing::Test {
 protected:
  void SetUp() override { ekf.configure(EkfConfig()); }
  static LandmarkObservation of(LandmarkId id, const Eigen::Vector2d& place) {
    LandmarkObservation z;
    z.id = id;
    z.range = place.norm();
    z.bearing = std::atan2(place.y(), place.x());
    z.covariance = Eigen::Vector2d(0.01, 0.0004).asDiagonal();
    return z;
  }
  Status look(const Eigen::Vector2d& odd, bool others_fit = true) {
    const double off = others_fit ? 0.0 : 3.0;
    LandmarkObservationArray array;
    array.observations = {of(1, {3 + off, 0}), of(2, {2 + off, 2}), of(3, {4 + off, -1}),
                          of(kOdd, odd)};
    ekf.set(array);
    return ekf.execute();
  }
  Eigen::Vector2d placeOfOdd() { return as<LandmarkMapper>(ekf).landmarks().back().position; }
  std::uint64_t begunAnew() const { return ekf.counters()["begun_anew"]; }

  EkfSlam ekf;
};

TEST_F(SightingsTest, ALandmarkSeenOnceByChanceFarAwayIsBegunAnewWhereItIs) {
  look({27, 42});
  std::string warning;
  for (int i = 0; i < 30; ++i) {
    const auto status = look(kPlace);
    if (!status.isOk()) warning += status.message;
  }
  EXPECT_LT((placeOfOdd() - kPlace).norm(), 0.01);
  EXPECT_EQ(begunAnew(), 1u);
  EXPECT_TRUE(test::oneSays({warning}, {"landmark 77", "re-initialised"})) << warning;
  EXPECT_EQ(as<LandmarkMapper>(ekf).statistics().used, 4);
  EXPECT_EQ(as<LandmarkMapper>(ekf).landmarks().size(), 4u);
  EXPECT_EQ(as<MapKeeper>(ekf).state().joint_covariance.llt().info(), Eigen::Success);
}

TEST_F(SightingsTest, AConfirmedLandmarkThatWasMovedIsBegunAnewAndWarnedOf) {
  for (int i = 0; i < 6; ++i) EXPECT_TRUE(look(kPlace).isOk());
  for (int i = 1; i < 10; ++i) EXPECT_TRUE(look({2, 5}).isOk()) << i;
  EXPECT_TRUE(look(kPlace).isOk()) << "it is where it should be in between";
  for (int i = 1; i < 10; ++i) EXPECT_TRUE(look({2, 5}).isOk()) << i;
  EXPECT_EQ(begunAnew(), 0u);
  EXPECT_TRUE(test::oneSays({look({2, 5}).message}, {"landmark 77", "it was moved"}));
  EXPECT_EQ(begunAnew(), 1u);
  EXPECT_TRUE(look({2, 5}).isOk());
  EXPECT_LT((placeOfOdd() - Eigen::Vector2d(2, 5)).norm(), 0.01);
}

TEST_F(SightingsTest, ALandmarkThatIsElsewhereAgainAndAgainIsRemoved) {
  std::string warning;
  const Eigen::Vector2d other(2, 5);
  for (const auto& place : {kPlace, other, kPlace, other})
    for (int i = 0; i < 16; ++i)
      if (const auto status = look(place); !status.isOk()) warning = status.message;
  EXPECT_TRUE(test::oneSays({warning}, {"landmark 77", "not used any more"})) << warning;
  EXPECT_EQ(begunAnew(), 2u);
  EXPECT_EQ(as<LandmarkMapper>(ekf).landmarks().size(), 3u);
  EXPECT_GT(ekf.counters()["distrusted_id"], 0u);
}

TEST_F(SightingsTest, ALandmarkOfALoadedMapIsConfirmed) {
  for (const bool localizes : {false, true}) {
    EkfConfig config;
    config.mode = localizes ? BackendMode::kLocalization : BackendMode::kSlam;
    ekf.configure(config);
    MapState map;
    map.robot.covariance = 1e-6 * Eigen::Matrix3d::Identity();
    const Eigen::Matrix2d P = 1e-4 * Eigen::Matrix2d::Identity();
    map.landmarks = {{1, {3, 0}, P}, {2, {2, 2}, P}, {3, {4, -1}, P}, {kOdd, kPlace, P}};
    as<MapKeeper>(ekf).set(map);
    Status status;
    for (int i = 0; i < 10; ++i) status = look({2, 5});
    EXPECT_TRUE(test::oneSays({status.message}, {"landmark 77", "moved"}));
    EXPECT_TRUE(look({2, 5}).isOk()) << "it is told once";
    EXPECT_EQ(begunAnew(), localizes ? 0u : 1u);
    const Eigen::Vector2d place = localizes ? kPlace : Eigen::Vector2d(2, 5);
    EXPECT_LT((placeOfOdd() - place).norm(), 0.01);
  }
}

TEST_F(SightingsTest, NoLandmarkIsDoubtedWhileNothingElseFits) {
  look({27, 42});
  for (int i = 0; i < 10; ++i) look(kPlace, false);
  EXPECT_EQ(begunAnew(), 0u);
  EXPECT_GT((placeOfOdd() - kPlace).norm(), 10.0);
}

TEST_F(SightingsTest, AreForgottenWithReset) {
  for (int i = 0; i < 6; ++i) look(kPlace);
  ekf.reset();
  look({27, 42});
  for (int i = 0; i < 8; ++i) look(kPlace);
  EXPECT_EQ(begunAnew(), 1u);
  EXPECT_LT((placeOfOdd() - kPlace).norm(), 0.05);
}

}  // namespace
}  // namespace slam::ekf
