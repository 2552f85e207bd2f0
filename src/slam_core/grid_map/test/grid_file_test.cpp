// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/grid_map/grid_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/common/test/temporary_folder.hpp"

namespace slam::grid_map {
namespace {

constexpr auto kUnknownCell = OccupancyGrid::kUnknown;

const std::string kYaml =
    "image: m.pgm\nresolution: 0.05\norigin: [-1, 2.5, 0.0]\nnegate: 0\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n";

using test::contentOf;
using test::sentenceOf;

class GridFileTest : public testing::Test {
 protected:
  /// The sentence with which m.yaml is refused; empty where it is not.
  std::string refusalOf(const std::string& yaml, const std::string& image) const {
    folder_.write("m.yaml", yaml);
    folder_.write("m.pgm", image);
    return refusal();
  }

  std::string refusal() const {
    return sentenceOf([&] { loadGrid(path("m.yaml")); });
  }

  std::string path(const std::string& name) const { return folder_ / name; }

  static std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  }

  const test::TemporaryFolder folder_;
};

OccupancyGrid savedGrid() {
  OccupancyGrid grid;
  grid.resolution = 0.05;
  grid.origin = {-12.35, 0.1 + 0.2};
  grid.width = 3;
  grid.height = 2;
  grid.cells = {0, 100, kUnknownCell, 25, 65, 40};
  return grid;
}

void expectContains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text << "\nhas no\n" << part;
}

TEST_F(GridFileTest, WritesTheGreyValuesOfMapSaverTheTopRowFirst) {
  saveGrid(path("map.yaml"), savedGrid());
  const std::string image = contentOf(path("map.pgm"));
  EXPECT_EQ(image.substr(0, 3), "P5\n");
  const std::string pixels = image.substr(image.size() - 6);
  EXPECT_EQ(pixels, std::string("\xfe\x00\xcd\xfe\x00\xcd", 6));
}

TEST_F(GridFileTest, ReadsBackWhatItWroteAsFreeOccupiedOrUnknown) {
  saveGrid(path("map.yaml"), savedGrid());
  const auto grid = loadGrid(path("map.yaml"));
  EXPECT_EQ(grid.resolution, savedGrid().resolution);
  EXPECT_EQ(grid.origin, savedGrid().origin) << "to the last digit";
  EXPECT_EQ(grid.width, 3u);
  EXPECT_EQ(grid.height, 2u);
  EXPECT_EQ(grid.cells, (std::vector<std::int8_t>{0, 100, kUnknownCell, 0, 100, kUnknownCell}));
}

TEST_F(GridFileTest, ReadsAMapOfMapSaver) {
  folder_.write("m.yaml", kYaml + "\n");
  folder_.write("m.pgm", std::string("P5\n# CREATOR: map_saver.cpp 0.050 m/pix\n2 2\n255\n") +
                             std::string("\xcd\x00\xfe\xfe", 4));
  const auto grid = loadGrid(path("m.yaml"));
  EXPECT_EQ(grid.cells, (std::vector<std::int8_t>{0, 0, kUnknownCell, 100}));
  EXPECT_EQ(grid.origin, Eigen::Vector2d(-1, 2.5));
}

TEST_F(GridFileTest, ReadsANegatedImageAndTheModesOfMapServer) {
  const std::string image = std::string("P5 3 1 255\n") + std::string("\xff\x80\x00", 3);
  folder_.write("m.pgm", image);
  folder_.write("m.yaml", replaced(kYaml, "negate: 0", "negate: 1"));
  EXPECT_EQ(loadGrid(path("m.yaml")).cells, (std::vector<std::int8_t>{100, kUnknownCell, 0}));
  folder_.write("m.yaml", kYaml + "mode: scale\n");  // 1 + 98 (0.498 - 0.196) / (0.65 - 0.196)
  EXPECT_EQ(loadGrid(path("m.yaml")).cells, (std::vector<std::int8_t>{0, 66, 100}));
  folder_.write("m.yaml", kYaml + "mode: raw\n");
  EXPECT_EQ(loadGrid(path("m.yaml")).cells,
            (std::vector<std::int8_t>{kUnknownCell, kUnknownCell, 0}));
}

