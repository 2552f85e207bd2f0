// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/yaml_file.hpp"

#include <gtest/gtest.h>

#include "slam_core/common/settings.hpp"
#include "slam_core/common/test/faults.hpp"
#include "slam_core/common/test/temporary_folder.hpp"

namespace slam {
namespace {

using test::faultsOf;
using test::oneSays;
using test::sentenceOf;
using test::TemporaryFolder;

constexpr YamlLimits kYamlLimits = YamlLimits::configuration();

struct ListConfig {
  static constexpr const char* kSection = "s";
  std::vector<double> list;
  void describe(Fields& fields) { fields.add("list", &list, "numbers"); }
};

/// Lists of aliases to lists of aliases: ten times as many values with each line.
std::string bomb(int lines) {
  std::string text = "version: 1\na0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < lines; ++i) {
    const auto alias = "*a" + std::to_string(i - 1);
    text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + alias;
    for (int k = 1; k < 10; ++k) text += ", " + alias;
    text += "]\n";
  }
  return text;
}

std::string faultOf(const std::string& text, const YamlLimits& limits = kYamlLimits) {
  return sentenceOf([&] { parseYaml(text, limits); });
}

TEST(YamlFile, HasAliasesThatStandForWhatTheyReferTo) {
  const auto root = parseYaml("noise: &n [1, 2]\nother: *n\n", kYamlLimits);
  EXPECT_EQ(root["other"][1].as<int>(), 2);
  EXPECT_EQ(faultOf(bomb(4)), "");
}

TEST(YamlFile, OfAliasesToAliasesIsRefusedBeforeItIsWalkedThrough) {
  EXPECT_TRUE(oneSays({faultOf(bomb(12))}, {"more than 200000 values", "line 7"}));
  const TemporaryFolder folder;
  const auto path = folder.write("robot.yaml", bomb(30));
  EXPECT_TRUE(oneSays(faultsOf([&] { loadConfigFile(path); }), {path.c_str(), "more than 200000"}));
}

TEST(YamlFile, WithAnAliasWithinWhatItRefersToIsRefused) {
  const TemporaryFolder folder;
  for (const auto* text : {"version: 1\nekf: &a {b: *a}\n", "&a [1, [*a]]\n", "&a {*a : 1}\n"}) {
    EXPECT_TRUE(oneSays({faultOf(text)}, {"stands within what it refers to", "line"})) << text;
    const auto path = folder.write("robot.yaml", text);
    EXPECT_TRUE(oneSays(faultsOf([&] { loadConfigFile(path); }), {path.c_str(), "within"}));
  }
}

TEST(YamlFile, OfAnOverrideIsBoundedAsWell) {
  Settings settings({}, {}, {"s.list=&a [*a]"});
  EXPECT_TRUE(oneSays(faultsOf([&] { settings.read<ListConfig>(); }), {"s.list", "not of type"}));
}

TEST(YamlFile, NestedTooDeepIsRefused) {
  const auto nested = [](std::size_t depth) {
    return std::string(depth, '[') + std::string(depth, ']');
  };
  EXPECT_EQ(faultOf(nested(kYamlLimits.depth)), "");
  EXPECT_TRUE(oneSays({faultOf(nested(kYamlLimits.depth + 1))}, {"nested more than 32 deep"}));
  EXPECT_TRUE(oneSays({faultOf(nested(1'000'000))}, {"nested more than 32 deep"}));
}

TEST(YamlFile, OfALargeMapIsBoundedToo) {
  constexpr auto kMap = YamlLimits::map();
  std::string numbers = "[0";
  while (numbers.size() < kYamlLimits.bytes + 100) numbers += ", 0.125";
  EXPECT_TRUE(oneSays({faultOf("a: &a [*a]\nrows: " + numbers + "]\n", kMap)}, {"within"}));
  EXPECT_NE(faultOf(std::string(5 << 20, '[') + std::string(5 << 20, ']'), kMap), "");
}

TEST(YamlFile, LargerThanAllowedIsNotRead) {
  const TemporaryFolder folder;
  const auto path = folder.write("robot.yaml", "a: " + std::string(5 << 20, 'x'));
  EXPECT_TRUE(
      oneSays(faultsOf([&] { loadConfigFile(path); }), {path.c_str(), "more than 4194304"}));
}

}  // namespace
}  // namespace slam
