// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/common/settings.hpp"

#include <gtest/gtest.h>

#include "slam_core/common/test/faults.hpp"

namespace slam {
namespace {

using test::faultsOf;
using test::oneSays;

struct ExampleConfig {
  static constexpr const char* kSection = "example";

  double gain = 2.5;
  double share = 0.5;
  int count = 3;
  bool active = false;
  std::uint64_t seed = 7;
  std::string kind = "fast";
  std::vector<std::string> names = {"a"};
  double wheel_radius = 0.1;

  void describe(Fields& fields) {
    fields.add("gain", &gain, "a gain").in(Range::above(0));
    fields.add("share", &share, "a share").in(Range::closed(0, 1));
    fields.add("count", &count, "a count").in(Range::atLeast(1));
    fields.add("active", &active, "a switch");
    fields.add("seed", &seed, "a seed");
    fields.add("kind", &kind, "a choice").oneOf({"fast", "exact"});
    fields.add("names", &names, "some names");
    fields.add("wheel_radius", &wheel_radius, "a length").unit("m").in(Range::above(0)).ofRobot();
  }
};

Settings settingsOf(const std::string& product, const std::string& robot = "",
                    const std::vector<std::string>& overrides = {}) {
  return Settings({"product.yaml", YAML::Load(product)}, {"robot.yaml", YAML::Load(robot)},
                  overrides);
}

std::vector<std::string> faultsOfExample(const std::string& product, const std::string& robot = "",
                                         const std::vector<std::string>& overrides = {}) {
  return faultsOf([&] {
    auto settings = settingsOf(product, robot, overrides);
    settings.read<ExampleConfig>();
    settings.requireAllRead();
  });
}

TEST(Settings, TellTheUnitOfARange) {
  EXPECT_TRUE(oneSays(faultsOfExample("", "{version: 1, example: {wheel_radius: -1}}"),
                      {"example.wheel_radius", "-1 is not allowed; the range is > 0, in m"}));
  double drift = -4;
  Fields fields;
  fields.add("drift", &drift, "a drift").unit("m^2/m; squared: 1").in(Range::atLeast(0));
  EXPECT_EQ(fields.find("drift")->fault(), "-4 is not allowed; the range is >= 0, in m^2/m");
  const auto faults = faultsOfExample("{version: 1, example: {gain: -1}}");
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].substr(faults[0].size() - 16), "the range is > 0");
}

