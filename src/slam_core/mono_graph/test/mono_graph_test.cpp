// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/mono_graph.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "slam_core/common/archive.hpp"
#include "slam_core/common/atomic_file.hpp"
#include "slam_core/common/config_error.hpp"
#include "slam_core/mono_graph/test/picture_drive.hpp"

namespace slam::mono_graph {
namespace {

using test::figureOf;
using test::PictureDrive;

TEST(MonoGraph, FollowsOdometryInTheDarkAndSaysSo) {
  const cv::Mat dark(240, 320, CV_8U, cv::Scalar(2)), wall(240, 320, CV_8U, cv::Scalar(180));
  for (const cv::Mat* blank : {&dark, &wall}) {
    PictureDrive drive(5);
    drive.steps(40);
    const double before = drive.graph().pose().covariance.trace();
    for (int i = 0; i < 10; ++i) {
      const auto status = drive.stepWith(blank);
      EXPECT_NE(status.message.find("the camera sees next to nothing"), std::string::npos);
    }
    EXPECT_EQ(drive.graph().counters()["blank"], 10U);
    EXPECT_LT(drive.error(), 0.1);
    EXPECT_GT(drive.graph().pose().covariance.trace(), before);
    EXPECT_FALSE(drive.isLost());
    drive.steps(5);
    EXPECT_LT(drive.error(), 0.1) << "it goes on where it can see again";
  }
}

TEST(MonoGraph, LivesWithImagesThatCannotBeUsed) {
  PictureDrive drive(6);
  drive.steps(40);
  const cv::Mat none;
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(drive.stepWith(&none).isOk());
  const cv::Mat some(240, 320, CV_8U, cv::Scalar(100));
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(drive.stepWith(&some, false).isOk());
  EXPECT_EQ(drive.graph().counters()["unusable"], 10U);
  EXPECT_LT(drive.error(), 0.1);
}

TEST(MonoGraph, BridgesAGapByOdometry) {
  PictureDrive drive(7);
  drive.steps(40);
  for (int i = 0; i < 100; ++i) drive.stepWith(nullptr);  // 10 s
  drive.steps(40);
  EXPECT_LT(drive.error(), 0.15);
  EXPECT_FALSE(drive.isLost());
}

TEST(MonoGraph, KnowsItsHeadingBeforeItKnowsAnyPoint) {
  double squares = 0.0;
  constexpr int kDrives = 4, kSteps = 12;
  constexpr double kTurnSigma = 0.03;  // of the heading, by odometry, a step [rad]
  for (std::uint64_t seed = 21; seed < 21 + kDrives; ++seed) {
    PictureDrive drive(seed);
    drive.round().errBy({0.002, 0.001, kTurnSigma});
    drive.steps(kSteps);
    squares += std::pow(drive.headingError(), 2) / kDrives;
    EXPECT_LT(drive.nees(), 16.0) << "seed " << seed;
  }
  EXPECT_LT(std::sqrt(squares), 0.35 * kTurnSigma * std::sqrt(kSteps));
}

TEST(MonoGraph, SaysThatOdometryTellsAnotherWayThanTheImages) {
  PictureDrive drive(13);
  std::string said;
  for (int i = 0; i < 100; ++i) {
    auto motion = drive.round().drive();
    motion.increment = Pose2(-motion.increment.x(), 0.0, motion.increment.theta());
    drive.inputs().set(motion);
    drive.inputs().set(drive.round().room().view(motion.end, drive.round().place()));
    said += drive.graph().execute().message;
  }
  EXPECT_NE(said.find("no points that fit the motion that odometry reports"), std::string::npos);
  EXPECT_GT(drive.graph().counters()["without_points"], 0U);
}

TEST(MonoGraph, MissesNoPointsOnAWayOnWhichItSawNothing) {
  constexpr int kWay = 100;  // steps of 0.06 m
  PictureDrive late(14);
  for (int i = 0; i < kWay; ++i) late.stepWith(nullptr);
  late.steps(10);
  EXPECT_EQ(late.graph().counters()["without_points"], 0U);
  PictureDrive gap(15);
  gap.steps(40);
  for (int i = 0; i < kWay; ++i) gap.stepWith(nullptr);
  gap.steps(10);
  EXPECT_EQ(gap.graph().counters()["without_points"], 0U);
}

TEST(MonoGraph, TakesImagesThatComeSeldom) {
  PictureDrive drive(8);
  drive.step();
  for (int i = 0; i < 30; ++i) {  // 2 Hz
    for (int k = 0; k < 4; ++k) drive.stepWith(nullptr);
    drive.step();
  }
  EXPECT_LT(drive.error(), 0.12);
}

TEST(MonoGraph, ShowsWhatItTracksAndItsMapOfPoints) {
  PictureDrive drive(12);
  const auto capabilities = capabilitiesOf(drive.graph());
  EXPECT_TRUE(capabilities.find<ViewDrawer>()->drawing().empty()) << "no image yet";
  drive.steps(40);
  const auto picture = capabilities.find<ViewDrawer>()->drawing();
  ASSERT_EQ(picture.type(), CV_8UC3);
  EXPECT_EQ(picture.size(), cv::Size(320, 240));
  const auto points = capabilities.find<FeatureMapper>()->features();
  EXPECT_EQ(static_cast<double>(points.size()), figureOf(drive.graph(), "map_points"));
  for (const auto& [id, position, covariance] : points) {
    ASSERT_TRUE(position.allFinite());
    ASSERT_GT(covariance.determinant(), 0.0) << id;
  }
}

TEST(MonoGraph, CountsWhatBecameOfTheFeaturesOfAnImage) {
  PictureDrive drive(9);
  drive.steps(40);
  auto before = drive.graph().counters();
  drive.step();
  const auto view = as<ViewReporter>(drive.graph()).viewStatistics();
  ASSERT_TRUE(view);
  EXPECT_GT(view->matched, 10U);
  EXPECT_GE(view->expected, view->matched);
  EXPECT_GE(view->features, view->matched + view->rejected);
  auto after = drive.graph().counters();
  EXPECT_EQ(after["matched"] - before["matched"], view->matched);
  EXPECT_EQ(after["rejected"] - before["rejected"], view->rejected);
  drive.graph().execute();
  EXPECT_FALSE(as<ViewReporter>(drive.graph()).viewStatistics()) << "no image came";
  drive.step();
  CameraView unusable;
  unusable.stamp = stampFromNanoseconds(1004100000000);
  drive.inputs().set(unusable);
  drive.graph().execute();
  EXPECT_FALSE(as<ViewReporter>(drive.graph()).viewStatistics()) << "not of an earlier image";
}

TEST(MonoGraph, TakesTheSameImageTwice) {
  PictureDrive drive(9);
  drive.steps(40);
  const auto keyframes = figureOf(drive.graph(), "keyframes");
  const auto pose = drive.graph().pose();
  drive.inputs().set(
      drive.round().room().view(stampFromNanoseconds(1004100000000), drive.round().place()));
  EXPECT_TRUE(drive.graph().execute().isOk());
  EXPECT_LT((drive.graph().pose().pose.vector() - pose.pose.vector()).norm(), 0.01);
  EXPECT_EQ(figureOf(drive.graph(), "keyframes"), keyframes);
}

TEST(MonoGraph, GoesOnWithImagesOfAnotherResolution) {
  PictureDrive drive(10);
  drive.steps(40);
  for (int i = 0; i < 40; ++i) {
    const auto motion = drive.round().drive();
    drive.inputs().set(motion);
    drive.inputs().set(drive.round().room().view(motion.end, drive.round().place(), 256));
    EXPECT_TRUE(drive.graph().execute().isOk());
  }
  drive.know(Pose2(0.0, -1.2, 0.0).between(drive.round().place()));
  EXPECT_LT(drive.error(), 0.1);
}

/// @param steps after a keyframe, whose work is not done yet
void expectTheSameAfterACheckpoint(int steps) {
  PictureDrive saved(12), restored(12);
  saved.steps(30);
  restored.steps(30);
  for (const auto before = figureOf(saved.graph(), "keyframes");
       figureOf(saved.graph(), "keyframes") == before; restored.step())
    saved.step();
  saved.steps(steps);
  restored.steps(steps);
  ArchiveWriter writer;
  saved.graph().saveState(writer);
  const auto bytes = writer.take();
  MonoGraphConfig config;
  restored.graph().configure(config);
  ArchiveReader reader(bytes);
  restored.graph().restoreState(reader);
  saved.steps(15);
  restored.steps(15);
  EXPECT_EQ(saved.graph().pose().pose.vector(), restored.graph().pose().pose.vector());
  EXPECT_EQ(saved.graph().pose().covariance, restored.graph().pose().covariance);
}

TEST(MonoGraph, IsTheSameAfterACheckpoint) {
  for (const int steps : {0, 1, 2}) expectTheSameAfterACheckpoint(steps);
}

TEST(MonoGraph, StopsMappingWhereItsMemoryIsFull) {
  MonoGraphConfig config;
  config.most_keyframes = 5;
  PictureDrive drive(13, config);
  Status last;
  for (int i = 0; i < 40; ++i)
    if (const auto status = drive.step(); !status.isOk()) last = status;
  EXPECT_NE(last.message.find("mono_graph.most_keyframes"), std::string::npos);
  EXPECT_EQ(figureOf(drive.graph(), "keyframes"), 5.0);
  EXPECT_LT(drive.error(), 0.1);
}

void expectRefusal(const MonoGraphConfig& config, const std::string& part) {
  MonoGraph graph;
  try {
    graph.configure(config);
    FAIL() << "it was taken";
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(MonoGraph, RefusesWhatItCannotDo) {
  MonoGraphConfig config;
  config.mode = BackendMode::kLocalization;
  expectRefusal(config, "mono_graph.mode");
  config = {};
  config.window = 1;
  expectRefusal(config, "window");
}

TEST(MonoGraph, NamesAVocabularyThatIsMissingOrDamaged) {
  const auto path =
      (std::filesystem::temp_directory_path() / "mono_graph_test_words.vocabulary").string();
  MonoGraphConfig config;
  config.vocabulary = path;
  std::filesystem::remove(path);
  expectRefusal(config, "cannot read the vocabulary " + path);
  writeFileAtomically(path, Vocabulary::builtIn().bytes().substr(0, 5000));
  expectRefusal(config, "cannot use the vocabulary " + path);
  writeFileAtomically(path, "something else");
  expectRefusal(config, "it is no vocabulary of visual words");
  writeFileAtomically(path, Vocabulary::builtIn().bytes());
  EXPECT_NO_THROW(MonoGraph().configure(config));
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace slam::mono_graph
