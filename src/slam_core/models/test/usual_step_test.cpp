// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/usual_step.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "slam_core/models/usual_interval.hpp"

namespace slam {
namespace {

UsualStep after(int count, const std::vector<Pose2>& steps) {
  UsualStep usual;
  for (int i = 0; i < count; ++i) usual.note(steps[static_cast<std::size_t>(i) % steps.size()]);
  return usual;
}

const Pose2 kMetre(1.0, 0.0, 0.0), kTurn(0.0, 0.0, 1.0), kMillimetre(0.001, 0.0, 0.0);

TEST(UsualStep, IsKnownAfterTwenty) {
  EXPECT_FALSE(after(19, {kMetre}).countOf(kMetre));
  ASSERT_TRUE(after(20, {kMetre}).countOf(kMetre));
  EXPECT_NEAR(*after(20, {kMetre}).countOf(kMetre), 1.0, 1e-9);
}

TEST(UsualStep, MayBeATurn) {
  const auto usual = after(30, {kTurn});
  EXPECT_TRUE(usual.countOf(kTurn));
  EXPECT_FALSE(usual.countOf(Pose2(0.0, 0.0, 0.2)));
}

TEST(UsualStep, IsNoneOfASourceThatReportsByTime) {
  EXPECT_FALSE(after(30, {kMillimetre}).countOf(kMillimetre)) << "steps are short";
  EXPECT_FALSE(after(30, {kMetre, Pose2(), Pose2()}).countOf(kMetre)) << "it reports standing";
  EXPECT_FALSE(after(30, {Pose2()}).countOf(Pose2()));
}

TEST(UsualStep, IsNeitherAPartOfOneNorMany) {
  const auto usual = after(30, {kMetre});
  EXPECT_FALSE(usual.countOf(Pose2()));
  EXPECT_FALSE(usual.countOf(Pose2(0.4, 0.0, 0.0)));
  EXPECT_FALSE(usual.countOf(Pose2(3.1, 0.0, 0.0)));
  ASSERT_TRUE(usual.countOf(Pose2(2.2, 0.0, 0.0))) << "one message was left out";
  EXPECT_NEAR(*usual.countOf(Pose2(2.2, 0.0, 0.0)), 2.2, 1e-9);
}

constexpr Duration kSecond = std::chrono::seconds(1);

TEST(UsualInterval, IsTwiceAsLongAtMostAfterASilence) {
  UsualInterval usual;
  for (int i = 0; i < 20; ++i) usual.note(kSecond);
  usual.note(1000 * kSecond);
  EXPECT_LE(usual.value(), 2 * kSecond);
  EXPECT_FALSE(usual.isOfBurst(kSecond));
  EXPECT_TRUE(usual.isExceededBy(10 * kSecond, kSecond));
}

TEST(UsualInterval, FollowsASourceThatIsSlowerFromNowOn) {
  UsualInterval usual;
  usual.note(std::chrono::microseconds(1));
  for (int i = 0; i < 60; ++i) usual.note(kSecond);
  EXPECT_FALSE(usual.isExceededBy(2 * kSecond, Duration()));
}

}  // namespace
}  // namespace slam
