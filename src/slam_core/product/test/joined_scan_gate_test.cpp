// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/joined_scan_gate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace slam {
namespace {

Stamp joinStamp(int milliseconds) {
  return stampFromNanoseconds(1000000000) + std::chrono::milliseconds(milliseconds);
}

int joinMilliseconds(Stamp stamp) {
  return static_cast<int>(
      std::chrono::duration_cast<std::chrono::milliseconds>(stamp - joinStamp(0)).count());
}

/// One beam straight ahead of a laser, with its length as the scan's mark.
LaserScan markedScan(int milliseconds, const Pose2& mount, float range = 2.0f) {
  LaserScan scan;
  scan.stamp = joinStamp(milliseconds);
  scan.sensor_pose = mount;
  scan.beams = {{0.0f, range, true, 0.0f}};
  return scan;
}

const Pose2 kFrontMount(0.2, 0.0, 0.0), kRearMount(-0.2, 0.1, 3.0);

class JoinedScanGateTest : public testing::Test {
 protected:
  JoinedScanGateTest() { gate.configure(std::chrono::seconds(1)); }

  /// Motion of 20 ms each, up to a time [ms].
  void driveTo(int milliseconds) {
    for (; driven + 20 <= milliseconds; driven += 20) move(driven, driven + 20);
    drain();
  }
  void move(int from, int to) {
    Motion motion;
    motion.sequence = motions++;
    motion.start = joinStamp(from);
    motion.end = joinStamp(to);
    motion.increment = Pose2::exp(1e-3 * (to - from) * velocity);
    motion.covariance = 1e-6 * Eigen::Matrix3d::Identity();
    gate.set(motion);
  }
  void front(int milliseconds) {
    auto scan = markedScan(milliseconds, kFrontMount);
    scan.sequence = fronts++;
    gate.setFront(scan);
    drain();
  }
  void rear(int milliseconds, float range = 2.0f) {
    auto scan = markedScan(milliseconds, kRearMount, range);
    scan.sequence = rears++;
    gate.setRear(scan);
    drain();
  }
  void drain() {
    do {
      const auto status = gate.execute();
      if (!status.isOk()) warnings.push_back(status.message);
      if (gate.scan()) out.push_back(*gate.scan());
    } while (gate.isBusy());
  }
  /// "100+1": a scan of 100 ms with one further laser.
  std::vector<std::string> told() const {
    std::vector<std::string> all;
    for (const auto& scan : out)
      all.push_back(std::to_string(joinMilliseconds(scan.stamp)) + "+" +
                    std::to_string(scan.further.size()));
    return all;
  }

