// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/map_files.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

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
  EXPECT_NE(said.find("1 landmarks written to " + (folder / "room.landmarks.yaml")),
            std::string::npos)
      << said;
  for (const auto* name : {"room.yaml", "room.pgm", "room.landmarks.yaml"})
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  EXPECT_EQ(folder.files(), 3u);
}

TEST_F(MapFilesTest, MapsInOneFolderStayApart) {
  auto larger = mapOf(true);
  larger.map.landmarks.push_back({8, {5, 6}, Eigen::Matrix2d::Identity() * 0.01});
  larger.map.robot.pose = {-1, 0, 0};
  saveMap(folder / "a.yaml", mapOf(true));
  saveMap(folder / "b.yaml", larger);
  saveMap(folder / "", larger);
  const auto a = loadMap(folder / "a.yaml", "map", true).map;
  EXPECT_TRUE(a.grid);
  EXPECT_EQ(a.landmarks.size(), 1u);
  EXPECT_EQ(a.robot.pose.x(), 1.0);
  const auto b = loadMap(folder / "b.yaml", "map", true).map;
  EXPECT_TRUE(b.grid);
  EXPECT_EQ(b.landmarks.size(), 2u);
  EXPECT_FALSE(loadMap(folder / "b.landmarks.yaml", "map", true).map.grid) << "landmarks alone";
}

TEST_F(MapFilesTest, TheLandmarksNameStandsForTheSameTwoFiles) {
  saveMap(folder / "room.landmarks.yaml", mapOf(true));
  const auto room = loadMap(folder / "room.yaml", "map", true).map;
  EXPECT_TRUE(room.grid);
  EXPECT_EQ(room.landmarks.size(), 1u);
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

TEST_F(MapFilesTest, OfAGridWithoutLandmarksIsNoMapOfLandmarks) {
  auto grid = mapOf(true);
  grid.map.landmarks.clear();
  std::filesystem::create_directory(folder / "saved");
  saveMap(folder / "saved", grid);
  EXPECT_TRUE(
      oneSays({sentenceOf([&] { loadMap(folder / "saved", "map", false); })},
              {"holds a grid and no landmarks", "this product's map consists of landmarks"}));
}

TEST_F(MapFilesTest, NamedLandmarksPutTheGridBeside) {
  saveMap(folder / "landmarks.yaml", mapOf(true));
  EXPECT_TRUE(std::filesystem::exists(folder / "map.pgm"));
  EXPECT_FALSE(loadMap(folder / "landmarks.yaml", "map", true).map.grid);
}

TEST_F(MapFilesTest, AGridOfAnotherProgramTellsNoPose) {
  saveMap(folder / "map.yaml", mapOf(true));
  std::filesystem::remove(folder / "landmarks.yaml");
  const auto loaded = loadMap(folder / "map.yaml", "map", true).map;
  ASSERT_TRUE(loaded.grid);
  EXPECT_EQ(loaded.robot.pose.vector(), Eigen::Vector3d::Zero());
  EXPECT_DOUBLE_EQ(loaded.robot.covariance(0, 0), 0.25);
}

TEST_F(MapFilesTest, AGridOfWhichNothingIsKnownIsNotWritten) {
  auto file = mapOf(true);
  file.map.grid->cells.clear();
  const auto said = saveMap(folder / "landmarks.yaml", file);
  EXPECT_TRUE(oneSays({said}, {"1 landmarks written", "no grid yet"}));
  EXPECT_FALSE(std::filesystem::exists(folder / "map.yaml"));
  saveMap(folder / "room.yaml", file);
  const auto loaded = loadMap(folder / "room.yaml", "map", true).map;
  EXPECT_EQ(loaded.landmarks.size(), 1u);
  EXPECT_FALSE(loaded.grid);
}

TEST_F(MapFilesTest, AnEarlierGridIsNotGivenOtherLandmarks) {
  auto file = mapOf(true);
  saveMap(folder / "room.yaml", file);
  file.map.grid->cells.clear();
  file.map.landmarks.clear();
  EXPECT_TRUE(oneSays({sentenceOf([&] { saveMap(folder / "room.yaml", file); })},
                      {"no grid yet", "room.yaml is of an earlier map"}));
  EXPECT_EQ(loadMap(folder / "room.yaml", "map", true).map.landmarks.size(), 1u);
}

TEST_F(MapFilesTest, AGridIsNotSavedToTheNameOfItsImage) {
  saveMap(folder / "room.yaml", mapOf(true));
  const auto image = test::contentOf(folder / "room.pgm");
  for (const bool is_known : {true, false}) {
    auto file = mapOf(true);
    if (!is_known) file.map.grid->cells.clear();
    EXPECT_TRUE(oneSays({sentenceOf([&] { saveMap(folder / "room.pgm", file); })},
                        {"room.pgm", "the grid's image", "ends with .yaml"}));
    EXPECT_TRUE(oneSays({sentenceOf([&] { saveMap(folder / "new.pgm", file); })}, {"new.pgm"}));
  }
  EXPECT_EQ(test::contentOf(folder / "room.pgm"), image);
  EXPECT_EQ(folder.files(), 3u) << "nothing new";
  EXPECT_EQ(sentenceOf([&] { saveMap(folder / "room.pgm", mapOf(false)); }), "");
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

/// Reading a pipe would wait for somebody to write to it.
TEST_F(MapFilesTest, OfPipesAndDevicesAreRefusedAtOnce) {
  const auto pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const auto sentence = [&](const std::string& path, bool has_grid) {
    return sentenceOf([&] { loadMap(path, "map", has_grid); });
  };
  for (const bool has_grid : {false, true}) {
    EXPECT_TRUE(oneSays({sentence(pipe, has_grid)}, {pipe.c_str(), "is a named pipe"}));
    EXPECT_TRUE(oneSays({sentence("/dev/zero", has_grid)}, {"/dev/zero", "is a device"}));
    EXPECT_TRUE(oneSays({sentence("", has_grid)}, {"its name is empty"}));
  }
  saveMap(folder / "map.yaml", mapOf(true));
  std::filesystem::rename(pipe, folder / "map.pgm");
  EXPECT_TRUE(oneSays({sentence(folder / "map.yaml", true)}, {"map.pgm", "is a named pipe"}));
  std::filesystem::rename(folder / "map.pgm", folder / "landmarks.yaml");
  EXPECT_TRUE(oneSays({sentence(folder / "", true)}, {"landmarks.yaml", "is a named pipe"}));
}

TEST_F(MapFilesTest, WithAliasesOutOfAllBoundsAreRefused) {
  const auto sentence = [&](const std::string& content) {
    const auto path = folder.write("room.yaml", content);
    return sentenceOf([&] { loadMap(path, "map", true); });
  };
  EXPECT_TRUE(oneSays({sentence("&a {version: *a}\n")}, {"room.yaml", "within what it refers to"}));
  EXPECT_TRUE(oneSays({sentence("image: &a [*a]\n")}, {"room.yaml", "within what it refers to"}));
}

}  // namespace
}  // namespace slam
