// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/collator.hpp"

#include <gtest/gtest.h>

#include "slam_core/common/test/line_motion.hpp"

namespace slam {
namespace {

using test::at;
using test::LineCollator;
using test::LineRun;

TEST(Collator, WaitsUntilMotionCoversTheStamp) {
  LineRun run;
  run.move(0, 1, 0);
  run.see("a", 1.5, 0);
  EXPECT_TRUE(run.steps.empty());
  run.move(1, 2, 1);
  ASSERT_EQ(run.steps.size(), 1u);
  EXPECT_EQ(run.steps[0].stamp, at(1.5));
  EXPECT_EQ(run.steps[0].trigger, "a");
  EXPECT_FALSE(run.steps[0].restart);
}

TEST(Collator, TellsSinceWhenTriggersWaitForMotionThatDoesNotGoOn) {
  const auto patience = std::chrono::seconds(3);
  LineRun run;
  run.see("a", 9, 0);
  EXPECT_FALSE(run.collator.starvedSince(0, patience)) << "motion has never come";
  run.move(0, 1, 0);
  EXPECT_EQ(run.collator.starvedSince(0, patience), at(9));
  run.move(1, 10, 1);
  EXPECT_EQ(run.steps.size(), 1u);
  EXPECT_EQ(run.collator.triggers(0).items().size(), 0u);
  run.see("b", 11, 1);
  run.see("c", 13, 2);
  EXPECT_FALSE(run.collator.starvedSince(0, patience)) << "it may still come";
  run.see("d", 13.5, 3);
  EXPECT_EQ(run.collator.starvedSince(0, patience), at(11));
  EXPECT_EQ(run.collator.triggers(0).items().size(), 3u);
  run.move(10, 12, 2);
  EXPECT_FALSE(run.collator.starvedSince(0, patience)) << "it goes on";
}

TEST(Collator, SplitsTheMotionThatSpansTheStamp) {
  LineRun run;
  run.move(0, 2, 0);
  run.see("a", 0.5, 0);
  run.see("b", 0.75, 1);
  run.see("c", 2, 2);
  ASSERT_EQ(run.steps.size(), 3u);
  EXPECT_DOUBLE_EQ(run.wayOf(0), 0.5);
  EXPECT_DOUBLE_EQ(run.wayOf(1), 0.25);
  EXPECT_DOUBLE_EQ(run.wayOf(2), 1.25);
  EXPECT_EQ(run.steps[1].motions[0].start, at(0.5));
  EXPECT_EQ(run.steps[1].motions[0].end, at(0.75));
}

TEST(Collator, TakesMotionOfAnEqualStampBeforeTheTrigger) {
  LineRun run;
  run.see("a", 1, 0);
  run.move(0, 1, 0);
  ASSERT_EQ(run.steps.size(), 1u);
  EXPECT_DOUBLE_EQ(run.wayOf(0), 1.0);
}

TEST(Collator, TakesTriggersOfAnEqualStampInTheOrderOfTheirSources) {
  LineRun run(2);
  run.see("b", 1, 0, 1);
  run.move(0, 1.5, 0);
  EXPECT_TRUE(run.steps.empty()) << "source 0 may still send something older";
  run.see("a", 1, 0, 0);
  EXPECT_EQ(run.seen(), "ab");
  EXPECT_DOUBLE_EQ(run.wayOf(1), 0.0);
}

TEST(Collator, StepsAtTheVeryStartOfMotion) {
  LineRun run;
  run.see("a", 0, 0);
  run.move(0, 1, 0);
  ASSERT_EQ(run.steps.size(), 1u);
  EXPECT_TRUE(run.steps[0].motions.empty());
  ASSERT_NE(run.collator.pending(), nullptr);
  EXPECT_EQ(run.collator.pending()->start, at(0));
}

TEST(Collator, CountsTriggersFromBeforeTheFirstMotion) {
  LineRun run;
  run.see("a", 0.5, 0);
  run.see("b", 0.9, 1);
  run.see("c", 1.5, 2);
  run.move(1, 2, 0);
  EXPECT_EQ(run.seen(), "c");
  EXPECT_EQ(run.collator.counters()["before_start"], 2u);
  EXPECT_EQ(run.collator.counters()["late"], 0u);
}

TEST(Collator, CountsLateAndLostOfEverySource) {
  LineRun run;
  run.move(0, 1, 0);
  run.move(0, 1, 1);
  run.move(2, 3, 3);
  run.see("a", 2.5, 0);
  run.see("b", 2.5, 1);
  run.see("c", 2.6, 5);
  EXPECT_EQ(run.seen(), "ac");
  EXPECT_EQ(run.collator.counters()["late"], 2u);
  EXPECT_EQ(run.collator.counters()["lost"], 4u);
}

TEST(Collator, NeverAppliesTheSameTimeTwice) {
  LineRun run;
  run.move(0, 1, 0);
  run.see("a", 1, 0);
  run.move(0.5, 1.5, 1);  // overlaps what was handed out
  run.see("b", 1.5, 1);
  ASSERT_EQ(run.steps.size(), 2u);
  EXPECT_DOUBLE_EQ(run.wayOf(1), 0.5);
}

TEST(Collator, LeavesTheEndUnsteppedWhenItsMotionNeverComes) {
  LineRun run;
  run.move(0, 1, 0);
  run.see("a", 1.0001, 0);
  EXPECT_TRUE(run.steps.empty());
}

TEST(Collator, LetsTwoTriggerSourcesWaitForEachOther) {
  LineRun run(2);
  for (std::uint64_t i = 0; i < 5; ++i) run.move(0.1 * double(i), 0.1 * double(i + 1), i);
  run.see("a", 0.30, 0, 0);
  EXPECT_EQ(run.seen(), "");
  run.see("b", 0.25, 0, 1);
  EXPECT_EQ(run.seen(), "b") << "source 1 has not passed 0.30 yet";
  run.see("B", 0.35, 1, 1);
  EXPECT_EQ(run.seen(), "ba");
}

TEST(Collator, WaitsNoLongerForASourceThatIsSilent) {
  LineRun run(2);
  run.move(0, 1, 0);
  run.see("a", 0.5, 0, 0);
  run.move(1, 1.4, 1);
  EXPECT_EQ(run.seen(), "");
  run.move(1.4, 1.6, 2);  // source 1 is a second behind
  EXPECT_EQ(run.seen(), "a");
  EXPECT_EQ(run.collator.counters()["source_timeout"], 1u);
  run.see("b", 0.4, 0, 1);
  EXPECT_EQ(run.seen(), "a");
  EXPECT_EQ(run.collator.counters()["late"], 1u) << "what it sends after all is dropped";
  run.see("c", 1.5, 1, 1);
  run.see("d", 1.6, 1, 0);
  EXPECT_EQ(run.seen(), "ac") << "and it is waited for again";
}

TEST(Collator, ASilentSourceDelaysTheOthersOnce) {
  LineRun run(2);
  for (std::uint64_t i = 0; i < 15; ++i) run.move(0.1 * double(i), 0.1 * double(i + 1), i);
  run.see("a", 0.3, 0, 1);
  run.see("b", 1.45, 1, 1);
  EXPECT_EQ(run.seen(), "ab") << "source 0 has been silent for a second: nobody waits for it";
  EXPECT_EQ(run.collator.counters()["source_timeout"], 1u);
}

TEST(Collator, DoesNotWaitForASourceThatNothingIsExpectedOf) {
  LineRun run(2);
  run.collator.expectNothing(0);
  run.move(0, 1, 0);
  run.see("a", 0.3, 0, 1);
  EXPECT_EQ(run.seen(), "a");
  run.see("b", 0.4, 0, 0);
  run.see("c", 0.6, 1, 1);
  EXPECT_EQ(run.seen(), "ab") << "what it sends after all counts, and is waited for from then on";
  EXPECT_EQ(run.collator.counters()["source_timeout"], 0u);
}

TEST(Collator, TakesEqualStampsInTheOrderOfTheSources) {
  LineRun run(2);
  run.move(0, 1, 0);
  run.see("scan", 0.5, 0, 1);
  EXPECT_EQ(run.seen(), "");
  run.see("array ", 0.5, 0, 0);
  EXPECT_EQ(run.seen(), "array scan");
  EXPECT_TRUE(run.steps.at(1).motions.empty());
}

TEST(Collator, CarriesMotionOnWhenNothingIsSeen) {
  LineCollator::Limits limits;
  limits.motions = 10;
  LineRun run(1, limits);
  for (std::uint64_t i = 0; i < 100; ++i) run.move(double(i), double(i + 1), i);
  run.see("a", 100, 0);
  double way = 0.0;
  for (std::size_t i = 0; i < run.steps.size(); ++i) way += run.wayOf(i);
  EXPECT_DOUBLE_EQ(way, 100.0) << "no motion may be lost";
  ASSERT_GT(run.steps.size(), 2u);
  EXPECT_FALSE(run.steps.front().trigger.has_value());
  EXPECT_EQ(run.steps.back().trigger, "a");
  EXPECT_EQ(run.collator.counters()["overflow"], 0u);
}

TEST(Collator, BoundsAndCountsTriggersWhoseMotionDoesNotCome) {
  LineCollator::Limits limits;
  limits.triggers = 3;
  LineRun run(1, limits);
  for (std::uint64_t i = 0; i < 5; ++i) run.see(std::to_string(i), 0.1 * double(i), i);
  run.move(0, 1, 0);
  EXPECT_EQ(run.seen(), "234");
  EXPECT_EQ(run.collator.counters()["overflow"], 2u);
}

}  // namespace
}  // namespace slam
