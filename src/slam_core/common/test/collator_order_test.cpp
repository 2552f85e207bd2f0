// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "slam_core/common/random.hpp"
#include "slam_core/common/test/line_motion.hpp"

namespace slam {
namespace {

using test::at;
using test::LineCollator;
using test::LineRun;

using Message = std::function<void(LineRun&)>;
using Source = std::vector<Message>;

std::size_t drawBelow(RandomStream& random, std::size_t n) {
  return static_cast<std::size_t>(random.uniform() * double(n));
}

/// Wheel motion of uneven intervals with a gap, some of it late.
Source motionSource(RandomStream random) {
  Source source;
  double time = 1.0;
  for (std::uint64_t i = 0; i < 120; ++i) {
    const double end = time + 0.01 + 0.05 * random.uniform();
    if (i != 60) source.push_back([=](LineRun& run) { run.move(time, end, i); });
    if (i % 40 == 7) source.push_back([=](LineRun& run) { run.move(time - 0.3, time, i); });
    time = end;
  }
  return source;
}

/// Triggers that begin before the motion, some late, some on the stamps of the other source.
Source triggerSource(RandomStream random, std::size_t index) {
  Source source;
  double time = 0.5;
  for (std::uint64_t i = 0; i < 60; ++i) {
    time = i % 10 == 0 ? std::floor(time) + 1.0 : time + 0.1 * random.uniform();
    const auto name = std::string(1, char('a' + index)) + std::to_string(i);
    source.push_back([=](LineRun& run) { run.see(name, time, i, index); });
    if (i % 17 == 3) source.push_back([=](LineRun& run) { run.see("late", time - 0.2, i, index); });
  }
  return source;
}

/// Delivers the sources' messages, each source in its order, the sources mixed at random.
LineRun deliver(const std::vector<Source>& sources, RandomStream random) {
  LineCollator::Limits limits;
  limits.source_timeout = std::chrono::hours(1);
  LineRun run(sources.size() - 1, limits);
  std::vector<std::size_t> next(sources.size(), 0);
  std::size_t left = 0;
  for (const auto& source : sources) left += source.size();
  std::size_t speaker = 0;
  while (left > 0) {
    if (random.uniform() < 0.3) speaker = drawBelow(random, sources.size());  // bursts
    if (next[speaker] == sources[speaker].size()) {
      speaker = (speaker + 1) % sources.size();
      continue;
    }
    sources[speaker][next[speaker]++](run);
    --left;
  }
  return run;
}

class CollatorOrder : public testing::TestWithParam<std::size_t> {};

TEST_P(CollatorOrder, GivesTheSameStepsWhateverTheOrderOfArrival) {
  std::vector<Source> sources = {motionSource(RandomStream(1, 0))};
  for (std::size_t i = 0; i < GetParam(); ++i)
    sources.push_back(triggerSource(RandomStream(1, i + 1), i));
  const auto first = deliver(sources, RandomStream(2, 0));
  ASSERT_GT(first.steps.size(), 30u);
  EXPECT_GT(first.collator.counters()["late"], 0u);
  EXPECT_EQ(first.collator.counters()["lost"], 1u);
  for (std::uint64_t shuffle = 1; shuffle < 200; ++shuffle) {
    const auto other = deliver(sources, RandomStream(2, shuffle));
    ASSERT_EQ(other.transcript(), first.transcript()) << "shuffle " << shuffle;
    ASSERT_EQ(other.collator.counters().all(), first.collator.counters().all());
  }
}

INSTANTIATE_TEST_SUITE_P(TriggerSources, CollatorOrder, testing::Values(1u, 2u, 3u));

TEST(CollatorRestart, BeginsAnewOnceWhenAllSourcesGoBack) {
  LineRun run;
  run.move(100, 101, 0);
  run.see("a", 100.5, 0);
  run.see("x", 150, 1);  // its motion never came: it belongs to the old run
  run.see("b", 10.5, 2);
  run.see("c", 11.5, 3);
  EXPECT_EQ(run.seen(), "a") << "one source alone does not restart the run";
  run.move(10, 11, 1);
  run.move(11, 12, 2);
  EXPECT_EQ(run.seen(), "abc") << "messages of the new run are kept";
  EXPECT_EQ(run.collator.counters()["restart"], 1u);
  EXPECT_FALSE(run.steps[0].restart);
  EXPECT_TRUE(run.steps[1].restart);
  EXPECT_FALSE(run.steps[2].restart);
  EXPECT_DOUBLE_EQ(run.wayOf(1), 0.5);
  EXPECT_EQ(run.collator.counters()["late"], 0u);
  EXPECT_EQ(run.collator.counters()["abandoned"], 1u) << "x";
}

TEST(CollatorRestart, DoesNotNeedASourceThatIsSilent) {
  LineRun run(2);
  run.move(100, 102, 0);
  run.see("a", 100.5, 0, 0);
  EXPECT_EQ(run.seen(), "a");
  run.see("b", 10.5, 1, 0);
  run.move(10, 12, 1);
  EXPECT_EQ(run.seen(), "ab");
  EXPECT_EQ(run.collator.counters()["restart"], 1u);
}

TEST(CollatorRestart, DropsAsLateWhatOnlyOneSourceSentFromThePast) {
  LineRun run;
  run.move(100, 101, 0);
  run.see("a", 100.5, 0);
  run.see("old", 10, 1);
  run.see("old", 11, 2);
  run.move(101, 102, 1);
  run.see("b", 101.5, 3);
  EXPECT_EQ(run.seen(), "ab");
  EXPECT_EQ(run.collator.counters()["late"], 2u);
  EXPECT_EQ(run.collator.counters()["restart"], 0u);
}

TEST(CollatorRestart, CountsTriggersBeforeTheMotionOfTheNewRunAsBeforeItsStart) {
  LineRun run;
  run.move(100, 101, 0);
  run.see("a", 100.5, 0);
  run.see("early", 9, 1);
  run.see("b", 10.5, 2);
  run.move(10, 11, 1);
  EXPECT_EQ(run.seen(), "ab");
  EXPECT_EQ(run.collator.counters()["before_start"], 1u);
  EXPECT_EQ(run.collator.counters()["late"], 0u);
}

/// A run of 4 s whose sources are stamped 100 s ahead where told.
LineRun runWithWrongStamps(bool wrong_motion, bool wrong_triggers) {
  LineRun run;
  double end = 0.0;
  for (int i = 1; i <= 40; ++i) {
    const double now = 0.1 * i;
    const bool is_wrong = i >= 10 && i < 13;
    const double stamp = is_wrong && wrong_motion ? now + 100 : now;
    run.move(end, stamp, std::uint64_t(i));
    end = is_wrong && !wrong_motion ? now : stamp;
    if (i == 12) end = 1.2;
    run.see("a", is_wrong && wrong_triggers ? now + 100.01 : now - 0.01, std::uint64_t(i));
  }
  return run;
}

TEST(CollatorFuture, IsLeftByASourceWhoseTriggersWereStampedAhead) {
  const auto run = runWithWrongStamps(false, true);
  EXPECT_EQ(run.steps.size(), 37u) << "three are lost";
  EXPECT_EQ(run.steps.back().stamp, at(3.99));
  EXPECT_EQ(run.collator.counters()["stamp_jump"], 3u);
  EXPECT_EQ(run.collator.setAside(), 0u);
}

TEST(CollatorFuture, IsLeftByMotionAndNothingStepsByWhatWasStampedAhead) {
  const auto run = runWithWrongStamps(true, false);
  EXPECT_EQ(run.steps.size(), 40u);
  double way = 0.0;
  for (std::size_t i = 0; i < run.steps.size(); ++i) way += run.wayOf(i);
  EXPECT_NEAR(way, 3.99 - 0.3, 1e-9) << "only the three wrong ones may be missing";
  EXPECT_EQ(run.collator.counters()["stamp_jump"], 3u);
  EXPECT_EQ(run.collator.counters()["restart"], 0u);
}

TEST(CollatorFuture, IsLeftWhereBothWereStampedAhead) {
  const auto run = runWithWrongStamps(true, true);
  EXPECT_EQ(run.steps.size(), 37u);
  EXPECT_EQ(run.collator.counters()["restart"], 0u);
}

TEST(CollatorFuture, TellsWhatIsStillSetAside) {
  LineRun run;
  run.move(0, 1, 0);
  run.move(1, 200, 1);
  run.move(200, 201, 2);
  run.move(201, 202, 3);
  run.see("a", 150, 0);
  EXPECT_EQ(run.seen(), "a");
  for (std::uint64_t i = 1; i < 6; ++i) run.see("b", double(i), i);
  EXPECT_EQ(run.collator.setAside(), 5u) << "motion has passed them; they may begin a new run";
}

}  // namespace
}  // namespace slam
