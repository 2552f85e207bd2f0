// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_sim/world_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "slam_core/common/config_error.hpp"

namespace slam::sim {
namespace {

constexpr char kRoom[] = R"(version: 1
world: room
walls:
  - {points: [[0, 0], [4, 0], [4, 4], [0, 4]], closed: true}
furniture:
  - {centre: [2, 2], size: [0.5, 0.5, 1.0]}
markers:
  - {id: 0, position: [3.99, 2, 0.6], facing: 3.1416}
path: {points: [[1, 1], [3, 1], [3, 3], [1, 3]]}
)";

class WorldFile : public testing::Test {
 protected:
  WorldFile() : path_(testing::TempDir() + "world_file_test.yaml") {}
  ~WorldFile() override { std::filesystem::remove(path_); }

  World read(const std::string& text) {
    std::ofstream(path_) << text;
    return readWorldFile(path_);
  }

  /// The room with the first `from` replaced.
  static std::string room(const std::string& from, const std::string& to) {
    std::string text = kRoom;
    return text.replace(text.find(from), from.size(), to);
  }

  /// The faults of a file that must not be read.
  std::vector<std::string> faults(const std::string& text) {
    try {
      read(text);
    } catch (const ConfigError& error) {
      return error.faults();
    }
    return {};
  }

  void expectFault(const std::string& text, const std::string& place, const std::string& sentence) {
    const auto found = faults(text);
    ASSERT_EQ(found.size(), 1u) << text << "\n" << join(found, "\n");
    EXPECT_NE(found[0].find(path_ + place), std::string::npos) << found[0];
    EXPECT_NE(found[0].find(sentence), std::string::npos) << found[0];
    EXPECT_EQ(found[0].find('\n'), std::string::npos) << found[0];
  }

