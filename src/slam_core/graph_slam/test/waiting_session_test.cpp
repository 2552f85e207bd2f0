// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/graph_slam/waiting_session.hpp"

#include <gtest/gtest.h>

#include "slam_core/common/archive.hpp"
#include "slam_core/common/test/faults.hpp"
#include "slam_core/graph_slam/test/merged_drive.hpp"

namespace slam::graph_slam {
namespace {

using test::expectNear;
using test::expectTruth;
using test::MergedDrive;
using test::RoomDrive;
using test::sentenceOf;
using test::SimulatedWorld;
using test::skip;

/// A session that waits for the other drive past the same landmarks.
class WaitsPastLandmarks : public test::DrivesPastLandmarks {};

TEST_F(WaitsPastLandmarks, AreMergedWhileTheFirstDrivesOn) {
  as<SessionMerger>(*first.backend).merge({bytesOf(second.session())});
  first.take(world, 3);
  EXPECT_EQ(first.backend->counters()["merged_sessions"], 1u);
  expectTruth(first.session(), world);
  EXPECT_GT(first.session().nodes.size(), second.session().nodes.size() + SimulatedWorld::kLap / 2);
  first.take(world, SimulatedWorld::kLap);
  EXPECT_EQ(first.backend->counters()["merged_sessions"], 1u);
  expectNear(first.backend->pose().pose, first.truth, 0.2, 0.06);
}

TEST(WaitsInARoom, AreMergedWhileOneDrives) {
  RoomDrive room(3), again(4);
  MergedDrive first{true}, running{true};
  first.take(room, RoomDrive::kLap);
  const Pose2 start = skip(again, 60);
  running.take(again, 5);
  as<SessionMerger>(*running.backend).merge(as<SessionKeeper>(*first.backend).session());
  running.take(again, RoomDrive::kLap);
  EXPECT_EQ(running.backend->counters()["merged_sessions"], 1u);
  expectNear(running.backend->pose().pose, start.between(running.truth), 0.06, 0.03);
  EXPECT_GT(running.session().scans.size(), first.session().scans.size());
}

TEST(WaitsInARoom, AreMergedByWhatTheRunningOneSawBefore) {
  RoomDrive room(3), again(4);
  MergedDrive first{true}, running{true};
  first.take(room, RoomDrive::kLap);
  const Pose2 start = skip(again, 60);
  running.take(again, RoomDrive::kLap);
  as<SessionMerger>(*running.backend).merge(as<SessionKeeper>(*first.backend).session());
  running.take(again, 40);
  EXPECT_EQ(running.backend->counters()["merged_sessions"], 1u);
  EXPECT_TRUE(as<SessionMerger>(*running.backend).unmerged().empty());
  expectNear(running.backend->pose().pose, start.between(running.truth), 0.06, 0.03);
}

TEST(WaitsInARoom, WaitOnAfterACheckpoint) {
  RoomDrive room(3), again(4);
  MergedDrive first{true}, running{true}, restored{true};
  first.take(room, RoomDrive::kLap);
  running.take(again, 30);
  as<SessionMerger>(*running.backend).merge(as<SessionKeeper>(*first.backend).session());
  running.take(again, 3);
  ArchiveWriter writer;
  running.backend->saveState(writer);
  const auto state = writer.take();
  ArchiveReader reader(state);
  restored.backend->restoreState(reader);
  ASSERT_EQ(as<SessionMerger>(*restored.backend).unmerged().size(), 1u);
  auto rest = again;
  running.take(again, RoomDrive::kLap);
  restored.take(rest, RoomDrive::kLap);
  EXPECT_EQ(running.backend->counters()["merged_sessions"], 1u);
  EXPECT_EQ(as<SessionKeeper>(*restored.backend).session().bytes,
            as<SessionKeeper>(*running.backend).session().bytes);
}

TEST_F(WaitsPastLandmarks, AreRefusedWhereTooManyWait) {
  auto& merger = as<SessionMerger>(*second.backend);
  for (int i = 0; i < 5; ++i) merger.merge({bytesOf(first.session())});
  EXPECT_NE(sentenceOf([&] { merger.merge({bytesOf(first.session())}); }).find("five sessions"),
            std::string::npos);
  EXPECT_EQ(merger.unmerged().size(), 5u);
}

TEST_F(WaitsPastLandmarks, AreMergedWithThoseOfABackEndMadeAlike) {
  const auto made = as<SessionMerger>(*first.backend).makeAlike();
  ASSERT_NE(made, nullptr);
  EXPECT_TRUE(as<LandmarkMapper>(*made).landmarks().empty());
  as<SessionMerger>(*first.backend).merge(as<SessionKeeper>(*made).session());
}

TEST(WaitingSession, IsMergedByNoBackEndWithAFixedMap) {
  GraphSlam fixed;
  GraphConfig config;
  config.mode = BackendMode::kLocalization;
  fixed.configure(config);
  EXPECT_EQ(as<SessionMerger>(fixed).makeAlike(), nullptr);
}

}  // namespace
}  // namespace slam::graph_slam
