// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "slam_core/rat/view_cell.hpp"
#include "slam_ros/cell_messages.hpp"
#include "slam_ros/stage_state.hpp"

namespace slam_ros {
namespace {

/// A stage as its nodelet has it, and what the back-end's nodelet holds of it.
class StageStates : public testing::Test {
 protected:
  StageStates() { configure(part_); }

  static void configure(slam::MetaCoordinator& part) {
    slam::Settings settings;
    part.configure(settings, {slam::ProductPart::Extent::kStage, "pose_cells"});
  }
  /// The stage's nodelet takes in a view. @return whether it did
  bool take(slam::MetaCoordinator& part) {
    bool has_taken = false;
    state_->take([&] {
      slam::Motion motion;
      motion.sequence = count_;
      motion.start = at(count_);
      motion.end = at(++count_);
      motion.increment = slam::Pose2(0.1, 0.0, 0.02);
      motion.covariance = 1e-6 * Eigen::Matrix3d::Identity();
      part.put("motion", motion);
      slam::rat::ViewCell view;
      view.stamp = at(count_);
      view.sequence = count_ - 1;
      view.cell = static_cast<std::int64_t>(count_);
      part.put("local_view", view);
      has_taken = true;
    });
    return has_taken;
  }
  static slam::Stamp at(std::uint64_t i) {
    return slam::Stamp(std::chrono::milliseconds(100 * static_cast<std::int64_t>(i)));
  }

  std::shared_ptr<StageState> state_ = StageState::of("/test", "pose_cells");
  slam::MetaCoordinator part_;
  std::uint64_t count_ = 1;
};

TEST_F(StageStates, AreOneForBothNodeletsAndAnotherForEachProduct) {
  EXPECT_EQ(StageState::of("/test", "pose_cells"), state_);
  EXPECT_NE(StageState::of("/other", "pose_cells"), state_);
  EXPECT_NE(StageState::of("/test", "local_view"), state_);
}

TEST_F(StageStates, WaitForTheBackEndWhereThereAreCheckpoints) {
  EXPECT_FALSE(state_->isHere());
  state_->open(part_, true);
  EXPECT_TRUE(state_->isHere());
  EXPECT_TRUE(state_->isWaiting());
  EXPECT_FALSE(take(part_));
  state_->goOnFrom("");
  EXPECT_FALSE(state_->isWaiting());
  EXPECT_TRUE(take(part_));
}

TEST_F(StageStates, GoOnFromWhatWasCopiedInWhateverOrderTheNodeletsAreLoaded) {
  state_->open(part_, false);
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(take(part_));
  const auto saved = state_->copy();
  EXPECT_EQ(saved, slam::stateOf(part_));
  for (const bool is_back_end_first : {true, false}) {
    slam::MetaCoordinator again;
    configure(again);
    state_ = StageState::of(is_back_end_first ? "/first" : "/second", "pose_cells");
    if (is_back_end_first) state_->goOnFrom(saved);
    state_->open(again, true);
    if (!is_back_end_first) state_->goOnFrom(saved);
    EXPECT_EQ(state_->copy(), saved) << "a checkpoint before the first data keeps it";
    state_->take([] {});
    EXPECT_EQ(slam::stateOf(again), saved);
    state_->close();
  }
}

TEST_F(StageStates, BeginAnewWhereTheBackEndDoes) {
  const auto fresh = slam::stateOf(part_);
  state_->open(part_, false);
  take(part_);
  state_->goOnFrom("");
  EXPECT_EQ(state_->copy(), fresh);
  state_->take([] {});
  EXPECT_EQ(slam::stateOf(part_), fresh);
}

TEST_F(StageStates, StayWhenTheirNodeletEndsBeforeThatOfTheBackEnd) {
  state_->open(part_, true);
  state_->goOnFrom("");
  take(part_);
  const auto last = slam::stateOf(part_);
  state_->close();
  EXPECT_TRUE(state_->isHere());
  EXPECT_EQ(state_->copy(), last);
  slam::MetaCoordinator loaded_again;
  configure(loaded_again);
  state_->open(loaded_again, true);
  EXPECT_TRUE(take(loaded_again)) << "the back-end has gone on meanwhile";
  EXPECT_NE(slam::stateOf(loaded_again), last);
}

TEST(CellMessages, HoldAllThatTheDataHold) {
  const slam::rat::ViewCell view{slam::stampFromNanoseconds(1234567890123), 7, 42, true, 0.25};
  const auto same_view = fromMsg(toMsg(view));
  EXPECT_EQ(same_view.stamp, view.stamp);
  EXPECT_EQ(same_view.sequence, view.sequence);
  EXPECT_EQ(same_view.cell, view.cell);
  EXPECT_EQ(same_view.is_new, view.is_new);
  EXPECT_EQ(same_view.difference, view.difference);
  const slam::rat::PoseCellState state{view.stamp, 8, {1.0 / 3.0, 2.0 / 3.0, 35.9}, -1, 24, 36};
  const auto same_state = fromMsg(toMsg(state));
  EXPECT_EQ(same_state.stamp, state.stamp);
  EXPECT_EQ(same_state.sequence, state.sequence);
  EXPECT_EQ(same_state.place, state.place);
  EXPECT_EQ(same_state.view, state.view);
  EXPECT_EQ(same_state.edge, state.edge);
  EXPECT_EQ(same_state.headings, state.headings);
}

}  // namespace
}  // namespace slam_ros
