// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "slam_core/common/nearest_name.hpp"
#include "slam_core/common/settings.hpp"
#include "slam_core/common/test/faults.hpp"
#include "slam_core/common/test/temporary_folder.hpp"

namespace slam {
namespace {

using test::faultsOf;
using test::oneSays;
using test::TemporaryFolder;

TEST(ConfigFile, KeepsItsNameForMessages) {
  const TemporaryFolder folder;
  const auto path = folder.write("robot.yaml", "version: 1\n");
  const auto document = loadConfigFile(path);
  EXPECT_EQ(document.name, path);
  EXPECT_EQ(document.root["version"].as<int>(), 1);
}

TEST(ConfigFile, SaysWhichFileIsMissing) {
  const TemporaryFolder folder;
  const auto path = folder / "nowhere.yaml";
  EXPECT_TRUE(oneSays(faultsOf([&] { loadConfigFile(path); }), {path.c_str(), "exist"}));
}

TEST(ConfigFile, DoesNotReadAFolder) {
  const TemporaryFolder folder;
  EXPECT_TRUE(oneSays(faultsOf([&] { loadConfigFile(folder / ""); }), {"is a folder"}));
}

TEST(ConfigFile, DoesNotTakeAnEmptyFileForDefaults) {
  const TemporaryFolder folder;
  const auto path = folder.write("robot.yaml", "# nothing\n");
  EXPECT_TRUE(oneSays(faultsOf([&] { loadConfigFile(path); }), {path.c_str(), "is empty"}));
}

TEST(ConfigFile, SaysWhereTheYamlIsBroken) {
  const TemporaryFolder folder;
  const auto path = folder.write("product.yaml", "version: 1\nekf: {gate: [1, 2\n");
  const auto faults = faultsOf([&] { loadConfigFile(path); });
  EXPECT_TRUE(oneSays(faults, {path.c_str(), "not YAML", "line 3"}));
}

TEST(NearestName, FindsATypoAndNothingForAStranger) {
  const std::vector<std::string> names = {"gate_probability", "mode", "linearization"};
  EXPECT_EQ(nearestName("gate_probabilty", names), "gate_probability");
  EXPECT_EQ(nearestName("linearisation", names), "linearization");
  EXPECT_EQ(nearestName("mdoe", names), "mode");
  EXPECT_EQ(nearestName("wheel_radius", names), "");
  EXPECT_EQ(nearestName("", names), "");
}

}  // namespace
}  // namespace slam