  using Told = std::vector<std::string>;
  JoinedScanGate gate;
  Eigen::Vector3d velocity{1.0, 0.0, 0.0};
  int driven = 0;
  std::uint64_t motions = 0, fronts = 0, rears = 0;
  std::vector<LaserScan> out;
  std::vector<std::string> warnings;
};

TEST_F(JoinedScanGateTest, JoinsEachFrontScanWithTheNearestRearScan) {
  for (const int later : {30, 70}) {
    gate.configure(std::chrono::seconds(1));
    out.clear();
    driven = 0;
    motions = fronts = rears = 0;
    for (int time = 0; time < 600; time += 100) {
      front(100 + time);
      rear(100 + later + time, static_cast<float>(time + 1));
      driveTo(200 + time);
    }
    ASSERT_GE(out.size(), 4u) << later;
    for (std::size_t i = 0; i < out.size(); ++i) {
      EXPECT_EQ(out[i].sequence, i);
      if (i < 2) continue;  // nobody knows yet how often scans come
      ASSERT_EQ(out[i].further.size(), 1u) << later << " " << i;
      const auto expected = later < 50 ? 100 * i + 1 : 100 * (i - 1) + 1;
      EXPECT_EQ(out[i].further[0].beams[0].range, static_cast<float>(expected)) << later;
    }
    EXPECT_EQ(gate.counters()["rear_left_out"], 0u) << later;
  }
  EXPECT_TRUE(warnings.empty());
}

TEST_F(JoinedScanGateTest, TurnsNoMapWhereOdometryHasABias) {
  velocity = {1.0, 0.0, 0.04};  // the robot drives straight on
  for (int time = 0; time < 12000; time += 5) {
    if (time % 100 == 10) front(time);
    if (time % 125 == 45) rear(time);
    if (time % 20 == 0) driveTo(time);
  }
  double sum = 0.0;
  for (const auto& scan : out)
    for (const auto& fan : scan.further) sum += fan.sensor_pose.theta() - kRearMount.theta();
  EXPECT_LT(std::abs(sum / static_cast<double>(out.size())), 3e-4)
      << "0.04 rad/s over the 60 ms between two scans are 2.4e-3";
}

TEST_F(JoinedScanGateTest, PutsTheRearLaserWhereItWasWhenItSawTheBeams) {
  velocity = {0.8, -0.1, 1.5};
  rear(50);
  front(77);
  rear(170);
  front(175);
  driveTo(200);
  ASSERT_EQ(told(), (Told{"77+1"}));
  const Pose2 T_then_now = Pose2::exp(0.027 * velocity);
  const auto& fan = out[0].further[0];
  const Eigen::Vector2d end = kRearMount.transform(Eigen::Vector2d(2.0, 0.0));
  EXPECT_LT((T_then_now.transform(fan.sensor_pose.position()) - kRearMount.position()).norm(),
            1e-9);
  EXPECT_LT((T_then_now.transform(fan.sensor_pose.transform(fan.beams[0].end())) - end).norm(),
            1e-6);
  EXPECT_EQ(out[0].sensor_pose.vector(), kFrontMount.vector())
      << "the front laser did not move since";
}

TEST_F(JoinedScanGateTest, PutsTheRearLaserWhereItWillBeWhenItSeesTheBeamsLater) {
  velocity = {0.8, -0.1, 1.5};
  for (const int time : {37, 137, 237}) front(time);
  rear(170);
  driveTo(240);
  ASSERT_GE(out.size(), 2u);
  ASSERT_EQ(told()[1], "137+1");
  const Pose2 expected = Pose2::exp(0.033 * velocity) * kRearMount;
  EXPECT_LT((out[1].further[0].sensor_pose.vector() - expected.vector()).norm(), 1e-9);
}

TEST_F(JoinedScanGateTest, NeedsNoMotionBetweenScansOfOneStamp) {
  front(100);
  rear(100);
  driveTo(200);
  ASSERT_EQ(told(), (Told{"100+1"}));
  EXPECT_EQ(out[0].further[0].sensor_pose.vector(), kRearMount.vector());
}

TEST_F(JoinedScanGateTest, MakesTheSameOfAnyOrderOfArrival) {
  const auto fronts_come = [this] {
    for (int time = 100; time <= 600; time += 100) front(time);
  };
  const auto rears_come = [this] {
    for (int time = 70; time <= 640; time += 95) rear(time, 1e-2f * static_cast<float>(time));
  };
  const auto motion_comes = [this] { driveTo(620); };
  std::vector<std::function<void()>> order = {fronts_come, rears_come, motion_comes};
  std::vector<int> turn = {0, 1, 2};
  std::vector<std::string> first;
  do {
    gate.configure(std::chrono::seconds(1));
    out.clear();
    driven = 0;
    motions = fronts = rears = 0;
    for (const int each : turn) order[static_cast<std::size_t>(each)]();
    auto now = told();
    for (const auto& scan : out)
      for (const auto& fan : scan.further)
        now.push_back(std::to_string(fan.beams[0].range) + " from " +
                      std::to_string(fan.sensor_pose.x()));
    if (first.empty()) first = now;
    EXPECT_EQ(now, first);
  } while (std::next_permutation(turn.begin(), turn.end()));
  EXPECT_EQ(first.size(), 10u) << "five scans, each joined; the last one waits";
}

TEST_F(JoinedScanGateTest, DoesNotWaitForARearLaserThatIsSilent) {
  for (int time = 100; time <= 3000; time += 100) {
    front(time);
    if (time <= 1000) rear(time + 40);
    driveTo(time + 60);
    const auto last = out.empty() ? 0 : joinMilliseconds(out.back().stamp);
    EXPECT_LE(time - last, 900) << "three quarters of a second, and a scan";
  }
  ASSERT_EQ(out.size(), 30u);
  EXPECT_EQ(out.back().further.size(), 0u);
  EXPECT_EQ(joinMilliseconds(out.back().stamp), 3000) << "once it is known, nobody waits";
  EXPECT_EQ(gate.counters()["front_alone"], 20u);
  ASSERT_FALSE(warnings.empty());
  EXPECT_NE(warnings.back().find("the rear laser has sent no scan since 2.0"), std::string::npos)
      << warnings.back();
}

TEST_F(JoinedScanGateTest, JoinsAgainWhenTheRearLaserIsBack) {
  for (int time = 100; time <= 3000; time += 100) {
    if (time <= 1000 || time > 2000) rear(time - 30);
    front(time);
    driveTo(time + 20);
  }
  ASSERT_GE(out.size(), 29u);
  for (const auto& scan : out) {
    const int time = joinMilliseconds(scan.stamp);
    if (time <= 1000 || time > 2100) {
      EXPECT_EQ(scan.further.size(), 1u) << time;
    }
  }
}

TEST_F(JoinedScanGateTest, LetsTheRearScansOutAloneWhileTheFrontLaserIsSilent) {
  for (int time = 100; time <= 3000; time += 100) {
    if (time <= 1000 || time > 2000) front(time);
    rear(time - 40);
    driveTo(time);
  }
  const auto all = told();
  EXPECT_EQ(std::count(all.begin(), all.end(), "1960+0"), 1);
  EXPECT_EQ(std::count(all.begin(), all.end(), "2900+1"), 1);
  EXPECT_GT(gate.counters()["rear_alone"], 0u);
  ASSERT_FALSE(warnings.empty());
  EXPECT_NE(warnings.front().find("the front laser has sent no scan since"), std::string::npos);
  for (std::size_t i = 1; i < out.size(); ++i) EXPECT_GT(out[i].stamp, out[i - 1].stamp);
}

TEST_F(JoinedScanGateTest, LetsTheRearScansOutWhereTheFrontLaserNeverSentAny) {
  for (int time = 100; time <= 2000; time += 100) {
    rear(time);
    driveTo(time + 20);
  }
  ASSERT_FALSE(out.empty());
  EXPECT_EQ(told().back(), "2000+0");
}

TEST_F(JoinedScanGateTest, LeavesOutAndCountsScansThatComeTwiceOrLate) {
  rear(60);
  rear(60);
  rear(40);
  front(100);
  front(100);
  rear(160);
  front(200);
  driveTo(220);
  EXPECT_EQ(told(), (Told{"100+1"}));
  EXPECT_EQ(gate.counters()["late"], 3u);
  EXPECT_GE(gate.dropped(), 3u);
}

TEST_F(JoinedScanGateTest, TakesTheLastOfSeveralRearScansAndCountsTheOthers) {
  for (int time = 10; time <= 130; time += 30) rear(time, 1e-2f * static_cast<float>(time));
  front(100);
  driveTo(140);
  ASSERT_EQ(told(), (Told{"100+1"}));
  EXPECT_FLOAT_EQ(out[0].further[0].beams[0].range, 1.0f);
  EXPECT_EQ(gate.counters()["rear_left_out"], 3u);
}

TEST_F(JoinedScanGateTest, UsesARearScanOnceOnly) {
  rear(90);
  front(100);
  front(150);
  rear(190);
  front(200);
  driveTo(220);
  EXPECT_EQ(told(), (Told{"100+1", "150+0"}));
}

TEST_F(JoinedScanGateTest, LeavesTheRearScanOutWhereMotionIsMissingBetweenTheStamps) {
  driveTo(60);
  rear(50);
  driven = 80;
  motions += 1;
  front(100);
  rear(150);
  front(200);
  rear(250);
  front(300);
  driveTo(320);
  EXPECT_EQ(told(), (Told{"100+1", "200+1"})) << "the next rear scans take its place";
  EXPECT_EQ(gate.counters()["rear_left_out"], 1u);
}

TEST_F(JoinedScanGateTest, LeavesOutMotionThatIsNoNumber) {
  velocity.x() = std::numeric_limits<double>::quiet_NaN();
  move(0, 20);
  driven = 20;
  velocity.x() = 1.0;
  rear(40);
  front(100);
  rear(140);
  front(200);
  driveTo(220);
  EXPECT_EQ(told(), (Told{"100+1"}));
  EXPECT_EQ(gate.counters()["invalid_motion"], 1u);
}

TEST_F(JoinedScanGateTest, TakesScansWithoutBeamsAndOfAnotherNumberOfBeams) {
  auto blind = markedScan(50, kRearMount);
  blind.beams.clear();
  gate.setRear(blind);
  front(100);
  auto more = markedScan(150, kRearMount);
  more.sequence = 1;
  more.beams.resize(7, more.beams[0]);
  gate.setRear(more);
  front(200);
  auto none = markedScan(250, kRearMount);
  none.sequence = 2;
  gate.setRear(none);
  driveTo(300);
  ASSERT_EQ(told(), (Told{"100+0", "200+1"}));
  EXPECT_EQ(out[1].further[0].beams.size(), 7u);
  EXPECT_EQ(gate.counters()["front_alone"], 0u) << "a blind laser is not a silent one";
}

TEST_F(JoinedScanGateTest, HoldsTheScansThatWaitForMotionAndSaysHowMany) {
  front(100);
  rear(150);
  rear(250);
  EXPECT_TRUE(out.empty());
  EXPECT_EQ(gate.held()["waiting_front"], 1u);
  EXPECT_EQ(gate.held()["waiting_rear"], 2u);
}

TEST_F(JoinedScanGateTest, GoesOnFromASavedState) {
  const auto begin = [this] {
    rear(50);
    front(100);
    driveTo(120);
    rear(150);
  };
  const auto go_on = [this] {
    front(200);
    rear(250);
    driveTo(300);
  };
  begin();
  ArchiveWriter saved;
  gate.saveState(saved);
  const auto bytes = saved.take();
  go_on();
  const auto whole = told();
  EXPECT_EQ(whole, (Told{"100+1", "200+1"}));
  const auto pose = out.back().further[0].sensor_pose.vector();
  JoinedScanGate other;
  other.configure(std::chrono::seconds(1));
  ArchiveReader reader(bytes);
  other.restoreState(reader);
  gate = other;
  out.clear();
  fronts = 1, rears = 2, motions = 6, driven = 120;
  go_on();
  EXPECT_EQ(told(), whole);
  EXPECT_EQ(out.back().further[0].sensor_pose.vector(), pose);
}

TEST_F(JoinedScanGateTest, BeginsAnewWhereTimeDoes) {
  velocity.setZero();
  rear(9000);
  front(9010);
  rear(9100);
  front(9110);
  driven = 8900;
  driveTo(9120);
  EXPECT_EQ(told(), (Told{"9010+1"}));
  motions = fronts = rears = 0;
  driven = 0;
  for (int time = 100; time <= 1000; time += 100) {
    rear(time - 50);
    front(time);
    driveTo(time + 20);
  }
  ASSERT_GT(out.size(), 5u);
  EXPECT_EQ(told().back(), "900+1");
}

}  // namespace
}  // namespace slam
