// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/stamped_queue.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace slam {
namespace {

Stamp queued(double s) { return Stamp(durationFromSeconds(s)); }

class StampedQueueTest : public testing::Test {
 protected:
  void push(double stamp, std::uint64_t sequence) {
    queue.push(queued(stamp), sequence, static_cast<int>(sequence), counters);
  }
  std::vector<int> drain() {
    std::vector<int> values;
    while (!queue.items().empty()) values.push_back(queue.pop().value);
    return values;
  }

  StampedQueue<int> queue{4};
  Counters counters;
};

TEST_F(StampedQueueTest, KeepsTheOrderOfItsSource) {
  push(1, 0);
  push(2, 1);
  EXPECT_EQ(queue.stamps().last(), queued(2));
  EXPECT_EQ(drain(), (std::vector<int>{0, 1}));
  EXPECT_EQ(queue.stamps().last(), queued(2)) << "also when it is no longer held";
  EXPECT_TRUE(counters.all().empty());
}

TEST_F(StampedQueueTest, DropsAndCountsWhatIsNotNewer) {
  push(2, 0);
  push(2, 1);
  push(1, 2);
  EXPECT_EQ(counters["late"], 2u);
  EXPECT_EQ(drain(), (std::vector<int>{0}));
}

TEST_F(StampedQueueTest, CountsEveryMessageOfAGap) {
  push(1, 5);
  push(2, 6);
  push(3, 9);
  push(4, 10);
  EXPECT_EQ(counters["lost"], 2u) << "the first sequence may be any";
}

TEST_F(StampedQueueTest, DoesNotCountALateMessageAsLostToo) {
  push(2, 0);
  push(1, 1);
  push(3, 2);
  EXPECT_EQ(counters["late"], 1u);
  EXPECT_EQ(counters["lost"], 0u);
}

TEST_F(StampedQueueTest, DropsTheOldestWhenFull) {
  for (std::uint64_t i = 0; i < 6; ++i) push(double(i), i);
  EXPECT_EQ(counters["overflow"], 2u);
  EXPECT_EQ(drain(), (std::vector<int>{2, 3, 4, 5}));
}

TEST_F(StampedQueueTest, DropsTheOneThatWasStampedFarAhead) {
  push(1, 0);
  push(4000, 1);
  push(2, 2);
  push(3, 3);
  EXPECT_EQ(counters["stamp_jump"], 1u);
  EXPECT_EQ(counters["late"] + counters["lost"], 0u);
  EXPECT_EQ(queue.setAside(), 0u);
  EXPECT_EQ(drain(), (std::vector<int>{0, 2, 3}));
}

/// Both have jumped, so that the older one does not tell that the newer one is wrong.
TEST_F(StampedQueueTest, KeepsTheNewerOfTwoMessagesThatChangedPlacesBehindAPause) {
  push(1, 0);
  push(21, 2);
  push(20.9, 1);
  push(21.1, 3);
  EXPECT_EQ(drain(), (std::vector<int>{0, 2, 3}));
  EXPECT_EQ(counters["late"], 1u);
  EXPECT_EQ(counters["stamp_jump"], 0u);
}

TEST_F(StampedQueueTest, BelievesAJumpAheadThatLasts) {
  push(1, 0);
  push(4000, 1);
  push(4001, 2);
  push(2, 3);
  EXPECT_EQ(counters["stamp_jump"], 0u);
  EXPECT_GT(queue.setAside(), 0u);
  EXPECT_EQ(drain(), (std::vector<int>{0, 1, 2}));
}

TEST_F(StampedQueueTest, KeepsAsideWhatMayBeANewRun) {
  push(100, 7);
  push(95.1, 8);
  EXPECT_EQ(queue.setAside(), 0u) << "five seconds back is needed";
  push(95, 9);
  push(95.5, 10);
  EXPECT_GT(queue.setAside(), 0u);
  EXPECT_EQ(queue.items().size(), 1u);
  queue.restart();
  EXPECT_EQ(queue.setAside(), 0u);
  EXPECT_EQ(queue.stamps().last(), queued(95.5));
  push(96, 12);
  EXPECT_EQ(counters["lost"], 1u) << "the sequence goes on from the new run";
  EXPECT_EQ(drain(), (std::vector<int>{9, 10, 12}));
}

TEST_F(StampedQueueTest, CountsWhatWasAsideAsLateWhenTimeGoesOn) {
  push(100, 0);
  push(10, 1);
  push(11, 2);
  push(101, 3);
  EXPECT_EQ(counters["late"], 2u);
  EXPECT_EQ(queue.setAside(), 0u);
  EXPECT_EQ(drain(), (std::vector<int>{0, 3}));
}

TEST_F(StampedQueueTest, LeavesTheFutureOnceThreeInARowSaySo) {
  push(1, 0);
  push(101, 1);
  push(101.2, 2);
  push(1.6, 3);
  push(1.8, 4);
  EXPECT_EQ(queue.setAside(), 2u) << "two may still be the beginning of a new run";
  push(2, 5);
  EXPECT_EQ(queue.setAside(), 0u);
  EXPECT_EQ(counters["stamp_jump"], 2u);
  EXPECT_EQ(counters["late"] + counters["lost"], 0u);
  EXPECT_EQ(queue.stamps().last(), queued(2));
  EXPECT_EQ(drain(), (std::vector<int>{0, 3, 4, 5}));
}

TEST_F(StampedQueueTest, LeavesTheFutureThatItBeganIn) {
  push(101, 0);
  push(101.2, 1);
  for (std::uint64_t i = 2; i < 5; ++i) push(double(i), i);
  EXPECT_EQ(counters["stamp_jump"], 2u);
  EXPECT_EQ(drain(), (std::vector<int>{2, 3, 4}));
}

TEST_F(StampedQueueTest, LeavesTheFutureWhereItJumpedMoreThanOnce) {
  push(1, 0);
  push(101, 1);
  push(301, 2);
  for (std::uint64_t i = 3; i < 6; ++i) push(double(i), i);
  EXPECT_EQ(counters["stamp_jump"], 2u);
  EXPECT_EQ(drain(), (std::vector<int>{0, 3, 4, 5}));
}

TEST_F(StampedQueueTest, StaysInTheFutureWhereItsReceiverIsAsWell) {
  push(1, 0);
  push(101, 1);
  push(101.2, 2);
  queue.goneTo(queued(101));
  for (std::uint64_t i = 3; i < 7; ++i) push(double(i), i);
  EXPECT_EQ(queue.setAside(), 4u) << "only all sources together begin anew";
  EXPECT_EQ(counters["stamp_jump"], 0u);
}

TEST_F(StampedQueueTest, StaysInTheFutureWhenAllBeginsBeforeTheJump) {
  push(50, 0);
  push(101, 1);
  push(101.2, 2);
  for (std::uint64_t i = 3; i < 7; ++i) push(double(i), i);
  EXPECT_EQ(queue.setAside(), 4u) << "that is a new run";
}

TEST_F(StampedQueueTest, BelievesAJumpOnlyWhenASecondOfMessagesIsBehindIt) {
  push(1, 0);
  push(1.5, 1);
  EXPECT_EQ(queue.stamps().believed(), queued(1.5));
  push(101, 2);
  push(101.5, 3);
  EXPECT_EQ(queue.stamps().believed(), queued(1.5));
  push(102, 4);
  EXPECT_EQ(queue.stamps().believed(), queued(102));
}

TEST_F(StampedQueueTest, DoesNotDoubtASlowSource) {
  for (std::uint64_t i = 0; i < 4; ++i) push(10 * double(i), i);
  for (std::uint64_t i = 4; i < 9; ++i) {
    push(10 * double(i), i);
    EXPECT_EQ(queue.stamps().believed(), queued(10 * double(i)));
  }
}

TEST_F(StampedQueueTest, ASequenceThatBreaksOffIsARestartedSourceAndNoLoss) {
  push(1, 55);
  push(2, std::uint64_t(1) << 63);
  push(3, 57);
  push(4, 0);
  push(5, 59);
  push(6, 0);
  push(7, 1);
  EXPECT_EQ(counters["lost"], 0u);
  push(8, 4);
  EXPECT_EQ(counters["lost"], 2u) << "a restarted source's losses count again";
}

TEST_F(StampedQueueTest, CountsWhatWasLostBesideADamagedSequence) {
  push(1, 55);
  push(2, 0);
  push(3, 60);
  EXPECT_EQ(counters["lost"], 3u);
}

TEST_F(StampedQueueTest, ARestartedSourceIsNotTakenBackToItsOldNumbers) {
  push(1, 100);
  for (std::uint64_t i = 0; i < 20; ++i) push(2 + double(i), i);
  push(30, 130);
  EXPECT_EQ(counters["lost"], 110u);
}

}  // namespace
}  // namespace slam
