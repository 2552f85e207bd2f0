// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/rat/rat_slam.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "slam_core/common/config_error.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/product/test/driven_backend.hpp"
#include "slam_core/rat/test/circle_of_views.hpp"

namespace slam::rat {
namespace {

using test::DrivenBackend;
using test::Variant;

Variant variant() {
  const auto drive = [](std::uint64_t seed) { return std::make_unique<test::CircleOfViews>(seed); };
  return {"rat", "rat", {}, {}, drive};
}

TEST(RatSlam, ComesBackToItsPlacesInTheSecondLap) {
  DrivenBackend backend(variant());
  backend.run(1, 2 * test::SimulatedWorld::kLap);
  const auto visits = backend.as<PlaceReporter>().visits();
  ASSERT_EQ(visits.size(), 2U * test::SimulatedWorld::kLap);
  std::size_t again = 0;
  for (std::size_t i = test::SimulatedWorld::kLap; i < visits.size(); ++i) {
    ASSERT_TRUE(visits[i].first.has_value());
    again += *visits[i].first <= visits[test::SimulatedWorld::kLap].stamp ? 1 : 0;
  }
  EXPECT_GT(again, 110U);
  EXPECT_GT(backend->counters()["loops"], 0U);
}

TEST(RatSlam, HasAWayThatMovesWithTheMap) {
  DrivenBackend backend(variant());
  const auto drive = backend.drive(2);
  for (int i = 0; i < 100; ++i) backend.step(*drive);
  const auto path = backend.as<PathReviser>().path();
  ASSERT_EQ(path.size(), 100U);
  EXPECT_LT((path.back().pose.vector() - backend->pose().pose.vector()).norm(), 1e-12);
}

TEST(RatSlam, SaysThatItHasNoCovariance) {
  DrivenBackend backend(variant());
  EXPECT_NE(backend.find<WithoutCovariance>(), nullptr);
  EXPECT_EQ(backend.find<LandmarkMapper>(), nullptr);
  EXPECT_EQ(backend.find<MapKeeper>(), nullptr);
}

TEST(RatSlam, GoesOnFromItsStateWithTheSameBits) {
  DrivenBackend straight(variant()), first(variant()), second(variant());
  const auto drive_a = straight.drive(3), drive_b = first.drive(3);
  for (int i = 0; i < 150; ++i) straight.step(*drive_a);
  for (int i = 0; i < 150; ++i) first.step(*drive_b);
  ArchiveWriter writer;
  first->saveState(writer);
  const auto bytes = writer.take();
  ArchiveReader reader(bytes);
  second->restoreState(reader);
  for (int i = 0; i < 60; ++i) {
    straight.step(*drive_a);
    drive_b->give(second.inputs());
    second.execute();
    ASSERT_EQ(straight->pose().pose.vector(), second->pose().pose.vector()) << i;
  }
}

TEST(RatSlam, RefusesToKeepItsMapFixed) {
  Settings settings({}, {}, {"rat.mode=localization"});
  try {
    RatSlam().configure(settings);
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find("set mode to slam"), std::string::npos);
  }
}

TEST(RatSlam, WarnsWhenItsMemoryIsFull) {
  auto small = variant();
  small.settings = {"rat.most_experiences=3"};
  DrivenBackend backend(small);
  const auto drive = backend.drive(1);
  for (int i = 0; i < 3; ++i) backend.step(*drive);
  drive->give(backend.inputs());
  const auto status = backend->execute();
  EXPECT_NE(status.message.find("rat.most_experiences"), std::string::npos) << status.message;
  EXPECT_EQ(backend->counters()["experiences_full"], 1U);
}

TEST(RatSlam, RemembersTheLastStepsOfItsWayOnly) {
  auto short_way = variant();
  short_way.settings = {"rat.most_steps=50"};
  DrivenBackend whole(variant()), backend(short_way);
  const auto drive = whole.drive(1), same = backend.drive(1);
  for (int i = 0; i < 50; ++i) backend.step(*same);
  EXPECT_EQ(backend->counters()["steps_forgotten"], 0U);
  for (int i = 0; i < 10; ++i) {
    same->give(backend.inputs());
    const auto status = backend->execute();
    EXPECT_NE(status.message.find("rat.most_steps"), std::string::npos) << status.message;
  }
  for (int i = 0; i < 60; ++i) whole.step(*drive);
  EXPECT_EQ(backend->counters()["steps_forgotten"], 10U);
  const auto path = backend.as<PathReviser>().path(), of_all = whole.as<PathReviser>().path();
  ASSERT_EQ(path.size(), 50U);
  ASSERT_EQ(of_all.size(), 60U);
  for (std::size_t i = 0; i < path.size(); ++i) {
    EXPECT_EQ(path[i].stamp, of_all[i + 10].stamp);
    EXPECT_EQ(path[i].pose.vector(), of_all[i + 10].pose.vector()) << "the map is the same";
  }
  EXPECT_EQ(backend.as<PlaceReporter>().visits().size(), 50U);
}

}  // namespace
}  // namespace slam::rat