TEST_F(GridFileTest, RefusesAnImageThatIsMissingCutOffOrNoPgm) {
  const std::string image = "P5\n2 2\n255\nabcd";
  EXPECT_EQ(refusalOf(kYaml, image), "");
  expectContains(refusalOf(kYaml, image.substr(0, image.size() - 1)), "4 pixels and is cut off");
  expectContains(refusalOf(kYaml, image.substr(0, 6)), "has no largest grey value");
  expectContains(refusalOf(kYaml, "P5\n2"), "no height");
  expectContains(refusalOf(kYaml, ""), "no binary PGM");
  expectContains(refusalOf(kYaml, "\x89PNG\r\n"), "no binary PGM");
  expectContains(refusalOf(kYaml, "P5\n2 2\n65535\nabcdefgh"), "must be 255");
  std::filesystem::remove(path("m.pgm"));
  expectContains(refusal(), "m.pgm; does it exist?");
}

TEST_F(GridFileTest, RefusesSizesThatNoMapHas) {
  expectContains(refusalOf(kYaml, "P5\n0 2\n255\n"), "0 x 2, is not that of a map");
  expectContains(refusalOf(kYaml, "P5\n400000 400000\n255\nab"), "is not that of a map");
  expectContains(refusalOf(kYaml, "P5\n99999999999 1\n255\nab"), "no size of an image");
}

TEST_F(GridFileTest, RefusesAYamlFileThatIsMissingOrSaysNothing) {
  expectContains(refusal(), "m.yaml; does it exist?");
  const std::string image = "P5\n2 2\n255\nabcd";
  expectContains(refusalOf("", image), "no map's YAML file");
  expectContains(refusalOf("a: [", image), "cannot use the grid map");
  for (const std::string key : {"image", "resolution", "origin", "negate", "occupied_thresh"})
    expectContains(refusalOf(replaced(kYaml, key, "x" + key), image), "it has no " + key);
}

TEST_F(GridFileTest, RefusesNumbersThatMakeNoMap) {
  const std::string image = "P5\n2 2\n255\nabcd";
  const auto with = [&](const std::string& from, const std::string& to) {
    return refusalOf(replaced(kYaml, from, to), image);
  };
  expectContains(with("resolution: 0.05", "resolution: 0"), "must be more than 0");
  expectContains(with("resolution: 0.05", "resolution: -1"), "must be more than 0");
  expectContains(with("resolution: 0.05", "resolution: .nan"), "not a finite number");
  expectContains(with("resolution: 0.05", "resolution: fine"), "not a finite number");
  expectContains(with("2.5, 0.0]", "2.5, 0.3]"), "rotated by 0.3 rad");
  expectContains(with("2.5, 0.0]", "2.5]"), "[x, y, yaw]");
  expectContains(with("2.5, 0.0]", ".inf, 0.0]"), "origin's y is not a finite number");
  expectContains(with("negate: 0", "negate: maybe"), "neither 0 nor 1");
  expectContains(with("free_thresh: 0.196", "free_thresh: 0.7"), "not less than occupied_thresh");
  expectContains(refusalOf(kYaml + "mode: dots\n", image), "none of trinary");
}

TEST_F(GridFileTest, SavesNoGridWithoutCellsAndTellsWhereItCannotWrite) {
  EXPECT_THROW(saveGrid(path("map.yaml"), OccupancyGrid()), std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(path("map.yaml")));
  EXPECT_THROW(saveGrid(path("nowhere/map.yaml"), savedGrid()), std::runtime_error);
}

}  // namespace
}  // namespace slam::grid_map
