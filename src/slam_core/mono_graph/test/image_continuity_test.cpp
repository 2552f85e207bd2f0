// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/image_continuity.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "slam_core/common/archive.hpp"
#include "slam_core/mono_graph/orb_extractor.hpp"
#include "slam_core/mono_graph/test/room_of_pictures.hpp"

namespace slam::mono_graph {
namespace {

using test::RoomOfPictures;
using test::RoundOfPictures;

/// The camera drives round and round and sees this, ten images a second.
class Views {
 public:
  using Walls = RoundOfPictures::Walls;

  explicit Views(std::uint64_t seed, Walls walls = Walls::kDifferent) : drive_(seed, walls) {}

  /// @param hidden by what is in this image, if there is one
  void step(const cv::Mat& hidden = {}, int width = 320) {
    const auto motion = drive_.drive();
    continuity_.move(motion);
    stamp_ = motion.end;
    see(drive_.room(), drive_.place(), hidden, width);
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) step();
  }
  /// The next image, of a robot that stands somewhere.
  void see(const RoomOfPictures& room, const Pose2& place, const cv::Mat& hidden = {},
           int width = 320) {
    auto view = room.view(stamp_, place, width);
    if (!hidden.empty()) view.image.gray = hidden;
    continuity_.judge(orb_.extract(view), stamp_);
  }
  /// @return how many images it takes until the robot is lost
  int stepsToLoss(int most) {
    for (int i = 1; i <= most; ++i) {
      step();
      if (continuity_.isLost()) return i;
    }
    return most + 1;
  }
  RoundOfPictures& drive() { return drive_; }
  ImageContinuity& continuity() { return continuity_; }
  Stamp stamp() const { return stamp_; }

 private:
  RoundOfPictures drive_;
  OrbExtractor orb_{400, 1.0};
  ImageContinuity continuity_;
  Stamp stamp_;
};

/// An object with a pattern, before the whole view; it has moved sideways [px].
cv::Mat objectAt(int shift) {
  const cv::Mat whole = RoomOfPictures(77).seenFrom({}, RoomOfPictures::calibration(1280));
  return whole(cv::Rect(shift, 200, 320, 240)).clone();
}

TEST(ImageContinuity, HoldsWhileTheRobotDrivesAndTurns) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    Views views(seed);
    for (int i = 0; i < views.drive().stepsOfALap(); ++i) {
      views.step();
      ASSERT_TRUE(views.continuity().admits()) << "seed " << seed << ", image " << i;
    }
    EXPECT_FALSE(views.continuity().isLost());
  }
}

TEST(ImageContinuity, EndsWithinASecondWhereTheRobotWasCarried) {
  for (const std::uint64_t seed : {1, 2, 3})
    for (const Pose2& by : {Pose2(0.6, 1.2, 2.4), Pose2(0.0, 0.0, 1.5), Pose2(1.0, 2.0, -1.5)}) {
      Views views(seed);
      views.steps(20);
      views.drive().carry(by);
      views.step();
      const Stamp first = views.stamp();
      EXPECT_FALSE(views.continuity().admits());
      EXPECT_LE(views.stepsToLoss(10), 9);
      EXPECT_EQ(views.continuity().lostSince(), first);
      views.continuity().settle();
      views.steps(20);
      EXPECT_FALSE(views.continuity().isLost());
      EXPECT_TRUE(views.continuity().admits());
    }
}

TEST(ImageContinuity, EndsAlsoWhereTheOtherSceneIsBare) {
  const RoomOfPictures other(50);
  for (const std::uint64_t seed : {1, 2, 3}) {
    Views views(seed);
    views.steps(20);
    int count = 0;
    for (; !views.continuity().isLost() && count < 15; ++count) {
      const auto motion = views.drive().drive();
      views.continuity().move(motion);
      cv::Mat bare = other.view(motion.end, views.drive().place()).image.gray.clone();
      const double covered = std::min(0.6, 0.3 + 0.15 * count);  // share of the view
      bare.colRange(0, static_cast<int>(covered * bare.cols)).setTo(128);
      views.see(other, views.drive().place(), bare);
    }
    EXPECT_LE(count, 12) << "seed " << seed;
  }
}

TEST(ImageContinuity, OutlastsAnObjectThatHidesTheViewForASecond) {
  for (const int speed : {30, 60}) {  // [px] from one image to the next
    Views views(4);
    views.steps(20);
    for (int i = 0; i < 10; ++i) {
      views.step(objectAt(100 + i * speed));
      EXPECT_TRUE(i >= 5 || !views.continuity().admits());
    }
    EXPECT_FALSE(views.continuity().isLost()) << speed;
    for (int i = 0; i < 20; ++i) {
      views.step();
      EXPECT_TRUE(views.continuity().admits());
    }
    EXPECT_FALSE(views.continuity().isLost());
  }
}

TEST(ImageContinuity, SaysNothingOfAnObjectBeforeARobotThatStands) {
  Views views(5);
  views.steps(20);
  for (int i = 0; i < 50; ++i)
    views.see(views.drive().room(), views.drive().place(), objectAt(100));
  EXPECT_FALSE(views.continuity().isLost());
  views.steps(2);
  EXPECT_TRUE(views.continuity().admits());
}

TEST(ImageContinuity, SaysNothingOfBlurredImagesNorOfAnotherCamera) {
  Views views(6);
  views.steps(20);
  for (int i = 0; i < 10; ++i) {
    cv::Mat blurred;
    cv::GaussianBlur(objectAt(100), blurred, {}, 6.0);
    views.step(blurred);
  }
  EXPECT_FALSE(views.continuity().isLost());
  views.steps(5);
  for (int i = 0; i < 20; ++i) views.step({}, 256);
  EXPECT_FALSE(views.continuity().isLost());
  EXPECT_TRUE(views.continuity().admits());
}

TEST(ImageContinuity, CannotTellPlacesThatLookAlike) {
  Views views(7, Views::Walls::kAlike);
  views.steps(20);
  const Pose2 place = views.drive().place();
  const Pose2 turned = Pose2(0.0, 0.0, M_PI / 2.0) * place;
  views.drive().carry(place.between(turned));
  EXPECT_GT(views.stepsToLoss(20), 20);
}

TEST(ImageContinuity, IsTheSameAfterACheckpoint) {
  Views saved(8), restored(8);
  for (auto* const views : {&saved, &restored}) {
    views->steps(20);
    views->drive().carry({0.6, 1.2, 2.4});
    views->steps(3);
  }
  ArchiveWriter writer;
  writer(saved.continuity());
  const auto bytes = writer.take();
  restored.continuity().settle();
  ArchiveReader reader(bytes);
  reader(restored.continuity());
  const int count = saved.stepsToLoss(10);
  EXPECT_LE(count, 7);
  EXPECT_EQ(restored.stepsToLoss(10), count);
  EXPECT_EQ(restored.continuity().lostSince(), saved.continuity().lostSince());
}

}  // namespace
}  // namespace slam::mono_graph
