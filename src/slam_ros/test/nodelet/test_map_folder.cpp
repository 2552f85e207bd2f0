// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "slam_ros/map_folder.hpp"

namespace slam_ros {
namespace {

namespace fs = std::filesystem;

class MapFolderTest : public testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::canonical(fs::temp_directory_path()) /
            ("map_folder_test_" + std::to_string(::getpid()));
    fs::create_directories(root_ / "maps" / "office");
    std::ofstream(root_ / "secret") << "x";
    config_.map_folder = root_ / "maps";
  }
  void TearDown() override { fs::remove_all(root_); }

  std::string refusalOf(const std::string& path) const {
    try {
      MapFolder(config_).resolve(path);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  fs::path root_;
  FilesConfig config_;
};

TEST_F(MapFolderTest, TakesWhatIsBelowIt) {
  const MapFolder folder(config_);
  const auto maps = root_ / "maps";
  EXPECT_EQ(folder.resolve("office"), maps / "office");
  EXPECT_EQ(folder.resolve("new/map.yaml"), maps / "new/map.yaml");
  EXPECT_EQ(folder.resolve((maps / "office/../a.yaml").string()), maps / "a.yaml");
  EXPECT_EQ(folder.resolve("."), maps.string());
}

TEST_F(MapFolderTest, TakesANameWithoutAnEndingAsThatOfAYamlFile) {
  const MapFolder folder(config_);
  const auto maps = root_ / "maps";
  EXPECT_EQ(folder.resolveMap("hall"), maps / "hall.yaml");
  EXPECT_EQ(folder.resolveMapForWriting("hall.yaml"), maps / "hall.yaml");
  EXPECT_EQ(folder.resolveMap("office"), maps / "office") << "a folder has that very name";
  EXPECT_EQ(folder.resolveMap("new/"), maps / "new/") << "a folder to be made";
  fs::create_symlink(root_ / "secret", maps / "way_out.yaml");
  EXPECT_THROW(folder.resolveMap("way_out"), std::runtime_error);
}

TEST_F(MapFolderTest, RefusesEachWayOut) {
  fs::create_symlink(root_, root_ / "maps/link");
  fs::create_symlink(root_ / "secret", root_ / "maps/file_link");
  for (const std::string path :
       {"/etc/passwd", "../secret", "office/../../secret", "link/secret", "file_link", "/"}) {
    const auto refusal = refusalOf(path);
    EXPECT_NE(refusal.find(path + " is not below " + config_.map_folder), std::string::npos)
        << path << ": " << refusal;
    EXPECT_NE(refusal.find("map_folder:=FOLDER"), std::string::npos);
  }
  const auto sibling = root_.string() + "/maps_of_others";
  EXPECT_NE(refusalOf(sibling), "") << "whose name only begins alike";
}

TEST_F(MapFolderTest, RefusesPipesAndEmptyNames) {
  ASSERT_EQ(mkfifo((root_ / "maps/pipe").c_str(), 0600), 0);
  EXPECT_NE(refusalOf("pipe").find("is a device or a pipe"), std::string::npos);
  EXPECT_NE(refusalOf("").find("names no file"), std::string::npos);
}

TEST_F(MapFolderTest, TakesAnyPathWhereTheConfigurationSaysSo) {
  config_.unsafe_paths = true;
  EXPECT_EQ(MapFolder(config_).resolve("../secret"), root_ / "secret");
  EXPECT_EQ(MapFolder(config_).resolve("/dev/null"), "/dev/null");
}

TEST_F(MapFolderTest, IsMadeForTheFirstMap) {
  config_.map_folder = root_ / "not/yet";
  EXPECT_EQ(MapFolder(config_).resolveForWriting("a.yaml"), root_ / "not/yet/a.yaml");
  EXPECT_TRUE(fs::is_directory(root_ / "not/yet"));
}

TEST_F(MapFolderTest, IsInRosHomeWithoutAName) {
  const std::string before = std::getenv("ROS_HOME") ? std::getenv("ROS_HOME") : "";
  setenv("ROS_HOME", root_.c_str(), 1);
  EXPECT_EQ(MapFolder().resolve("a.yaml"), root_ / "slam_maps/a.yaml");
  before.empty() ? unsetenv("ROS_HOME") : setenv("ROS_HOME", before.c_str(), 1);
}

}  // namespace
}  // namespace slam_ros
