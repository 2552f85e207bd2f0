// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/camera/pose_fit.hpp"
#include "slam_core/common/random.hpp"
#include "slam_core/mono_graph/bundle.hpp"
#include "slam_core/mono_graph/test/room_of_pictures.hpp"
#include "slam_core/mono_graph/triangulation.hpp"

// Poses and points from what cameras see of points that are known.

namespace slam::mono_graph {
namespace {

constexpr double kSigma = 0.002;  // on the plane z = 1

NormalisedCamera camera() { return NormalisedCamera(test::RoomOfPictures::mount()); }

/// Points ahead of a robot at the origin.
std::vector<Eigen::Vector3d> pointsAhead(std::uint64_t seed, int count) {
  RandomStream random(seed, 0);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i)
    points.emplace_back(2.0 + 2.0 * random.uniform(), 2.0 * random.uniform() - 1.0,
                        1.5 * random.uniform());
  return points;
}

std::vector<PoseSighting> seenFrom(const Pose2& pose, const std::vector<Eigen::Vector3d>& points,
                                   RandomStream& random) {
  std::vector<PoseSighting> sightings;
  for (const auto& point : points) {
    const Eigen::Vector2d noise(random.gaussian(), random.gaussian());
    sightings.push_back({point, *camera().project(pose, point) + kSigma * noise, kSigma});
  }
  return sightings;
}

TEST(PoseFit, FindsThePoseAmongOutliers) {
  const auto points = pointsAhead(1, 60);
  const Pose2 truth(0.2, -0.1, 0.1);
  RandomStream random(1, 1);
  auto sightings = seenFrom(truth, points, random);
  for (std::size_t i = 0; i < 15; ++i) sightings[i].seen.x() += 0.05 + 0.01 * double(i);
  const auto fit = fitPose(camera(), sightings, Pose2(), std::nullopt);
  ASSERT_TRUE(fit.has_value());
  EXPECT_LT((fit->pose.vector() - truth.vector()).norm(), 0.02);
  for (std::size_t i = 0; i < 15; ++i) EXPECT_FALSE(fit->fits[i]);
  EXPECT_GE(fit->count, 38U);
  EXPECT_EQ(countFits(camera(), sightings, fit->pose), fit->count);
}

TEST(PoseFit, HasTheErrorsThatItsCovarianceSays) {
  double nees = 0.0;
  constexpr int kRuns = 200;
  for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
    RandomStream random(seed, 1);
    const Pose2 truth(0.1, 0.1, -0.1);
    const auto fit =
        fitPose(camera(), seenFrom(truth, pointsAhead(seed, 40), random), Pose2(), std::nullopt);
    ASSERT_TRUE(fit.has_value());
    const Eigen::Vector3d error = fit->pose.vector() - truth.vector();
    nees += error.dot(fit->covariance.inverse() * error) / kRuns;
  }
  EXPECT_NEAR(nees, 3.0, 0.6);
}

TEST(PoseFit, TakesThePriorWherePointsSayNothing) {
  const PosePrior prior{Pose2(1.0, 2.0, 0.5), 0.01 * Eigen::Matrix3d::Identity()};
  const auto fit = fitPose(camera(), {}, prior.pose, prior);
  ASSERT_TRUE(fit.has_value());
  EXPECT_LT((fit->pose.vector() - prior.pose.vector()).norm(), 1e-9);
  EXPECT_FALSE(fitPose(camera(), {}, Pose2(), std::nullopt).has_value());
}

TEST(Triangulation, MeetsWhereRaysMeet) {
  const Eigen::Vector3d point(3.0, 0.5, 1.0), a(0, 0, 0.6), b(0.0, 0.4, 0.6);
  const auto met = intersectionOf(a, point - a, b, point - b, 0.01);
  ASSERT_TRUE(met.has_value());
  EXPECT_LT((*met - point).norm(), 1e-9);
  EXPECT_FALSE(intersectionOf(a, point - a, b, point - b, 0.5).has_value()) << "too parallel";
  EXPECT_FALSE(intersectionOf(a, a - point, b, b - point, 0.01).has_value()) << "behind";
  EXPECT_FALSE(intersectionOf(a, point - a, b, point - a, 0.01).has_value()) << "parallel";
}

/// Views along an arc, and points that all of them see.
class BundleOfViews : public testing::Test {
 protected:
  BundleOfViews() : points_(pointsAhead(5, 80)) {
    RandomStream random(5, 1);
    for (int i = 0; i < 6; ++i) {
      truth_.push_back(Pose2(0.12 * i, 0.05 * i, 0.02 * i));
      bundle_.views.push_back({truth_.back(), camera(), i == 0});
      const auto sightings = seenFrom(truth_.back(), points_, random);
      for (std::size_t k = 0; k < points_.size(); ++k)
        bundle_.observations.push_back({i, static_cast<int>(k), sightings[k].seen, kSigma});
      if (i > 0)
        bundle_.ways.push_back({i - 1, i, truth_[std::size_t(i - 1)].between(truth_.back()),
                                Eigen::Vector3d(1e-6, 1e-6, 1e-6).asDiagonal()});
    }
    bundle_.points = points_;
    for (std::size_t i = 1; i < 6; ++i)
      bundle_.views[i].pose = Pose2::fromVector(
          truth_[i].vector() + 0.03 * Eigen::Vector3d(random.gaussian(), random.gaussian(), 0.3));
    for (auto& point : bundle_.points)
      point += 0.1 * Eigen::Vector3d(random.gaussian(), random.gaussian(), random.gaussian());
  }
  double worstError() const {
    double worst = 0.0;
    for (std::size_t i = 0; i < truth_.size(); ++i)
      worst = std::max(worst, (bundle_.views[i].pose.vector() - truth_[i].vector()).norm());
    return worst;
  }

  std::vector<Eigen::Vector3d> points_;
  std::vector<Pose2> truth_;
  Bundle bundle_;
};

TEST_F(BundleOfViews, FindsPosesAndPoints) {
  adjust(bundle_, 30);
  EXPECT_LT(worstError(), 0.01);
  double mean = 0.0;
  for (const auto& observation : bundle_.observations)
    mean += chi2Of(bundle_, observation) / static_cast<double>(bundle_.observations.size());
  EXPECT_NEAR(mean, 2.0 * (1.0 - (3.0 * 80 + 15) / (2.0 * 480)), 0.3);
}

TEST_F(BundleOfViews, HoldsOutAgainstFalseMatches) {
  for (std::size_t i = 0; i < bundle_.observations.size(); i += 20)
    bundle_.observations[i].seen.x() += 0.2;
  adjust(bundle_, 30);
  EXPECT_LT(worstError(), 0.02);
}

TEST_F(BundleOfViews, LeavesFixedViewsWhereTheyAre) {
  const auto before = bundle_.views[0].pose.vector();
  adjust(bundle_, 5);
  EXPECT_EQ(bundle_.views[0].pose.vector(), before);
}

TEST(Bundle, TakesAnEmptyOne) {
  Bundle bundle;
  adjust(bundle, 5);
  bundle.views.push_back({Pose2(), camera(), true});
  adjust(bundle, 5);
  EXPECT_EQ(bundle.views[0].pose.vector(), Eigen::Vector3d::Zero());
}

}  // namespace
}  // namespace slam::mono_graph
