// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "slam_core/laser/laser_sweep.hpp"
#include "slam_ros/arrival_notes.hpp"
#include "slam_ros/progress_message.hpp"

namespace slam_ros {
namespace {

slam::Stamp at(int second) { return slam::Stamp(std::chrono::seconds(second)); }

/// Notes of a particle filter with a grid: its scans come through the laser's gate.
class ArrivalNotesTest : public testing::Test {
 protected:
  ArrivalNotesTest() {
    slam::ProductConfig product;
    product.backend = "pf";
    product.map = slam::MapKind::kGrid;
    const auto parts = slam::createComponents(product);
    notes = ArrivalNotes(slam::DataFlow(parts), slam::portsOf(*parts.estimator));
    arrivals.triggers.push_back({"scan", "laser scans", at(3), 0});
    arrivals.triggers.push_back({"observations", "landmarks", at(4), 0});
  }
  void takeSweep(int second) {
    slam::LaserSweep sweep;
    sweep.stamp = at(second);
    notes.take("scan", slam::kindOf<slam::LaserSweep>(), &sweep);
  }
  slam::Stamp acknowledged(const std::string& input) const {
    slam_msgs::Progress message;
    notes.acknowledge(arrivals, message);
    return progressOf(message).at(progressName(input));
  }

  ArrivalNotes notes;
  slam::Intake::Arrivals arrivals;
};

TEST_F(ArrivalNotesTest, DataThatWaitAtAGateAreAcknowledged) {
  EXPECT_EQ(acknowledged("scan"), at(3)) << "of the scans that have come out";
  takeSweep(9);
  EXPECT_EQ(acknowledged("scan"), at(9));
  EXPECT_EQ(acknowledged("observations"), at(4)) << "they have no gate";
  EXPECT_EQ(acknowledged("motion"), slam::Stamp());
}

TEST_F(ArrivalNotesTest, WhatCameBeforeANewBeginningIsForgotten) {
  takeSweep(100);
  notes.forget();
  EXPECT_EQ(acknowledged("scan"), at(3)) << "a stamp of the past would acknowledge all to come";
  takeSweep(5);
  EXPECT_EQ(acknowledged("scan"), at(5));
}

TEST_F(ArrivalNotesTest, TheTopicOfMotionIsTheOneThatMovedItOn) {
  notes.taken("observations", std::nullopt);
  EXPECT_EQ(notes.motionTopic(), "");
  notes.taken("odom", at(1));
  notes.taken("observations", at(1));
  EXPECT_EQ(notes.motionTopic(), "odom");
  notes.forget();
  notes.taken("observations", std::nullopt);
  EXPECT_EQ(notes.motionTopic(), "") << "that motion is gone is not news of motion";
  notes.taken("motion", at(1));
  EXPECT_EQ(notes.motionTopic(), "motion");
}

}  // namespace
}  // namespace slam_ros
