// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/rat/local_view.hpp"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "slam_core/common/config_error.hpp"
#include "slam_core/common/random.hpp"

namespace slam::rat {
namespace {

Stamp at(double s) { return Stamp(durationFromSeconds(s)); }

/// Squares at random: a scene of its own for each seed.
cv::Mat scene(std::uint64_t seed, cv::Size size = {320, 240}) {
  cv::Mat gray(240, 320, CV_8U, cv::Scalar(120));
  RandomStream random(seed, 0);
  for (int i = 0; i < 40; ++i) {
    const int x = static_cast<int>(300 * random.uniform()),
              y = static_cast<int>(220 * random.uniform());
    const int edge = 10 + static_cast<int>(50 * random.uniform());
    cv::rectangle(gray, {x, y, edge, edge}, 255.0 * random.uniform(), cv::FILLED);
  }
  cv::resize(gray, gray, size, 0, 0, cv::INTER_AREA);
  return gray;
}

class LocalViewCells : public testing::Test {
 protected:
  LocalViewCells() { cells_.configure(LocalViewConfig()); }

  /// Returns what an image activates. Each image comes a tenth of a second after the last one.
  ViewCell see(const cv::Mat& gray, bool is_usable = true) {
    CameraView view;
    view.stamp = at(time_ += 0.1);
    view.image.gray = gray;
    CameraCalibration calibration;
    calibration.width = 320;
    calibration.height = 240;
    calibration.fx = calibration.fy = 300.0;
    if (is_usable) view.camera = std::make_shared<const CameraModel>(calibration);
    cells_.set(view);
    status_ = cells_.execute();
    const auto cell = cells_.cell();
    EXPECT_TRUE(cell.has_value());
    cells_.execute();
    EXPECT_FALSE(cells_.isBusy());
    return cell.value_or(ViewCell());
  }

  LocalView cells_;
  double time_ = 0.0;
  Status status_;
};

TEST_F(LocalViewCells, AreNewForWhatIsNewAndTheSameForTheSame) {
  for (int round = 0; round < 2; ++round)
    for (int i = 0; i < 10; ++i) {
      const auto cell = see(scene(static_cast<std::uint64_t>(i)));
      EXPECT_EQ(cell.cell, i);
      EXPECT_EQ(cell.is_new, round == 0);
      EXPECT_EQ(cell.sequence, static_cast<std::uint64_t>(10 * round + i));
    }
  EXPECT_EQ(cells_.figures().front().second, 10.0);
}

TEST_F(LocalViewCells, DoNotMindHowBrightItIs) {
  const auto bright = scene(1);
  see(bright);
  for (const double light : {0.7, 0.4, 0.2}) {
    cv::Mat dim;
    bright.convertTo(dim, CV_8U, light, 5.0);
    EXPECT_FALSE(see(dim).is_new) << light;
  }
}

TEST_F(LocalViewCells, DoNotMindASmallTurnOfTheCamera) {
  cv::Mat wide = scene(3, {400, 240});
  see(wide(cv::Rect(40, 0, 320, 240)));
  EXPECT_FALSE(see(wide(cv::Rect(54, 0, 320, 240))).is_new);
  EXPECT_FALSE(see(wide(cv::Rect(26, 0, 320, 240))).is_new);
}

TEST_F(LocalViewCells, TakeAnotherResolutionInTheMiddle) {
  see(scene(4));
  EXPECT_FALSE(see(scene(4, {640, 480})).is_new);
  EXPECT_FALSE(see(scene(4, {160, 120})).is_new);
  EXPECT_TRUE(see(scene(5, {640, 480})).is_new);
}

TEST_F(LocalViewCells, SeeNothingInADarkRoomAndBeforeABlankWall) {
  for (const double gray : {0.0, 3.0, 180.0, 255.0}) {
    cv::Mat noisy(240, 320, CV_8U);
    cv::randn(noisy, gray, 3.0);
    const auto cell = see(noisy);
    EXPECT_EQ(cell.cell, kNoView) << gray;
    EXPECT_NE(status_.message.find("dark room"), std::string::npos) << status_.message;
  }
  EXPECT_EQ(cells_.counters()["blank"], 4U);
  EXPECT_EQ(see(scene(1)).cell, 0) << "nothing was learnt there";
}

TEST_F(LocalViewCells, MoveTimeOnWithoutAnImage) {
  const auto cell = see(cv::Mat(), false);
  EXPECT_EQ(cell.cell, kNoView);
  EXPECT_EQ(cell.stamp, at(time_));
  EXPECT_EQ(cells_.counters()["unusable"], 1U);
  EXPECT_TRUE(status_.isOk()) << "the gate of the camera has said why";
}

TEST_F(LocalViewCells, StopLearningWhenTheMemoryIsFull) {
  LocalViewConfig config;
  config.most_views = 2;
  cells_.configure(config);
  see(scene(1));
  see(scene(2));
  EXPECT_EQ(see(scene(3)).cell, kNoView);
  EXPECT_NE(status_.message.find("local_view.most_views"), std::string::npos);
  EXPECT_EQ(see(scene(2)).cell, 1);
  EXPECT_EQ(cells_.counters()["views_full"], 1U);
}

TEST_F(LocalViewCells, AreFreshAfterReset) {
  see(scene(1));
  cells_.reset();
  const auto cell = see(scene(1));
  EXPECT_TRUE(cell.is_new);
  EXPECT_EQ(cell.sequence, 0U);
}

TEST(LocalViewConfig, IsRefusedWhereItLeavesNothingOfTheImage) {
  LocalViewConfig config;
  config.crop_top = config.crop_bottom = 0.6;
  EXPECT_THROW(LocalView().configure(config), ConfigError);
  config = {};
  config.largest_shift = 24;
  EXPECT_THROW(LocalView().configure(config), ConfigError);
  config = {};
  config.least_contrast = 0.0;
  EXPECT_THROW(LocalView().configure(config), ConfigError);
}

}  // namespace
}  // namespace slam::rat
