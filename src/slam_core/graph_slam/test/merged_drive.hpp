// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "slam_core/graph_slam/graph_slam.hpp"
#include "slam_core/graph_slam/session_file.hpp"
#include "slam_core/models/test/simulated_room.hpp"
#include "slam_core/models/test/simulated_world.hpp"
#include "slam_core/product/test/component_driver.hpp"

namespace slam::test {

/// A back-end that drives from where its world is now, which is the origin of its map.
struct MergedDrive {
  explicit MergedDrive(bool has_grid) {
    as<MapChooser>(*backend).useMap(has_grid ? MapKind::kGrid : MapKind::kLandmarks);
    backend->configure(graph_slam::GraphConfig());
  }
  void take(SimulatedWorld& world, int steps) {
    for (int i = 0; i < steps; ++i) {
      const auto step = world.next();
      backend->set(step.motion);
      backend->set(step.observations);
      const auto status = backend->execute();
      EXPECT_TRUE(status.isOk()) << status.message;
      truth = step.truth;
    }
  }
  void take(RoomDrive& room, int steps) {
    for (int i = 0; i < steps; ++i) {
      const auto step = room.next();
      give(step.motion, *backend);
      give(step.scan, *backend);
      backend->execute();
      truth = step.truth;
    }
  }
  graph_slam::Session session() const {
    return graph_slam::sessionOf(as<SessionKeeper>(*backend).session().bytes);
  }

  std::unique_ptr<graph_slam::GraphSlam> backend = std::make_unique<graph_slam::GraphSlam>();
  Pose2 truth;  ///< in the frame of the world
};

/// Leaves out steps of a drive. @return where it then is
template <class World>
Pose2 skip(World& world, int steps) {
  Pose2 truth;
  for (int i = 0; i < steps; ++i) truth = world.next().truth;
  return truth;
}

inline void expectNear(const Pose2& a, const Pose2& b, double distance, double angle) {
  const Pose2 error = a.between(b);
  EXPECT_LT(error.position().norm(), distance);
  EXPECT_LT(std::abs(error.theta()), angle);
}

inline void expectTruth(const graph_slam::Session& session, const SimulatedWorld& world) {
  EXPECT_EQ(session.landmarks.size(), world.landmarks().size());
  for (const auto& landmark : session.landmarks)
    EXPECT_LT((landmark.position - world.landmarks().at(landmark.id)).norm(), 0.15) << landmark.id;
}

/// Two drives past the same landmarks, the second one from elsewhere.
class DrivesPastLandmarks : public testing::Test {
 protected:
  DrivesPastLandmarks() {
    first.take(world, SimulatedWorld::kLap + 20);
    start = skip(again, 40);
    second.take(again, SimulatedWorld::kLap);
  }
  SimulatedWorld world{1}, again{2};
  MergedDrive first{false}, second{false};
  Pose2 start;  ///< of the second one
};

}  // namespace slam::test
