// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/rat/pose_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "slam_core/common/config_error.hpp"
#include "slam_core/rat/pose_cell_network.hpp"

namespace slam::rat {
namespace {

double distance(const CellPlace& a, const CellPlace& b, const PoseCellConfig& config = {}) {
  return distanceOf(a, b, config.edge, config.headings);
}

double sumOf(const PoseCellNetwork& network, const PoseCellConfig& config = {}) {
  double sum = 0.0;
  for (int theta = 0; theta < config.headings; ++theta)
    for (int y = 0; y < config.edge; ++y)
      for (int x = 0; x < config.edge; ++x) sum += network.activityAt(x, y, theta);
  return sum;
}

PoseCellNetwork settled() {
  PoseCellNetwork network{PoseCellConfig()};
  for (int i = 0; i < 10; ++i) network.settle();
  return network;
}

/// Where a pose is in the network, which has begun at the origin.
CellPlace cellsOf(const Pose2& pose, const PoseCellConfig& config = {}) {
  return {pose.x() / config.cell_size, pose.y() / config.cell_size,
          pose.theta() * config.headings / (2.0 * M_PI)};
}

TEST(PoseCellNetwork, KeepsOnePacketWhereItIs) {
  auto network = settled();
  for (int i = 0; i < 200; ++i) network.settle();
  EXPECT_LT(distance(network.centre(), {0, 0, 0}), 1e-6);
  EXPECT_NEAR(sumOf(network), 1.0, 1e-9);
  EXPECT_GT(network.activityAt(0, 0, 0), 0.01);
  EXPECT_EQ(network.activityAt(12, 12, 18), 0.0);
}

TEST(PoseCellNetwork, FollowsAWayByItsMotion) {
  auto network = settled();
  Pose2 pose;
  for (int i = 0; i < 400; ++i) {  // two circles of 1.3 m and straight pieces, over the edge
    const Pose2 step(0.08, 0.0, i % 100 < 60 ? 0.06 : 0.0);
    pose = pose * step;
    network.move(step);
    network.settle();
  }
  // The packet is several headings wide, whose ways are shorter together than that of one.
  const double way = 400 * 0.08 / PoseCellConfig().cell_size;
  EXPECT_LT(distance(network.centre(), cellsOf(pose)), 0.04 * way);
}

TEST(PoseCellNetwork, IsSomewhereAfterALongWayWithoutAView) {
  auto network = settled();
  for (int i = 0; i < 1500; ++i) network.move(Pose2(0.02, 0.0, 0.0052));
  network.settle();
  EXPECT_TRUE(std::isfinite(network.centre().x)) << network.centre().x;
  EXPECT_NEAR(sumOf(network), 1.0, 1e-9);
  for (int i = 0; i < 20; ++i) {
    network.inject({5.0, 6.0, 7.0}, 0.2);
    network.settle();
  }
  EXPECT_LT(distance(network.centre(), {5.0, 6.0, 7.0}), 0.5);
}

TEST(PoseCellNetwork, IsSomewhereWhereInhibitionIsStrongerThanAnyPacket) {
  PoseCellConfig config;
  config.excitation_sigma = 2.0;
  config.inhibition_sigma = 3.0;
  config.global_inhibition = 0.01;
  PoseCellNetwork network(config);
  for (int i = 0; i < 5; ++i) network.settle();
  EXPECT_LT(distance(network.centre(), {0, 0, 0}), 1e-6);
  EXPECT_NEAR(sumOf(network), 1.0, 1e-9);
}

TEST(PoseCellNetwork, GoesBackwardsAndSideways) {
  auto network = settled();
  Pose2 pose;
  for (int i = 0; i < 50; ++i) {
    const Pose2 step(-0.05, 0.03, -0.05);
    pose = pose * step;
    network.move(step);
    network.settle();
  }
  EXPECT_LT(distance(network.centre(), cellsOf(pose)), 1.0);
}

TEST(PoseCellNetwork, IsNotMovedByOneViewButBySeveral) {
  auto network = settled();
  const CellPlace elsewhere{10, 5, 9};
  const double injected = PoseCellConfig().injected;
  for (int i = 0; i < 3; ++i) {  // as long as one view is in sight
    network.inject(elsewhere, injected);
    network.settle();
    EXPECT_LT(distance(network.centre(), {0, 0, 0}), 0.5);
  }
  int steps = 0;
  while (distance(network.centre(), elsewhere) > 0.5 && ++steps < 60) {
    network.inject(elsewhere, injected);
    network.settle();
  }
  EXPECT_LT(steps, 20);
  EXPECT_NEAR(sumOf(network), 1.0, 1e-9);
}

TEST(PoseCellNetwork, ForgetsAViewThatNothingConfirms) {
  auto network = settled();
  for (int i = 0; i < 3; ++i) {
    network.inject({10, 5, 9}, PoseCellConfig().injected);
    network.settle();
  }
  for (int i = 0; i < 40; ++i) network.settle();
  EXPECT_EQ(network.activityAt(10, 5, 9), 0.0);
  EXPECT_LT(distance(network.centre(), {0, 0, 0}), 0.5);
}

/// Motion of 0.1 s and 0.08 m, and a view at its end.
class PoseCellsInMotion : public testing::Test {
 protected:
  PoseCellsInMotion() { cells_.configure(PoseCellConfig()); }

