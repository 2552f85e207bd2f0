// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/map_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/common/test/temporary_folder.hpp"

namespace slam {
namespace {

using test::oneSays;
using test::sentenceOf;

LandmarkFile mapOf(bool with_grid) {
  LandmarkFile file;
  file.map.robot.pose = {1, 2, 0.5};
  file.map.robot.covariance = Eigen::Matrix3d::Identity() * 0.01;
  file.map.landmarks = {{7, {3, 4}, Eigen::Matrix2d::Identity() * 0.01}};
  if (!with_grid) return file;
  file.map.grid.emplace();
  file.map.grid->resolution = 0.1;
  file.map.grid->origin = {-1, -2};
  file.map.grid->width = 3;
  file.map.grid->height = 2;
  file.map.grid->cells = {0, 100, OccupancyGrid::kUnknown, 0, 0, 100};
  return file;
}

class MapFilesTest : public testing::Test {
 protected:
  test::TemporaryFolder folder;
};

TEST_F(MapFilesTest, LandmarksAloneGoToTheVeryFile) {
  saveMap(folder / "room.yaml", mapOf(false));
  EXPECT_EQ(loadMap(folder / "room.yaml", "map", false).map.landmarks.size(), 1u);
  EXPECT_FALSE(std::filesystem::exists(folder / "landmarks.yaml"));
}

TEST_F(MapFilesTest, AGridTakesTheNameAndTheLandmarksStandBeside) {
  const auto said = saveMap(folder / "room.yaml", mapOf(true));
  EXPECT_NE(said.find("3 x 2 cells"), std::string::npos) << said;
  for (const auto* name : {"room.yaml", "room.pgm", "landmarks.yaml"})
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
}

TEST_F(MapFilesTest, AFolderHoldsBothUnderTheirUsualNames) {
  std::filesystem::create_directory(folder / "saved");
  saveMap(folder / "saved", mapOf(true));
  const auto loaded = loadMap(folder / "saved", "map", true).map;
  EXPECT_EQ(loaded.landmarks.size(), 1u);
  EXPECT_EQ(loaded.robot.pose.x(), 1.0);
  ASSERT_TRUE(loaded.grid);
  EXPECT_EQ(loaded.grid->width, 3u);
  const auto landmarks = loadMap(folder / "saved", "map", false).map;
  EXPECT_FALSE(landmarks.grid) << "a back-end of landmarks leaves the grid alone";
}

TEST_F(MapFilesTest, NamedLandmarksPutTheGridBeside) {
  saveMap(folder / "landmarks.yaml", mapOf(true));
  EXPECT_TRUE(std::filesystem::exists(folder / "map.pgm"));
  EXPECT_FALSE(loadMap(folder / "landmarks.yaml", "map", true).map.grid);
}

TEST_F(MapFilesTest, AGridOfAnotherProgramTellsNoPose) {
  saveMap(folder / "map.yaml", mapOf(true));
  const auto loaded = loadMap(folder / "map.yaml", "map", true).map;
  ASSERT_TRUE(loaded.grid);
  EXPECT_EQ(loaded.robot.pose.vector(), Eigen::Vector3d::Zero());
  EXPECT_DOUBLE_EQ(loaded.robot.covariance(0, 0), 0.25);
}

TEST_F(MapFilesTest, AGridOfWhichNothingIsKnownIsNotWritten) {
  auto file = mapOf(true);
  file.map.grid->cells.clear();
  saveMap(folder / "landmarks.yaml", file);
  EXPECT_FALSE(std::filesystem::exists(folder / "map.yaml"));
}

TEST_F(MapFilesTest, SaysWhatCannotBeLoaded) {
  saveMap(folder / "map.yaml", mapOf(true));
  const auto sentence = [&](const std::string& path, bool has_grid) {
    return sentenceOf([&] { loadMap(path, "map", has_grid); });
  };
  EXPECT_TRUE(oneSays({sentence(folder / "map.yaml", false)}, {"is a grid"}));
  std::filesystem::create_directory(folder / "empty");
  EXPECT_TRUE(oneSays({sentence(folder / "empty", true)}, {"no landmarks.yaml and no map.yaml"}));
  EXPECT_TRUE(oneSays({sentence(folder / "nowhere.yaml", true)}, {"nowhere.yaml", "exist"}));
  std::filesystem::remove(folder / "map.pgm");
  EXPECT_TRUE(oneSays({sentence(folder / "map.yaml", true)}, {"map.pgm"}));
}

}  // namespace
}  // namespace slam
