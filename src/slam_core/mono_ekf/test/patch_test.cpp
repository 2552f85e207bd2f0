// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/patch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "slam_core/common/random.hpp"
#include "slam_core/mono_ekf/corner_finder.hpp"

namespace slam::mono_ekf {
namespace {

/// Smooth blots at random, so that it can be sampled between pixels.
cv::Mat blots(std::uint64_t seed) {
  cv::Mat gray(200, 200, CV_8U, cv::Scalar(120));
  RandomStream random(seed, 0);
  for (int i = 0; i < 120; ++i) {
    const cv::Point at(static_cast<int>(200 * random.uniform()),
                       static_cast<int>(200 * random.uniform()));
    cv::circle(gray, at, 3 + static_cast<int>(9 * random.uniform()), 255.0 * random.uniform(),
               cv::FILLED);
  }
  cv::GaussianBlur(gray, gray, {7, 7}, 1.5);
  return gray;
}

cv::Mat warped(const cv::Mat& gray, double scale, const Eigen::Vector2d& shift) {
  const cv::Matx23d A(scale, 0, (1 - scale) * 100 + shift.x(), 0, scale,
                      (1 - scale) * 100 + shift.y());
  cv::Mat result;
  cv::warpAffine(gray, result, A, gray.size(), cv::INTER_CUBIC);
  return result;
}

FirstSight firstSightOf(const cv::Mat& gray) {
  FirstSight first;
  first.patch = Patch::cut(gray, {100.0, 100.0});
  return first;
}

const Eigen::Matrix2d kWide = 25.0 * Eigen::Matrix2d::Identity();

TEST(PatchSearch, FindsThePatchToAPartOfAPixel) {
  const auto gray = blots(1);
  const auto patch = Patch::seen(firstSightOf(gray), Eigen::Matrix2d::Identity(), 1.0);
  ASSERT_TRUE(patch);
  for (const Eigen::Vector2d& shift :
       {Eigen::Vector2d(3.0, -2.0), Eigen::Vector2d(-4.3, 2.6), Eigen::Vector2d(0.5, 0.25)}) {
    const auto found = patch->find(warped(gray, 1.0, shift), {100.0, 100.0}, kWide, 9.21);
    ASSERT_TRUE(found);
    EXPECT_LT((found->pixel - shift - Eigen::Vector2d(100, 100)).norm(), 0.1);
    EXPECT_GT(found->correlation, 0.9);
  }
}

TEST(PatchSearch, FindsItLargerAndSmaller) {
  const auto gray = blots(1);
  const auto first = firstSightOf(gray);
  for (const double scale : {0.7, 1.4}) {
    const auto patch = Patch::seen(first, scale * Eigen::Matrix2d::Identity(), 1.0);
    ASSERT_TRUE(patch);
    const auto found = patch->find(warped(gray, scale, {2.2, 1.4}), {100.0, 100.0}, kWide, 9.21);
    ASSERT_TRUE(found);
    EXPECT_LT((found->pixel - Eigen::Vector2d(102.2, 101.4)).norm(), 0.2) << scale;
  }
}

TEST(PatchSearch, DoesNotMindTheLight) {
  const auto gray = blots(3);
  const auto patch = Patch::seen(firstSightOf(gray), Eigen::Matrix2d::Identity(), 1.0);
  cv::Mat dim;
  gray.convertTo(dim, CV_8U, 0.4, 10.0);
  const auto found = patch->find(dim, {102.0, 99.0}, kWide, 9.21);
  ASSERT_TRUE(found);
  EXPECT_LT((found->pixel - Eigen::Vector2d(100, 100)).norm(), 0.2);
}

TEST(PatchSearch, LooksOnlyWithinTheEllipse) {
  const auto gray = blots(4);
  const auto patch = Patch::seen(firstSightOf(gray), Eigen::Matrix2d::Identity(), 1.0);
  const auto found = patch->find(gray, {120.0, 100.0}, Eigen::Matrix2d::Identity(), 9.21);
  EXPECT_TRUE(!found || (found->pixel - Eigen::Vector2d(120, 100)).norm() < 5.0);
}

TEST(PatchSearch, TakesAPatchAtTheEdgeOfTheImageForNoneAtAll) {
  EXPECT_TRUE(Patch::cut(blots(5), {10.0, 100.0}).empty());
  EXPECT_TRUE(Patch::cut(blots(5), {100.0, 190.0}).empty());
  const auto patch = Patch::seen(firstSightOf(blots(5)), Eigen::Matrix2d::Identity(), 1.0);
  EXPECT_FALSE(patch->find(blots(5), {-50.0, 100.0}, kWide, 9.21)) << "out of the image";
}

TEST(PatchSearch, RefusesWhatIsSeenTooDifferently) {
  const auto first = firstSightOf(blots(6));
  EXPECT_FALSE(Patch::seen(first, 0.3 * Eigen::Matrix2d::Identity(), 1.0)) << "far away";
  EXPECT_FALSE(Patch::seen(first, Eigen::Vector2d(1.0, 0.2).asDiagonal(), 1.0)) << "oblique";
  EXPECT_FALSE(Patch::seen(first, Eigen::Matrix2d::Zero(), 1.0)) << "edge on";
}

TEST(PatchSearch, RefusesEdgesAndBareWalls) {
  cv::Mat edge(200, 200, CV_8U, cv::Scalar(60));
  edge.rowRange(100, 200).setTo(200);
  EXPECT_FALSE(Patch::seen(firstSightOf(edge), Eigen::Matrix2d::Identity(), 1.0));
  const cv::Mat bare(200, 200, CV_8U, cv::Scalar(128));
  EXPECT_FALSE(Patch::seen(firstSightOf(bare), Eigen::Matrix2d::Identity(), 1.0));
}

TEST(CornerFinder, FindsTheCornersOfASquareAndNoneInNoise) {
  cv::Mat square(200, 200, CV_8U, cv::Scalar(60));
  cv::rectangle(square, {60, 70, 60, 60}, 200, cv::FILLED);
  const auto corners = cornersOf(square, {}, 3.0, 20, 19);
  ASSERT_GE(corners.size(), 4U);
  for (const Eigen::Vector2d& expected : {Eigen::Vector2d(60, 70), Eigen::Vector2d(119, 70),
                                          Eigen::Vector2d(60, 129), Eigen::Vector2d(119, 129)}) {
    double nearest = 1e9;
    for (const auto& corner : corners) nearest = std::min(nearest, (corner - expected).norm());
    EXPECT_LT(nearest, 4.0);
  }
  cv::Mat noise(200, 200, CV_8U);
  cv::RNG(7).fill(noise, cv::RNG::NORMAL, 120.0, 3.0);
  EXPECT_TRUE(cornersOf(noise, {}, 3.0, 20, 19).empty());
}

TEST(CornerFinder, KeepsAwayFromWhatIsThere) {
  const auto gray = blots(8);
  const auto all = cornersOf(gray, {}, 3.0, 20, 19);
  ASSERT_FALSE(all.empty());
  for (const auto& corner : cornersOf(gray, {all.front()}, 3.0, 20, 19))
    EXPECT_GE((corner - all.front()).norm(), 20.0);
}

}  // namespace
}  // namespace slam::mono_ekf