  static Motion motion(std::uint64_t i, double length = 0.08) {
    Motion motion;
    motion.sequence = i;
    motion.start = at(i);
    motion.end = at(i + 1);
    motion.increment = Pose2(length, 0.0, 0.0);
    motion.covariance = 1e-6 * Eigen::Matrix3d::Identity();
    return motion;
  }
  static ViewCell view(std::uint64_t i, std::int64_t cell) {
    return {at(i + 1), i, cell, false, 0.0};
  }
  static Stamp at(std::uint64_t i) {
    return Stamp(std::chrono::milliseconds(100 * static_cast<std::int64_t>(i)));
  }
  /// All states that are due.
  static std::vector<PoseCellState> run(PoseCells& cells) {
    std::vector<PoseCellState> states;
    do {
      EXPECT_TRUE(cells.execute().isOk());
      if (cells.state()) states.push_back(*cells.state());
    } while (cells.isBusy());
    return states;
  }
  std::vector<PoseCellState> drive(const std::vector<std::int64_t>& views, double length = 0.08) {
    std::vector<PoseCellState> states;
    for (const auto cell : views) {
      cells_.set(motion(count_, length));
      cells_.set(view(count_, cell));
      ++count_;
      for (const auto& state : run(cells_)) states.push_back(state);
    }
    return states;
  }

