// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/standstill_watch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "slam_core/common/archive.hpp"
#include "slam_core/mono_graph/orb_extractor.hpp"
#include "slam_core/mono_graph/test/room_of_pictures.hpp"

namespace slam::mono_graph {
namespace {

using test::RoomOfPictures;
using test::RoundOfPictures;

/// Ten images a second of a robot whose odometry says that it stands.
class Standing {
 public:
  explicit Standing(std::uint64_t seed) : room_(seed) {}

  /// @param hidden share of the view that somebody hides, from the left, in a shirt with a pattern
  /// that moves sideways by `shift` [px]
  void see(const Pose2& place, double hidden = 0.0, int shift = 0) {
    stamp_ += std::chrono::milliseconds(100);
    auto view = room_.view(stamp_, place);
    const cv::Mat shirt = shirt_(cv::Rect(shift, 200, view.image.gray.cols, view.image.gray.rows));
    const cv::Range columns(0, static_cast<int>(hidden * view.image.gray.cols));
    if (!columns.empty()) shirt.colRange(columns).copyTo(view.image.gray.colRange(columns));
    watch_.judge(orb_.extract(view), stamp_);
  }
  StandstillWatch& watch() { return watch_; }
  Stamp stamp() const { return stamp_; }

 private:
  RoomOfPictures room_;
  cv::Mat shirt_ = RoomOfPictures(77).seenFrom({}, RoomOfPictures::calibration(1280));
  OrbExtractor orb_{400, 1.0};
  StandstillWatch watch_;
  Stamp stamp_ = stampFromNanoseconds(1000000000000);
};

const Pose2 kStart(0.0, -1.2, 0.0);

TEST(StandstillWatch, EndsWithinTwoSecondsWhereTheRobotMovesWithoutOdometry) {
  for (const std::uint64_t seed : {1, 2, 3})
    for (const Pose2& step : {Pose2(0.03, 0.0, 0.0), Pose2(0.03, 0.0, 0.03), Pose2(-0.02, 0.0, 0.0),
                              Pose2(0.0, 0.0, 0.02), Pose2(0.0, 0.0, -0.05)}) {
      Standing robot(seed);
      Pose2 place = kStart;
      for (int i = 0; i < 10; ++i) robot.see(place);
      EXPECT_FALSE(robot.watch().isLost());
      int count = 0;
      for (; count < 25 && !robot.watch().isLost(); ++count) robot.see(place = place * step);
      EXPECT_LE(count, 20) << "seed " << seed << ", step " << step.x() << " m " << step.theta();
    }
}

TEST(StandstillWatch, LastsWhilePeoplePass) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    Standing robot(seed);
    for (int i = 0; i < 200; ++i) {
      robot.see(kStart, std::max(0.0, std::sin(0.2 * i)), i);
      ASSERT_FALSE(robot.watch().isLost()) << "seed " << seed << ", image " << i;
    }
  }
}

TEST(StandstillWatch, LastsWhileSomebodyStaysAndSways) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    Standing robot(seed);
    for (int i = 0; i < 150; ++i) {
      const bool is_hidden = i > 10 && i < 90;
      robot.see(kStart, is_hidden ? 1.0 : 0.0, 40 + static_cast<int>(30.0 * std::sin(0.1 * i)));
      ASSERT_FALSE(robot.watch().isLost()) << "seed " << seed << ", image " << i;
    }
  }
}

TEST(StandstillWatch, LastsAfterAnImageFromBeforeTheRobotCameToRest) {
  for (const Pose2& before : {Pose2(-0.05, 0.0, 0.0), Pose2(0.0, 0.0, 0.05)}) {
    Standing robot(1);
    robot.see(kStart * before);
    for (int i = 0; i < 50; ++i) {
      robot.see(kStart);
      ASSERT_FALSE(robot.watch().isLost()) << "image " << i;
    }
  }
}

TEST(StandstillWatch, SaysNothingOfARobotThatTurnsSlowly) {
  constexpr double kSlow = 0.0008;  // [rad] an image
  for (const int width : {320, 640, 1280}) {
    const RoomOfPictures room(1);
    const OrbExtractor orb(400, 1.0);
    StandstillWatch watch;
    Motion turn;
    turn.increment = Pose2(0.0, 0.0, kSlow);
    for (int i = 0; i < 60; ++i) {
      const Stamp stamp = stampFromNanoseconds(1000000000000) + i * std::chrono::milliseconds(33);
      watch.move(turn);
      watch.judge(orb.extract(room.view(stamp, kStart * Pose2(0.0, 0.0, i * kSlow), width)), stamp);
      ASSERT_FALSE(watch.isLost()) << width << " px, image " << i;
    }
  }
}

TEST(StandstillWatch, SaysNothingOfARobotThatDrives) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    RoundOfPictures drive(seed);
    const OrbExtractor orb(400, 1.0);
    StandstillWatch watch;
    for (int i = 0; i < drive.stepsOfALap(); ++i) {
      const auto motion = drive.drive();
      watch.move(motion);
      watch.judge(orb.extract(drive.room().view(motion.end, drive.place())), motion.end);
      ASSERT_FALSE(watch.isLost()) << "seed " << seed << ", image " << i;
    }
  }
}

TEST(StandstillWatch, GoesOnFromItsState) {
  Standing robot(1);
  Pose2 place = kStart;
  while (!robot.watch().isLost()) robot.see(place = place * Pose2(0.03, 0.0, 0.0));
  ArchiveWriter writer;
  writer(robot.watch());
  const auto state = writer.take();
  StandstillWatch restored;
  ArchiveReader reader(state);
  reader(restored);
  EXPECT_EQ(restored.lostSince(), robot.watch().lostSince());
  restored.settle();
  EXPECT_FALSE(restored.isLost());
}

}  // namespace
}  // namespace slam::mono_graph
