// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "import_error.hpp"
#include "rawlog_truth.hpp"
#include "temp_folder.hpp"

namespace slam::eval {
namespace {

TEST(RawlogTruth, FindsTheFilesUnderBothNames) {
  const TempFolder folder;
  const std::string rawlog = folder.file("a.rawlog");
  EXPECT_EQ(findTruthFile(rawlog, "_ground_truth.txt"), "");
  folder.write("a.rawlog_ground_truth.txt", "");
  EXPECT_EQ(findTruthFile(rawlog, "_ground_truth.txt"), rawlog + "_ground_truth.txt");
  folder.write("a_ground_truth.txt", "");
  EXPECT_EQ(findTruthFile(rawlog, "_ground_truth.txt"), folder.file("a_ground_truth.txt"));
}

TEST(RawlogTruth, ReadsLandmarksSortedById) {
  const TempFolder folder;
  folder.write("l.txt", " 1.0 2.0 0.0 5 0 0.0 2 \n -3.5 4.0 0.0 5 0 0.0 1 \n");
  const auto landmarks = readTrueLandmarks(folder.file("l.txt"));
  ASSERT_EQ(landmarks.size(), 2u);
  EXPECT_EQ(landmarks[0].id, 1);
  EXPECT_DOUBLE_EQ(landmarks[0].x, -3.5);
}

TEST(RawlogTruth, RefusesALandmarkThatStandsTwice) {
  const TempFolder folder;
  folder.write("l.txt", "1 2 0 5 0 0 7\n1 2 0 5 0 0 7\n");
  EXPECT_THROW(readTrueLandmarks(folder.file("l.txt")), ImportError);
}

TEST(RawlogTruth, ReadsOnePoseAFrameAndLeavesOutTheOneAfterTheLastMotion) {
  const TempFolder folder;
  folder.write("p.txt", "% Columns are\n\n0 0 0 0 -0 0\n1.5 2.5 0 0.25 0 0\n3 4 0 0.5 0 0\n");
  EXPECT_EQ(readTruePath(folder.file("p.txt"), 3).size(), 3u);
  const auto poses = readTruePath(folder.file("p.txt"), 2);
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_DOUBLE_EQ(poses[1].y, 2.5);
  EXPECT_DOUBLE_EQ(poses[1].theta, 0.25);
}

TEST(RawlogTruth, RefusesAPathOfAnotherLog) {
  const TempFolder folder;
  folder.write("p.txt", "0 0 0 0 0 0\n");
  const auto message = messageOf<ImportError>([&] { readTruePath(folder.file("p.txt"), 5); });
  EXPECT_NE(message.find("holds 1 poses, but the log 5 frames"), std::string::npos) << message;
}

TEST(RawlogTruth, RefusesAFileThatIsNotThere) {
  const TempFolder folder;
  EXPECT_THROW(readTruePath(folder.file("none"), 5), UsageError);
  EXPECT_THROW(readTrueLandmarks(folder.file("none")), UsageError);
}

}  // namespace
}  // namespace slam::eval