  PoseCells cells_;
  std::uint64_t count_ = 0;
};

TEST_F(PoseCellsInMotion, GiveAStateForEachViewWithItsStampAndCell) {
  const auto states = drive({0, 1, 2, kNoView, 3});
  ASSERT_EQ(states.size(), 5U);
  for (std::size_t i = 0; i < states.size(); ++i) {
    EXPECT_EQ(states[i].stamp, at(i + 1));
    EXPECT_EQ(states[i].sequence, i);
    EXPECT_EQ(faultOf(states[i]), "");
  }
  EXPECT_EQ(states[3].view, kNoView);
}

TEST_F(PoseCellsInMotion, DoNotDependOnTheOrderOfArrival) {
  PoseCells other;
  other.configure(PoseCellConfig());
  for (std::uint64_t i = 0; i < 20; ++i) other.set(view(i, static_cast<std::int64_t>(i % 7)));
  EXPECT_TRUE(run(other).empty()) << "they wait for motion";
  for (std::uint64_t i = 0; i < 20; ++i) other.set(motion(i));
  const auto late = run(other);
  std::vector<std::int64_t> views;
  for (int i = 0; i < 20; ++i) views.push_back(i % 7);
  const auto states = drive(views);
  ASSERT_EQ(late.size(), states.size());
  for (std::size_t i = 0; i < late.size(); ++i) EXPECT_EQ(late[i].place, states[i].place) << i;
}

TEST_F(PoseCellsInMotion, ComeBackToWhereAWayOfViewsWasSeenFirst) {
  std::vector<std::int64_t> views;
  for (int i = 0; i < 40; ++i) views.push_back(i);
  const auto first = drive(views);
  std::vector<std::int64_t> elsewhere(30, kNoView);
  drive(elsewhere, 0.05);
  const auto second = drive(views);
  EXPECT_GT(distance(second[0].place, first[0].place), 4.0) << "one view convinces nobody";
  EXPECT_LT(distance(second[39].place, first[39].place), 0.7);
}

TEST_F(PoseCellsInMotion, AreNotConvincedByStandingBeforeOneView) {
  drive({0});
  std::vector<std::int64_t> nothing(40, kNoView);
  const auto away = drive(nothing, 0.05).back();
  std::vector<std::int64_t> standing(200, 0);
  const auto states = drive(standing, 0.0);
  EXPECT_LT(distance(states.back().place, away.place), 1.0);
}

TEST_F(PoseCellsInMotion, LeaveOutWhatCannotBeUsed) {
  const auto before = drive({0, 1, 2, 3}).back();
  Motion broken = motion(count_);
  broken.increment = Pose2(std::nan(""), 0.0, 0.0);
  cells_.set(broken);
  EXPECT_NE(cells_.execute().message.find("not a number"), std::string::npos);
  auto no_view = view(count_, -2);
  cells_.set(no_view);
  EXPECT_NE(cells_.execute().message.find("a number that none can have"), std::string::npos);
  EXPECT_EQ(cells_.counters()["invalid_motion"], 1U);
  EXPECT_EQ(cells_.counters()["invalid_local_view"], 1U);
  ++count_;
  const auto after = drive({4, 5}).back();
  EXPECT_EQ(faultOf(after), "");
  EXPECT_LT(distance(after.place, before.place), 2.0);
  EXPECT_EQ(cells_.counters()["lost"], 0U) << "nothing was lost on the way";
}

TEST_F(PoseCellsInMotion, SayThatViewsWaitForMotionThatDoesNotCome) {
  drive({0, 1, 2});
  for (; count_ < 33; ++count_) {
    cells_.set(view(count_, 1));
    EXPECT_TRUE(cells_.execute().isOk()) << "for three seconds";
  }
  cells_.set(view(count_, 1));
  EXPECT_EQ(cells_.execute().message, "no update: views of the camera since 0.4 wait for motion");
}

TEST_F(PoseCellsInMotion, AreFreshAfterReset) {
  const auto first = drive({0, 1, 2, 0, 1, 2});
  cells_.reset();
  count_ = 0;
  const auto again = drive({0, 1, 2, 0, 1, 2});
  ASSERT_EQ(again.size(), first.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(again[i].place, first[i].place);
    EXPECT_EQ(again[i].sequence, first[i].sequence);
  }
}

TEST(PoseCellConfig, IsRefusedWhereInhibitionReachesNoFurtherThanExcitation) {
  PoseCellConfig config;
  config.inhibition_sigma = config.excitation_sigma;
  EXPECT_THROW(PoseCells().configure(config), ConfigError);
}

TEST(PoseCellStateFault, IsASentenceForWhatIsNoPlace) {
  PoseCellState state;
  EXPECT_EQ(faultOf(state), "");
  state.place.x = std::nan("");
  EXPECT_NE(faultOf(state), "");
  state = {};
  state.edge = 0;
  EXPECT_NE(faultOf(state), "");
}

}  // namespace
}  // namespace slam::rat