TEST(Settings, ReadEveryTypeOfField) {
  auto settings = settingsOf(
      "{version: 1, example: {gain: 1e-3, count: 12, active: true, seed: 18446744073709551615, "
      "kind: exact, names: [x, y]}}",
      "{version: 1, example: {wheel_radius: 0.25}}");
  const auto config = settings.read<ExampleConfig>();
  EXPECT_EQ(config.gain, 1e-3);
  EXPECT_EQ(config.count, 12);
  EXPECT_TRUE(config.active);
  EXPECT_EQ(config.seed, 18446744073709551615u);
  EXPECT_EQ(config.kind, "exact");
  EXPECT_EQ(config.names, (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(config.wheel_radius, 0.25);
  EXPECT_EQ(config.share, 0.5) << "a field that is not given keeps its default";
}

TEST(Settings, KeepTheDefaultsWithoutAnyFile) {
  EXPECT_EQ(Settings().read<ExampleConfig>().gain, 2.5);
}

TEST(Settings, ListAllFaultsAtOnce) {
  const auto faults = faultsOfExample(
      "version: 1\nexample:\n  gian: 1\n  share: 1.5\n  count: many\n  wheel_radius: 0.2\n",
      "{version: 1, example: {wheel_radius: -1, kind: exact}}", {"example.seed=-4"});
  EXPECT_EQ(faults.size(), 7u);
  EXPECT_TRUE(oneSays(faults, {"example.gian", "product.yaml:3", "unknown", "'gain'"}));
  EXPECT_TRUE(oneSays(faults, {"example.share", "product.yaml:4", "1.5", "[0, 1]"}));
  EXPECT_TRUE(oneSays(faults, {"example.count", "'many'", "integer"}));
  EXPECT_TRUE(oneSays(faults, {"example.wheel_radius", "product.yaml", "belongs in the robot"}));
  EXPECT_TRUE(oneSays(faults, {"example.wheel_radius", "robot.yaml", "-1", "> 0"}));
  EXPECT_TRUE(oneSays(faults, {"example.kind", "robot.yaml", "belongs in the product"}));
  EXPECT_TRUE(oneSays(faults, {"override example.seed", "'-4'", "non-negative integer"}));
}

TEST(Settings, RefuseEachWrongType) {
  EXPECT_TRUE(
      oneSays(faultsOfExample("{version: 1, example: {gain: wide}}"), {"'wide'", "number"}));
  EXPECT_TRUE(oneSays(faultsOfExample("{version: 1, example: {gain: [1]}}"), {"list", "number"}));
  EXPECT_TRUE(oneSays(faultsOfExample("{version: 1, example: {gain: }}"), {"nothing", "number"}));
  EXPECT_TRUE(oneSays(faultsOfExample("{version: 1, example: {count: 2.5}}"), {"2.5", "integer"}));
  EXPECT_TRUE(oneSays(faultsOfExample("{version: 1, example: {active: 2}}"), {"'2'", "bool"}));
  EXPECT_TRUE(oneSays(faultsOfExample("{version: 1, example: {names: x}}"), {"'x'", "list"}));
}

TEST(Settings, RefuseNumbersThatAreNotFinite) {
  EXPECT_TRUE(oneSays(faultsOfExample("{version: 1, example: {gain: .nan}}"), {"nan", "> 0"}));
  EXPECT_TRUE(oneSays(faultsOfExample("{version: 1, example: {gain: .inf}}"), {"inf", "> 0"}));
}

TEST(Settings, AllowTheClosedEndOfARangeAndRefuseTheOpenOne) {
  EXPECT_TRUE(faultsOfExample("{version: 1, example: {share: 1, count: 1}}").empty());
  EXPECT_TRUE(oneSays(faultsOfExample("{version: 1, example: {gain: 0}}"), {"0", "> 0"}));
}

TEST(Settings, NameTheNearestChoice) {
  EXPECT_TRUE(oneSays(faultsOfExample("{version: 1, example: {kind: exakt}}"),
                      {"'exakt'", "fast, exact", "did you mean 'exact'"}));
}

TEST(Settings, LetAnOverrideWin) {
  auto settings =
      settingsOf("{version: 1, example: {gain: 1}}", "{version: 1, example: {wheel_radius: 1}}",
                 {"example.gain=4", "example.wheel_radius=0.5"});
  const auto config = settings.read<ExampleConfig>();
  EXPECT_EQ(config.gain, 4);
  EXPECT_EQ(config.wheel_radius, 0.5);
}

TEST(Settings, RefuseOverridesThatNameNothing) {
  EXPECT_TRUE(oneSays(faultsOfExample("", "", {"example.gian=1"}), {"example.gian", "'gain'"}));
  EXPECT_TRUE(oneSays(faultsOfExample("", "", {"exmaple.gain=1"}), {"exmaple.gain", "'example'"}));
  EXPECT_TRUE(oneSays(faultsOfExample("", "", {"example.gain"}), {"section.key=value"}));
  EXPECT_TRUE(oneSays(faultsOfExample("", "", {"=3"}), {"section.key=value"}));
}

TEST(Settings, RefuseAnotherVersionAndNone) {
  EXPECT_TRUE(oneSays(faultsOfExample("{version: 2}"), {"product.yaml", "'2'", "reads version 1"}));
  EXPECT_TRUE(oneSays(faultsOfExample("{example: {}}"), {"product.yaml", "no version"}));
  const auto both = faultsOfExample("{version: 2}", "{version: one}");
  EXPECT_EQ(both.size(), 2u);
  EXPECT_TRUE(oneSays(both, {"robot.yaml", "'one'"}));
}

TEST(Settings, RefuseADocumentOrSectionThatIsNoMap) {
  EXPECT_TRUE(oneSays(faultsOfExample("[1, 2]"), {"product.yaml", "not a map"}));
  EXPECT_TRUE(oneSays(faultsOfExample("{version: 1, example: 5}"), {"example", "not a map"}));
}

TEST(Settings, RefuseAKeyThatStandsThereTwice) {
  EXPECT_TRUE(oneSays(faultsOfExample("version: 1\nexample: {gain: 1}\nexample: {gain: 2}\n"),
                      {"example in product.yaml:3", "second time"}));
  const auto inside =
      faultsOfExample("version: 1\nexample:\n  gain: 1\n  gain: 1\n", "{version: 1}");
  EXPECT_EQ(inside.size(), 1u);
  EXPECT_TRUE(oneSays(inside, {"example.gain in product.yaml:4", "second time"}));
  EXPECT_TRUE(oneSays(faultsOfExample("", "{version: 1, version: 1}"), {"version in robot.yaml"}));
}

TEST(Settings, FindSectionsThatNobodyReads) {
  const auto faults =
      faultsOfExample("version: 1\nexampel: {gain: 1}\n", "{version: 1, wings: {span: 2}}");
  EXPECT_EQ(faults.size(), 2u);
  EXPECT_TRUE(oneSays(faults, {"section exampel", "product.yaml:2", "did you mean 'example'"}));
  EXPECT_TRUE(oneSays(faults, {"section wings", "robot.yaml"}));
}

TEST(Settings, TellTheValuesInForceSoThatTheyReadBack) {
  auto settings = settingsOf("{version: 1, example: {gain: 0.1, names: [x, y], kind: exact}}", "",
                             {"example.count=9"});
  settings.read<ExampleConfig>();
  settings.read<ExampleConfig>();  // twice read, once told
  const auto values = YAML::Load(settings.inForce())["example"];
  EXPECT_EQ(values.size(), 8u);
  EXPECT_EQ(values["gain"].as<double>(), 0.1);
  EXPECT_EQ(values["count"].as<int>(), 9);
  EXPECT_EQ(values["kind"].as<std::string>(), "exact");
  EXPECT_EQ(values["names"].as<std::vector<std::string>>(), (std::vector<std::string>{"x", "y"}));
}

struct NoteConfig {
  static constexpr const char* kSection = "note";
  std::string text = "a \"quoted\" word: \\ # and\na second line";
  void describe(Fields& fields) { fields.add("text", &text, "any text"); }
};

TEST(Settings, TellTextsInForceWhateverTheyHold) {
  auto settings = settingsOf("version: 1");
  settings.read<NoteConfig>();
  EXPECT_EQ(YAML::Load(settings.inForce())["note"]["text"].as<std::string>(), NoteConfig().text);
}

enum class Shade { kLight, kDark };

struct ShadeConfig {
  static constexpr const char* kSection = "shades";
  Shade wall = Shade::kLight, floor = Shade::kDark;

  void describe(Fields& fields) {
    const Names<Shade> names = {{"light", Shade::kLight}, {"dark", Shade::kDark}};
    fields.add("wall", &wall, names, "an enumeration");
    fields.add("floor", &floor, names, "another one");
  }
};

TEST(Settings, ReadAnEnumerationByTheNamesOfItsValues) {
  auto settings = settingsOf("{version: 1, shades: {wall: dark}}", "", {"shades.floor=light"});
  const auto config = settings.read<ShadeConfig>();
  EXPECT_EQ(config.wall, Shade::kDark);
  EXPECT_EQ(config.floor, Shade::kLight);
  auto again = settingsOf("version: 1\n" + settings.inForce());
  EXPECT_EQ(again.read<ShadeConfig>().wall, Shade::kDark);
}

TEST(Settings, RefuseWhatIsNoNameOfAnEnumeration) {
  const auto faultsOfShades = [](const std::string& values) {
    return faultsOf(
        [&] { settingsOf("{version: 1, shades: {" + values + "}}").read<ShadeConfig>(); });
  };
  EXPECT_TRUE(oneSays(faultsOfShades("wall: drk"),
                      {"shades.wall", "'drk' is not one of: light, dark", "did you mean 'dark'"}));
  EXPECT_TRUE(oneSays(faultsOfShades("floor: [dark]"), {"shades.floor", "is not of type text"}));
  EXPECT_TRUE(oneSays(faultsOfShades("floor: ''"), {"shades.floor", "'' is not one of"}));
}

std::string faultOfColour(const std::string& value) {
  return value == "red" ? "" : "'" + value + "' is not red; write red";
}

struct ColourConfig {
  static constexpr const char* kSection = "colours";
  std::string wall = "red";
  std::vector<std::string> others;

  void describe(Fields& fields) {
    fields.add("wall", &wall, "a text with a check of its own").checkedBy(faultOfColour);
    fields.add("others", &others, "several").checkedBy(faultOfColour);
  }
};

TEST(Settings, RefuseTextsByTheCheckOfTheirField) {
  const auto faultsOfColours = [](const std::string& values) {
    return faultsOf(
        [&] { settingsOf("{version: 1, colours: {" + values + "}}").read<ColourConfig>(); });
  };
  EXPECT_TRUE(faultsOfColours("wall: red, others: [red]").empty());
  EXPECT_TRUE(oneSays(faultsOfColours("wall: ''"), {"colours.wall", "'' is not red; write red"}));
  EXPECT_TRUE(oneSays(faultsOfColours("others: [red, blue]"), {"colours.others", "'blue' is not"}));
}

TEST(Settings, DescribeAnEnumerationAsATextWithChoices) {
  ShadeConfig config;
  Fields fields;
  config.describe(fields);
  const auto& field = *fields.find("floor");
  EXPECT_EQ(field.typeName(), "text");
  EXPECT_EQ(field.valueText(), "dark");
  EXPECT_EQ(field.choices, (std::vector<std::string>{"light", "dark"}));
  EXPECT_TRUE(field.isText());
  EXPECT_FALSE(field.isListOrMap());
  EXPECT_EQ(field.fault(), "");
}

struct ListsConfig {
  static constexpr const char* kSection = "lists";
  std::vector<double> pose;
  std::vector<std::int64_t> ids = {3};
  std::vector<std::string> kinds;
  std::map<std::int64_t, double> sizes;
  std::map<std::string, std::int64_t> offsets = {{"36h11", 7}};

  void describe(Fields& fields) {
    fields.add("pose", &pose, "numbers");
    fields.add("ids", &ids, "integers").in(Range::atLeast(0));
    fields.add("kinds", &kinds, "choices").oneOf({"red", "green"});
    fields.add("sizes", &sizes, "numbers by id").in(Range::above(0));
    fields.add("offsets", &offsets, "integers by name");
  }
};

std::vector<std::string> faultsOfLists(const std::string& section) {
  return faultsOf(
      [&] { settingsOf("{version: 1, lists: {" + section + "}}").read<ListsConfig>(); });
}

TEST(Settings, ReadListsAndMaps) {
  auto settings = settingsOf(
      "{version: 1, lists: {pose: [1, -2.5, 3e-1], ids: [], sizes: {5: 0.2, '12': 1}, "
      "offsets: {25h9: 1000}}}",
      "", {"lists.kinds=[green, red]", "lists.ids=[4, 5]"});
  const auto config = settings.read<ListsConfig>();
  EXPECT_EQ(config.pose, (std::vector<double>{1, -2.5, 0.3}));
  EXPECT_EQ(config.ids, (std::vector<std::int64_t>{4, 5}));
  EXPECT_EQ(config.kinds, (std::vector<std::string>{"green", "red"}));
  EXPECT_EQ(config.sizes, (std::map<std::int64_t, double>{{5, 0.2}, {12, 1.0}}));
  EXPECT_EQ(config.offsets, (std::map<std::string, std::int64_t>{{"25h9", 1000}}));
}

TEST(Settings, HoldEveryValueOfAListOrMapAgainstTheRange) {
  EXPECT_TRUE(oneSays(faultsOfLists("ids: [1, -1]"), {"lists.ids", "-1", ">= 0"}));
  EXPECT_TRUE(oneSays(faultsOfLists("sizes: {5: 0.1, 6: 0}"), {"lists.sizes", "6: 0", "> 0"}));
  EXPECT_TRUE(oneSays(faultsOfLists("kinds: [red, gren]"), {"'gren'", "did you mean 'green'"}));
  EXPECT_TRUE(oneSays(faultsOfLists("pose: [1, .nan]"), {"nan"}));
}

TEST(Settings, RefuseListsAndMapsOfTheWrongType) {
  EXPECT_TRUE(oneSays(faultsOfLists("pose: 3"), {"'3'", "list of numbers"}));
  EXPECT_TRUE(oneSays(faultsOfLists("pose: [a]"), {"list of numbers"}));
  EXPECT_TRUE(oneSays(faultsOfLists("ids: [1.5]"), {"list of integers"}));
  EXPECT_TRUE(oneSays(faultsOfLists("kinds: [[red]]"), {"list of texts"}));
  EXPECT_TRUE(oneSays(faultsOfLists("sizes: {a: 1}"), {"map of integers to numbers"}));
  EXPECT_TRUE(oneSays(faultsOfLists("sizes: [1]"), {"map of integers to numbers"}));
  EXPECT_TRUE(oneSays(faultsOfLists("offsets: {a: b}"), {"map of texts to integers"}));
  EXPECT_TRUE(
      oneSays(faultsOf([] { settingsOf("", "", {"lists.sizes={5: "}).read<ListsConfig>(); }),
              {"override lists.sizes", "map of integers to numbers"}));
}

TEST(Settings, TellListsAndMapsInForceSoThatTheyReadBack) {
  const std::string values =
      "{version: 1, lists: {pose: [0.1, 1e-9], ids: [1, 2], kinds: [red], sizes: {5: 0.2}}}";
  auto settings = settingsOf(values);
  settings.read<ListsConfig>();
  auto again = settingsOf("version: 1\n" + settings.inForce());
  const auto config = again.read<ListsConfig>();
  EXPECT_EQ(config.pose, (std::vector<double>{0.1, 1e-9}));
  EXPECT_EQ(config.ids, (std::vector<std::int64_t>{1, 2}));
  EXPECT_EQ(config.kinds, (std::vector<std::string>{"red"}));
  EXPECT_EQ(config.sizes, (std::map<std::int64_t, double>{{5, 0.2}}));
  EXPECT_EQ(config.offsets, (std::map<std::string, std::int64_t>{{"36h11", 7}}));
}

TEST(Settings, ValidateAStructThatCameFromCode) {
  ExampleConfig config;
  EXPECT_TRUE(faultsOf([&] { validate(config); }).empty());
  config.gain = -1;
  config.kind = "slow";
  const auto faults = faultsOf([&] { validate(config); });
  EXPECT_EQ(faults.size(), 2u);
  EXPECT_TRUE(oneSays(faults, {"example.gain", "-1"}));
  EXPECT_TRUE(oneSays(faults, {"example.kind", "'slow'"}));
}

}  // namespace
}  // namespace slam
