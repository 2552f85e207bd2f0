// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/scan_matching/agreement.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "slam_core/grid_map/scan_insertion.hpp"
#include "slam_core/models/test/simulated_room.hpp"
#include "slam_core/scan_matching/scan_evidence.hpp"

namespace slam::scan_matching {
namespace {

/// The room's map, and the last of the scans that it was drawn from.
struct MappedRoom {
  explicit MappedRoom(const grid_map::GridMapConfig& config = {}) : model(config) {
    test::RoomDrive drive(1);
    for (int i = 0; i < test::RoomDrive::kLap; ++i) {
      const auto step = drive.next();
      scan = pointsOf(step.scan, model, 0.05);
      truth = step.truth;
      insertScan(model, scan, truth, map);
    }
  }

  Agreement agreementAt(const Pose2& offset) const {
    return agreementOf(model, map, scan, truth * offset);
  }

  grid_map::BeamModel model;
  grid_map::GridMap::Memory memory;
  grid_map::GridMap map{memory};
  grid_map::ScanPoints scan;
  Pose2 truth;
};

TEST(Agreement, KnowsWhatContradictsTheMapHoweverLittleACellIsBelieved) {
  for (const double miss : {0.3, 0.4, 0.49})
    for (const double largest : {0.6, 0.7, 0.72, 0.97}) {
      grid_map::GridMapConfig config;
      config.miss_probability = miss;
      config.largest_probability = largest;
      const MappedRoom room(config);
      EXPECT_LT(room.agreementAt(Pose2()).contradictingShare(), 0.05) << miss << " " << largest;
      EXPECT_GT(room.agreementAt(Pose2(0, 0, 0.7)).contradictingShare(), 0.5)
          << miss << " " << largest;
    }
}

TEST(ScanEvidence, PrefersWallsToTheUnknownAndTheUnknownToWhereBeamsPassed) {
  const MappedRoom room;
  const ScanEvidence evidence(0.02, 0.5, 0.3);
  const auto at = [&](const Pose2& pose) { return evidence.log(room.map, room.scan, pose); };
  const double on_walls = at(room.truth), unknown = at(Pose2(1000, 0, 0));
  const double turned = at(room.truth * Pose2(0, 0, 0.7));
  EXPECT_LE(on_walls, 0.0);
  EXPECT_GT(on_walls, unknown);
  EXPECT_GT(unknown, turned);
  EXPECT_NEAR(unknown, 0.3 * std::log(0.5) * static_cast<double>(room.scan.ends.size()), 1e-9);
  EXPECT_NEAR(at(Pose2(1e300, 0, 0)), unknown, 1e-9) << "no place on a map";
}

}  // namespace
}  // namespace slam::scan_matching
