// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/view_change.hpp"

#include <gtest/gtest.h>

#include "slam_core/common/archive_reader.hpp"
#include "slam_core/common/archive_writer.hpp"

namespace slam::relocalisation {
namespace {

/// Makes a view of `count` landmarks, whose ids begin with `first`, and of other observations.
View viewOf(int first, int count, std::size_t others) {
  View view;
  for (int id = first; id < first + count; ++id) view.known.insert(id);
  view.others = others;
  return view;
}

/// Lets a robot that stands see the same view several times. @return the sum of the evidence
double evidenceOf(ViewChange& change, const View& view, int views) {
  double sum = 0.0;
  for (int i = 0; i < views; ++i) sum += change.judge(view, Pose2(), true);
  return sum;
}

TEST(ViewChange, IsEvidentSoonAfterTheStart) {
  ViewChange change;
  EXPECT_EQ(evidenceOf(change, viewOf(1, 8, 0), 3), 0.0);
  EXPECT_GT(evidenceOf(change, viewOf(1, 0, 8), 3), 10.0);
}

TEST(ViewChange, CountsOnce) {
  ViewChange change;
  evidenceOf(change, viewOf(1, 8, 0), 100);
  EXPECT_GT(evidenceOf(change, viewOf(1, 0, 8), 3), 15.0);
  EXPECT_EQ(evidenceOf(change, viewOf(1, 0, 8), 100), 0.0);
}

TEST(ViewChange, IsNotLearntAsUsual) {
  ViewChange change;
  evidenceOf(change, viewOf(1, 8, 0), 5);
  const double first = evidenceOf(change, viewOf(1, 0, 8), 3);
  change.forgetBefore();
  evidenceOf(change, viewOf(1, 8, 0), 1);
  EXPECT_EQ(evidenceOf(change, viewOf(1, 0, 8), 3), first);
}

TEST(ViewChange, ThatPassesIsLearntAndNoSign) {
  ViewChange change;
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(evidenceOf(change, viewOf(1, 8, 0), 1), 0.0);
    EXPECT_EQ(evidenceOf(change, viewOf(1, 0, 8), 2), 0.0);
  }
  EXPECT_LT(evidenceOf(change, viewOf(1, 8, 0), 1) + evidenceOf(change, viewOf(1, 0, 8), 3), 8.0);
}

TEST(ViewChange, IsNotJudgedWhereFewLandmarksWereSeenOrTheRobotHasMoved) {
  ViewChange change;
  evidenceOf(change, viewOf(1, 3, 0), 10);
  EXPECT_EQ(evidenceOf(change, viewOf(1, 0, 8), 3), 0.0);
  evidenceOf(change, viewOf(1, 8, 0), 10);
  for (int i = 1; i <= 3; ++i)
    EXPECT_EQ(change.judge(viewOf(1, 0, 8), Pose2(0.4 * i, 0.0, 0.0), true), 0.0);
}

TEST(ViewChange, NeedsSomethingElseInPlaceOfWhatIsGone) {
  ViewChange change;
  evidenceOf(change, viewOf(1, 8, 0), 10);
  EXPECT_EQ(evidenceOf(change, viewOf(1, 2, 0), 3), 0.0) << "the others are hidden";
}

TEST(ViewChange, GoesOnInTheMiddleOfAChange) {
  ViewChange change;
  evidenceOf(change, viewOf(1, 8, 0), 10);
  evidenceOf(change, viewOf(1, 0, 8), 2);
  ArchiveWriter writer;
  writer(change);
  ViewChange resumed;
  const std::string bytes = writer.take();
  ArchiveReader reader(bytes);
  reader(resumed);
  EXPECT_EQ(evidenceOf(resumed, viewOf(1, 0, 8), 1), evidenceOf(change, viewOf(1, 0, 8), 1));
}

}  // namespace
}  // namespace slam::relocalisation
