// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bag_maker.hpp"
#include "slam_ros/run_origin.hpp"

namespace slam_ros {
namespace {

constexpr const char* kOrigin =
    R"({"version": "0.1 \"a\": b", "command": "./slam run x --bag 'a \"b\": c.bag'",)"
    R"( "bag": {"name": "ü.bag", "bytes": 12}})";

TEST(RunOrigin, StandsInBothFilesOfARun) {
  test::Folder folder;
  folder.write("metrics.json", R"({"updates": 3})");
  folder.write("config.yaml", "version: 1\nseed: 1\n");
  RunOrigin(kOrigin).addToFolder(folder / "");
  const auto metrics = nlohmann::json::parse(folder.read("metrics.json"));
  EXPECT_EQ(metrics["updates"], 3);
  EXPECT_EQ(metrics["run"], nlohmann::json::parse(kOrigin));
  const auto config = YAML::Load(folder.read("config.yaml"));
  EXPECT_EQ(config["seed"].as<int>(), 1);
  EXPECT_FALSE(config["run"]["command"].IsDefined()) << "it differs from one run to the same again";
  EXPECT_EQ(config["run"]["version"].as<std::string>(), "0.1 \"a\": b");
  EXPECT_EQ(config["run"]["bag"]["name"].as<std::string>(), "ü.bag");
  EXPECT_EQ(config["run"]["bag"]["bytes"].as<int>(), 12);
}

TEST(RunOrigin, ChangesNothingWhereItIsNotKnown) {
  EXPECT_EQ(RunOrigin().addedToMetrics("{}"), "{}");
  EXPECT_EQ(RunOrigin().addedToConfig("seed: 1\n"), "seed: 1\n");
}

TEST(RunOrigin, RefusesWhatIsNoObject) {
  EXPECT_THROW(RunOrigin("[1]"), std::invalid_argument);
  EXPECT_THROW(RunOrigin("{"), std::invalid_argument);
}

}  // namespace
}  // namespace slam_ros
