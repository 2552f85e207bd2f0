// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "slam_core/common/test/line_motion.hpp"

namespace slam {
namespace {

using test::at;
using test::LineCollator;
using test::LineRun;

LineRun runWithoutMotion(std::size_t sources = 1, std::size_t capacity = 2000) {
  LineCollator::Limits limits;
  limits.has_motion = false;
  limits.triggers = capacity;
  return LineRun(sources, limits);
}

TEST(CollatorWithoutMotion, StepsAtOnceWhereThereIsOneSource) {
  auto run = runWithoutMotion();
  run.see("a", 1, 0);
  EXPECT_EQ(run.seen(), "a") << "the first one, too";
  run.see("b", 1.5, 1);
  EXPECT_EQ(run.seen(), "ab");
  EXPECT_EQ(run.steps[1].stamp, at(1.5));
  EXPECT_TRUE(run.steps[1].motions.empty());
  EXPECT_EQ(run.collator.triggers(0).items().size(), 0u);
  EXPECT_EQ(run.collator.pending(), nullptr);
  EXPECT_TRUE(run.collator.counters().all().empty());
}

TEST(CollatorWithoutMotion, IgnoresMotion) {
  auto run = runWithoutMotion();
  run.move(0, 10, 0);
  run.see("a", 1, 0);
  ASSERT_EQ(run.steps.size(), 1u);
  EXPECT_TRUE(run.steps[0].motions.empty());
  EXPECT_FALSE(run.collator.lastMotion());
}

TEST(CollatorWithoutMotion, WaitsUntilTheOtherSourceHasPassed) {
  auto run = runWithoutMotion(2);
  run.see("b", 0.25, 0, 1);
  EXPECT_EQ(run.seen(), "");
  run.see("a", 0.30, 0, 0);
  EXPECT_EQ(run.seen(), "b");
  run.see("B", 0.30, 1, 1);
  EXPECT_EQ(run.seen(), "baB") << "equal stamps in the order of the sources";
}

TEST(CollatorWithoutMotion, GivesTheSameStepsWhateverTheOrderOfArrival) {
  std::string expected;
  for (unsigned order = 0; order < 1u << 10; ++order) {
    auto run = runWithoutMotion(2);
    std::uint64_t next[] = {0, 0};
    for (unsigned i = 0; i < 10; ++i) {
      auto source = order >> i & 1u;
      if (next[source] == 5) source = 1 - source;
      const auto number = next[source]++;
      run.see((source == 0 ? "a" : "b") + std::to_string(number),
              0.1 * double(number) * (source == 0 ? 1.0 : 1.5), number, source);
    }
    // up to where the slower source ends; the rest waits for it
    const auto steps = run.seen();
    if (order == 0) expected = steps;
    ASSERT_EQ(steps, expected) << order;
  }
  EXPECT_EQ(expected, "a0b0a1b1a2a3b2a4");
}

TEST(CollatorWithoutMotion, ASourceThatIsSilentHoldsNobodyBack) {
  auto run = runWithoutMotion(2);
  run.see("a", 0.5, 0, 0);
  run.see("b", 1.4, 1, 0);
  EXPECT_EQ(run.seen(), "");
  run.see("c", 1.5, 2, 0);
  EXPECT_EQ(run.seen(), "abc") << "a second of the other's stamps";
  EXPECT_EQ(run.collator.counters()["source_timeout"], 1u);
  run.see("late", 1.0, 0, 1);
  EXPECT_EQ(run.seen(), "abc");
  EXPECT_EQ(run.collator.counters()["late"], 1u);
  run.see("d", 1.7, 3, 0);
  EXPECT_EQ(run.seen(), "abc") << "and it is waited for again";
  run.see("e", 1.8, 1, 1);
  EXPECT_EQ(run.seen(), "abcd");
}

TEST(CollatorWithoutMotion, DoesNotWaitForASourceThatNothingIsExpectedOf) {
  auto run = runWithoutMotion(2);
  run.collator.expectNothing(0);
  run.see("a", 0.3, 0, 1);
  EXPECT_EQ(run.seen(), "a");
  EXPECT_EQ(run.collator.counters()["source_timeout"], 0u);
}

TEST(CollatorWithoutMotion, CountsLateAndLost) {
  auto run = runWithoutMotion();
  run.see("a", 1, 0);
  run.see("b", 1, 1);
  run.see("c", 0.5, 2);
  run.see("d", 1.2, 5);
  EXPECT_EQ(run.seen(), "ad");
  EXPECT_EQ(run.collator.counters()["late"], 2u);
  EXPECT_EQ(run.collator.counters()["lost"], 2u);
  EXPECT_EQ(run.collator.counters()["before_start"], 0u);
}

TEST(CollatorWithoutMotion, DoesNotStepByStampsThatJumpAhead) {
  auto run = runWithoutMotion();
  run.see("a", 1, 0);
  run.see("X", 101, 1);
  EXPECT_EQ(run.seen(), "a");
  run.see("b", 1.2, 2);
  EXPECT_EQ(run.seen(), "ab") << "one of them is dropped at once";
  run.see("X", 101, 3);
  run.see("X", 101.2, 4);
  for (std::uint64_t i = 0; i < 3; ++i) run.see("c", 1.8 + 0.2 * double(i), 5 + i);
  EXPECT_EQ(run.seen(), "abccc") << "several once three in a row say so";
  EXPECT_EQ(run.collator.counters()["stamp_jump"], 3u);
}

TEST(CollatorWithoutMotion, BelievesAJumpAheadThatLasts) {
  auto run = runWithoutMotion();
  run.see("a", 1, 0);
  for (std::uint64_t i = 0; i < 6; ++i) run.see("b", 101 + 0.2 * double(i), 1 + i);
  EXPECT_EQ(run.seen(), "abbbbbb");
}

TEST(CollatorWithoutMotion, BeginsAnewWhenAllSourcesGoBack) {
  auto run = runWithoutMotion(2);
  run.see("a", 100, 0, 0);
  run.see("b", 100.1, 0, 1);
  run.see("c", 10, 1, 0);
  run.see("d", 10.2, 2, 0);
  run.see("e", 10.4, 3, 0);
  EXPECT_EQ(run.seen(), "a") << "source 1 has not gone back";
  run.see("f", 10.1, 1, 1);
  EXPECT_EQ(run.seen(), "acf") << "and what waited of the old run is gone with it";
  ASSERT_EQ(run.steps.size(), 3u);
  EXPECT_TRUE(run.steps[1].restart);
  EXPECT_FALSE(run.steps[2].restart);
  EXPECT_EQ(run.collator.counters()["restart"], 1u);
}

TEST(CollatorWithoutMotion, OneTriggerFromThePastBeginsNoRun) {
  auto run = runWithoutMotion();
  run.see("a", 100, 0);
  run.see("old", 10, 1);
  run.see("b", 100.2, 2);
  EXPECT_EQ(run.seen(), "ab");
  EXPECT_EQ(run.collator.counters()["late"], 1u);
  EXPECT_EQ(run.collator.counters()["restart"], 0u);
}

TEST(CollatorWithoutMotion, BoundsAndCountsWhatWaitsForTheOtherSource) {
  auto run = runWithoutMotion(2, 3);
  for (std::uint64_t i = 0; i < 5; ++i) run.see(std::to_string(i), 0.1 * double(i), i, 0);
  run.see("x", 0.9, 0, 1);
  EXPECT_EQ(run.seen(), "234");
  EXPECT_EQ(run.collator.counters()["overflow"], 2u);
}

}  // namespace
}  // namespace slam