  std::string path_;
};

TEST_F(WorldFile, IsReadAsItStands) {
  const auto world = read(kRoom);
  EXPECT_EQ(world.name, "room");
  ASSERT_EQ(world.walls.size(), 4u);
  EXPECT_EQ(world.walls[3].to, Eigen::Vector2d(0, 0));
  ASSERT_EQ(world.markers.size(), 1u);
  EXPECT_EQ(world.markers[0].family, "36h11");
  // facing west: to the right of who looks at it is south
  EXPECT_NEAR(world.markers[0].T_world_marker.linear()(0, 2), -1.0, 1e-4);
  EXPECT_NEAR(world.markers[0].T_world_marker.linear()(1, 0), -1.0, 1e-4);
  EXPECT_NEAR(world.markers[0].T_world_marker.linear().determinant(), 1.0, 1e-9);
}

TEST_F(WorldFile, RowsOfMarkersAreSpreadEvenlyFromEndToEnd) {
  const auto world = read(room("markers:", R"(marker_rows:
  - {first_id: 10, count: 3, from: [1, 0.1, 0.5], to: [3, 0.1, 0.7], facing: 1.5708}
markers:)"));
  ASSERT_EQ(world.markers.size(), 4u);
  EXPECT_EQ(world.markers[2].id, 11);
  EXPECT_TRUE(
      world.markers[2].T_world_marker.translation().isApprox(Eigen::Vector3d(2, 0.1, 0.6), 1e-12));
}

TEST_F(WorldFile, ATreeIsARoundTrunkUpToTheCeiling) {
  const auto world = read(room("markers:", R"(trees:
  - {centre: [2, 1], radius: 0.2}
markers:)"));
  ASSERT_EQ(world.walls.size(), 4u + 16u);
  for (std::size_t i = 4; i < world.walls.size(); ++i) {
    EXPECT_NEAR((world.walls[i].from - Eigen::Vector2d(2, 1)).norm(), 0.2, 1e-12);
    EXPECT_EQ(world.walls[i].to, world.walls[i + 1 < world.walls.size() ? i + 1 : 4].from);
    EXPECT_EQ(world.walls[i].height, world.ceiling.height);
    EXPECT_FALSE(world.walls[i].is_reflector);
  }
  const auto post = read(room("markers:", R"(trees:
  - {centre: [2, 1], radius: 0.05, reflector: true}
markers:)"));
  EXPECT_TRUE(post.walls.back().is_reflector);
  expectFault(room("markers:", "trees:\n  - {centre: [2, 1]}\nmarkers:"), ":", "has no 'radius'");
}

TEST_F(WorldFile, EveryShippedWorldIsSound) {
  for (const auto& [name, markers] :
       {std::pair("office", 12u), std::pair("corridor", 100u), std::pair("hall", 500u),
        std::pair("foyer", 13u), std::pair("forest", 0u), std::pair("depot", 0u),
        std::pair("gallery", 0u), std::pair("loops", 0u)}) {
    const auto world = readWorldFile(std::string(SLAM_SIM_FOLDER) + "/worlds/" + name + ".yaml");
    EXPECT_EQ(world.name, name);
    EXPECT_EQ(world.markers.size(), markers);
    EXPECT_EQ(world.path.laps, 2);
  }
}

TEST_F(WorldFile, ATypoIsNamedWithLineAndNearestKey) {
  expectFault(room("closed", "closd"), ":4", "closd is unknown (did you mean 'closed'?)");
}

TEST_F(WorldFile, ATypoOfANeededKeyIsNamedWithTheNearest) {
  const auto found = faults(room("facing", "facng"));
  ASSERT_EQ(found.size(), 2u) << join(found, "\n");
  EXPECT_NE(found[1].find("facng is unknown (did you mean 'facing'?)"), std::string::npos)
      << found[1];
}

TEST_F(WorldFile, AFileWithoutANameIsRefused) {
  expectFault(room("world: room\n", ""), ":1: has no 'world'", "has no 'world'");
}

TEST_F(WorldFile, AnUnknownFamilyIsNamedWithTheNearest) {
  expectFault(room("id: 0", "id: 0, family: 36h1"), ":8", "'36h1' is none of 36h11");
}

TEST_F(WorldFile, AnUnknownTextureIsNamedWithTheNearest) {
  expectFault(
      room("closed: true", "closed: true, texture: brik"), ":4",
      "texture 'brik' is none of paint, plaster, wallpaper, brick, panelling, posters, mural (did "
      "you mean 'brick'?)");
  expectFault(room("1.0]", "1.0], texture: boks"), ":6", "(did you mean 'books'?)");
  expectFault(room("walls:", "floor: {texture: parqet}\nwalls:"), ":3",
              "(did you mean 'parquet'?)");
  expectFault(room("closed: true", "closed: true, seed: 0"), ":4",
              "seed holds '0', which is not in [1, 1000000]");
}

TEST_F(WorldFile, LinesOfOneSeedLookAlikeAndOthersDoNot) {
  const auto world = read(room("furniture:", R"(  - {points: [[5, 0], [6, 0], [7, 0]], seed: 3}
  - {points: [[5, 1], [6, 1], [7, 1]], seed: 3}
  - {points: [[5, 2], [6, 2]], seed: 4}
furniture:)"));
  ASSERT_EQ(world.walls.size(), 4u + 5u);
  EXPECT_EQ(world.walls[4].look, world.walls[6].look);
  EXPECT_EQ(world.walls[5].look, world.walls[7].look);
  EXPECT_NE(world.walls[4].look, world.walls[5].look);
  EXPECT_NE(world.walls[4].look, world.walls[8].look);
  EXPECT_NE(world.walls[0].look, world.walls[1].look);
}

TEST_F(WorldFile, TheLightFollowsItsCourse) {
  const auto world = read(room("walls:", "light: {course: [[10, 1.0], [20, 0.5]]}\nwalls:"));
  for (const auto& [time, level] :
       {std::pair(0.0, 1.0), std::pair(10.0, 1.0), std::pair(15.0, 0.75), std::pair(20.0, 0.5),
        std::pair(99.0, 0.5)}) {
    EXPECT_DOUBLE_EQ(world.light.levelAt(time), level) << time;
  }
  EXPECT_EQ(Light().levelAt(5.0), 1.0);
}

TEST_F(WorldFile, ALightThatCannotBeIsRefused) {
  expectFault(room("walls:", "light: {course: [[20, 1.0], [10, 0.5]]}\nwalls:"), ":3",
              "course: the times must rise; after 20 s comes 10 s");
  expectFault(room("walls:", "light: {course: [[0, 1.0], [10, -0.5]]}\nwalls:"), ":3",
              "course holds '-0.5'");
  expectFault(room("walls:", "light: {course: [[0, 100]]}\nwalls:"), ":3",
              "the level 100 is not in [0, 4]");
  expectFault(room("walls:", "light: {curse: [[0, 1]]}\nwalls:"), ":3",
              "curse is unknown (did you mean 'course'?)");
}

TEST_F(WorldFile, DoorsHangOnWalls) {
  const auto with = [](const std::string& door) {
    return room("markers:", "doors:\n  - " + door + "\nmarkers:");
  };
  const auto world = read(with("{positions: [[1, 0], [2.5, 0]], facing: 1.5708}"));
  ASSERT_EQ(world.doors.size(), 2u);
  EXPECT_EQ(world.doors[1].position, Eigen::Vector2d(2.5, 0));
  expectFault(with("{positions: [[1, 0.5]], facing: 1.5708}"), ":8",
              "the door at (1, 0.5) hangs on no wall; put it within 0.05 m of one");
  expectFault(with("{positions: [[1, 0]], facing: 0}"), ":8",
              "does not lie along the wall from (0, 0) to (4, 0)");
  expectFault(with("{positions: [[1, 0]], facing: 1.5708, height: 3}"), ":8",
              "is 3 m high, the ceiling 2.5 m");
  expectFault(with("{positions: [[1, 0]], facing: 1.5708, width: 0}"), ":8", "width holds '0'");
}

TEST_F(WorldFile, AMarkerOfSizeZeroIsRefused) {
  expectFault(room("id: 0", "id: 0, size: 0"), ":8", "size holds '0', which is not in (0, 1000]");
}

TEST_F(WorldFile, AnIdThatTheFamilyDoesNotHaveIsRefused) {
  expectFault(room("id: 0", "id: 587"), ":8", "has no marker 587; its ids are 0 to 586");
}

TEST_F(WorldFile, TheSameIdTwiceIsRefused) {
  expectFault(room("path:", "  - {id: 0, position: [0.01, 2, 0.6], facing: 0}\npath:"), ":9",
              "there is a landmark 0 already");
}

TEST_F(WorldFile, MarkersOfTwoFamiliesMayHaveOneNumberWhereALandmarkHasOneId) {
  const auto world = readWorldFile(std::string(SLAM_SIM_FOLDER) + "/worlds/foyer.yaml");
  std::vector<std::int64_t> of_number_three;
  for (const auto& marker : world.markers)
    if (marker.id == 3) of_number_three.push_back(marker.landmark());
  EXPECT_EQ(of_number_three, (std::vector<std::int64_t>{3, 10003}));
}

TEST_F(WorldFile, AMarkerInsideFurnitureIsRefused) {
  expectFault(room("[3.99, 2, 0.6]", "[2.1, 2, 0.6]"), ":8", "is inside the furniture at (2, 2)");
}

TEST_F(WorldFile, AMarkerOnTopOfFurnitureIsNotInsideIt) {
  EXPECT_NO_THROW(read(room("[3.99, 2, 0.6]", "[2.1, 2, 1.2]")));
}

TEST_F(WorldFile, AMarkerInsideAWallIsRefused) {
  expectFault(room("[3.99, 2, 0.6]", "[4, 2, 0.6]"), ":8",
              "is inside the wall from (4, 0) to (4, 4)");
}

TEST_F(WorldFile, AMarkerThatLooksAtItsWallIsRefused) {
  expectFault(room("facing: 3.1416", "facing: 0"), ":8", "does it face the other way?");
}

TEST_F(WorldFile, AMarkerBelowTheFloorIsRefused) {
  expectFault(room("[3.99, 2, 0.6]", "[3.99, 2, 0.05]"), ":8", "beyond the floor");
}

TEST_F(WorldFile, APathThroughFurnitureIsRefused) {
  expectFault(room("[3, 1]", "[2, 1.9]"), ":9", "runs through the furniture at (2, 2)");
}

TEST_F(WorldFile, APathThroughAWallIsRefused) {
  expectFault(room("[3, 1]", "[5, 1]"), ":9", "runs through the wall from (4, 0) to (4, 4)");
}

TEST_F(WorldFile, APathOfTwoPointsIsRefused) {
  expectFault(room(", [3, 3], [1, 3]", ""), ":9", "fewer than 3 points");
}

TEST_F(WorldFile, APointThatIsFarAwayIsRefusedAtOnce) {
  const std::string range = "which is not in [-1000, 1000]";
  expectFault(room("[3, 1]", "[1000000, 1]"), ":9", "points holds '1000000', " + range);
  expectFault(room("[4, 0]", "[4, -1000000]"), ":4", "points holds '-1000000', " + range);
  expectFault(room("[2, 2]", "[2, 1000000]"), ":6", "centre holds '1000000', " + range);
  expectFault(room("[3.99, 2, 0.6]", "[1000000, 2, 0.6]"), ":8", "position holds");
  expectFault(room("0.5, 1.0]", "1000000, 1.0]"), ":6", "size holds '1000000'");
}

TEST_F(WorldFile, AnEmptyWorldIsRefused) {
  expectFault("version: 1\nworld: nothing\npath: {points: [[1, 1], [3, 1], [3, 3]]}\n", "",
              "is an empty world");
}

TEST_F(WorldFile, AnEmptyFileIsRefused) { expectFault("\n", "", "is empty"); }

TEST_F(WorldFile, ANumberThatIsNoneIsRefused) {
  expectFault(room("[2, 2]", "[2, .nan]"), ":6", "centre is a list, not a list of 2 numbers");
}

TEST_F(WorldFile, AnotherVersionIsRefused) {
  expectFault(room("version: 1", "version: 2"), "", "has version 2; this program reads version 1");
}

TEST_F(WorldFile, AllFaultsAreToldAtOnce) {
  EXPECT_EQ(faults(room("facing", "facng") + "ceilng: {}\n").size(), 3u);
}

}  // namespace
}  // namespace slam::sim
