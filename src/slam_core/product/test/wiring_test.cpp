// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/wiring.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/laser/laser_sweep.hpp"
#include "slam_core/models/laser_scan.hpp"

namespace slam::test {
namespace {

struct Word {
  std::string text;
};

struct Number {
  int value = 0;
};

/// What all components of this test have in common.
class Part : public Component {
 public:
  void configure(Settings&) override {}
  Counters counters() const override { return counters_; }
  void reset() override { counters_.clear(); }

 protected:
  Counters counters_;
};

/// Takes in data of a kind at an input of that name.
template <class T>
class Sink final : public Part {
 public:
  explicit Sink(std::string input, bool is_mandatory = true)
      : input_(std::move(input)), is_mandatory_(is_mandatory) {}

  void describe(Ports& ports) override {
    auto& port = ports.takes<T>(input_, "what comes", [this](const T& v) { got.push_back(v); });
    if (!is_mandatory_) port.optional();
  }
  Status execute() override {
    counters_.add("executed");
    return Status::ok();
  }
  void reset() override {
    Part::reset();
    got.clear();
  }

  std::vector<T> got;

 private:
  std::string input_;
  bool is_mandatory_;
};

/// Makes a word for each count from a number down to one, one with each execute().
class Speaker final : public Part {
 public:
  explicit Speaker(std::string output = "words") : output_(std::move(output)) {}

  void describe(Ports& ports) override {
    ports.takes<Number>("count", "numbers", [this](const Number& number) { left_ = number.value; });
    ports.makes<Word>(output_, word_);
  }
  Status execute() override {
    counters_.add("executed");
    word_.reset();
    if (left_ < 0) return Status::warning("a number below nought says nothing");
    if (left_ > 0) word_ = Word{std::to_string(left_--)};
    return Status::ok();
  }
  bool isBusy() const override { return word_.has_value(); }
  void reset() override {
    Part::reset();
    left_ = 0;
  }

 private:
  std::string output_;
  int left_ = 0;
  std::optional<Word> word_;
};

std::string textOf(const std::vector<Word>& words) {
  std::string text;
  for (const auto& word : words) text += word.text + " ";
  return text;
}

class WiringTest : public testing::Test {
 protected:
  void connect(const std::vector<std::string>& overrides = {}) {
    Settings settings({}, {}, overrides);
    wiring.connect(settings);
  }
  template <class T>
  void put(const std::string& port, const T& value) {
    wiring.put(port, kindOf<T>(), &value);
  }
  /// Of all inputs of that name and kind the one in the list, or null.
  template <class T>
  static const InputPort* find(const std::vector<InputPort>& inputs, const std::string& name) {
    const auto found = std::find_if(inputs.begin(), inputs.end(), [&](const auto& input) {
      return input.name == name && input.kind == kindOf<T>();
    });
    return found == inputs.end() ? nullptr : &*found;
  }

  Wiring wiring;
  Speaker speaker;
  Sink<Word> words{"words"}, more_words{"words", false}, others{"other_words"};
  Sink<Number> numbers{"words"};
};

TEST_F(WiringTest, DataGoToAllWhoTakeThatNameAndKind) {
  for (Component* component :
       {static_cast<Component*>(&words), static_cast<Component*>(&others),
        static_cast<Component*>(&more_words), static_cast<Component*>(&numbers)})
    wiring.add("", *component);
  connect();
  put("words", Word{"yes"});
  EXPECT_EQ(textOf(words.got), "yes ");
  EXPECT_EQ(textOf(more_words.got), "yes ");
  EXPECT_TRUE(others.got.empty()) << "another name";
  EXPECT_TRUE(numbers.got.empty()) << "another kind";
  put("words", Number{3});
  EXPECT_EQ(numbers.got.size(), 1u);
  EXPECT_EQ(words.got.size(), 1u);
  put("nobody", Word{"lost"});
  EXPECT_EQ(words.got.size(), 1u);
}

TEST_F(WiringTest, WhatIsMadeGoesOnUntilTheMakerIsNotBusy) {
  wiring.add("", words);  // the order of components does not matter
  wiring.add("speaker_", speaker);
  wiring.add("", more_words);
  connect();
  put("count", Number{3});
  EXPECT_EQ(textOf(words.got), "3 2 1 ");
  EXPECT_EQ(textOf(more_words.got), "3 2 1 ");
  EXPECT_EQ(wiring.counters()["speaker_executed"], 4u) << "the last one makes nothing";
  EXPECT_EQ(wiring.counters()["executed"], 6u) << "a consumer executes with every value";
}

TEST_F(WiringTest, ListenersHearWhatComponentsMakeAndNotWhatIsPut) {
  wiring.add("", speaker);
  wiring.add("", words);
  connect();
  std::vector<Word> heard;
  const auto listener = [&](const void* value) {
    heard.push_back(*static_cast<const Word*>(value));
    EXPECT_EQ(words.got.size(), heard.size()) << "the consumers have it before";
  };
  wiring.listen("words", kindOf<Word>(), listener);
  put("words", Word{"from outside"});
  EXPECT_TRUE(heard.empty());
  words.got.clear();
  put("count", Number{2});
  EXPECT_EQ(textOf(heard), "2 1 ");
}

TEST_F(WiringTest, ListenersHearWhatNobodyTakes) {
  wiring.add("", speaker);
  connect();
  int heard = 0;
  wiring.listen("words", kindOf<Word>(), [&](const void*) { ++heard; });
  put("count", Number{2});
  EXPECT_EQ(heard, 2);
}

TEST_F(WiringTest, TwoMakersOfOneOutputAreOneSentence) {
  Speaker second, third("other_words");
  wiring.add("", speaker);
  wiring.add("", second);
  wiring.add("", third);
  const auto faults = faultsOf([&] { connect(); });
  EXPECT_EQ(faults.size(), 1u) << join(faults, "\n");
  EXPECT_TRUE(oneSays(faults, {"two components make 'words'", "Word", "leave one"}));
}

TEST_F(WiringTest, WhatNobodyMakesIsOpenAndMandatoryIfAnyoneSaysSo) {
  Sink<Word> optional{"other_words", false}, also_optional{"whispers", false};
  wiring.add("", speaker);
  wiring.add("", words);
  wiring.add("", optional);
  wiring.add("", others);
  wiring.add("", also_optional);
  connect();
  const auto open = wiring.ports().open();
  EXPECT_EQ(open.size(), 3u) << "of the same name and kind one";
  EXPECT_EQ(find<Word>(open, "words"), nullptr) << "the speaker makes them";
  ASSERT_NE(find<Number>(open, "count"), nullptr);
  ASSERT_NE(find<Word>(open, "other_words"), nullptr);
  EXPECT_TRUE(find<Word>(open, "other_words")->is_mandatory);
  ASSERT_NE(find<Word>(open, "whispers"), nullptr);
  EXPECT_FALSE(find<Word>(open, "whispers")->is_mandatory);
  EXPECT_EQ(wiring.ports().inputs().size(), 4u);
  EXPECT_NE(find<Word>(wiring.ports().inputs(), "words"), nullptr);
}

TEST_F(WiringTest, FillsInWhatDataLackBeforeAnyoneGetsThem) {
  wiring = Wiring(Completions().add<Word>([](Word& word) { word.text += "!"; }));
  wiring.add("", speaker);
  wiring.add("", words);
  wiring.add("", more_words);
  connect();
  std::vector<Word> heard;
  wiring.listen("words", kindOf<Word>(),
                [&](const void* value) { heard.push_back(*static_cast<const Word*>(value)); });
  put("count", Number{2});
  const Word own{"put"};
  put("words", own);
  EXPECT_EQ(textOf(words.got), "2! 1! put! ") << "once each";
  EXPECT_EQ(textOf(more_words.got), "2! 1! put! ");
  EXPECT_EQ(textOf(heard), "2! 1! ");
  EXPECT_EQ(own.text, "put");
}

TEST_F(WiringTest, WhoWaitsForRequestsExecutesOnlyThen) {
  wiring.add("", speaker, Wiring::Turn::kOnRequest);
  wiring.add("", words);
  connect();
  put("count", Number{2});
  EXPECT_TRUE(words.got.empty());
  EXPECT_TRUE(wiring.step().isOk());
  EXPECT_EQ(textOf(words.got), "2 ") << "one execute(), although it is busy";
  wiring.step();
  wiring.step();
  EXPECT_EQ(textOf(words.got), "2 1 ");
  put("count", Number{-1});
  EXPECT_TRUE(oneSays({wiring.step().message}, {"below nought"}));
}

TEST_F(WiringTest, TellsOnceTheLastWarningOfThoseThatTakeTheirTurnAtOnce) {
  wiring.add("", speaker);
  connect();
  put("count", Number{-1});
  put("count", Number{1});
  EXPECT_TRUE(oneSays({wiring.step().message}, {"below nought"}));
  EXPECT_TRUE(wiring.step().isOk());
}

TEST_F(WiringTest, ResetsAllComponentsAndForgetsWhatWasWrong) {
  wiring.add("", speaker);
  wiring.add("words_", words);
  connect();
  put("count", Number{2});
  put("count", Number{-1});
  wiring.reset();
  EXPECT_TRUE(wiring.counters().all().empty());
  EXPECT_TRUE(words.got.empty());
  EXPECT_TRUE(wiring.step().isOk());
  put("count", Number{1});
  EXPECT_EQ(textOf(words.got), "1 ") << "it stays wired";
}

LaserSweep sweepAt(int second) {
  LaserSweep sweep;
  sweep.stamp = Stamp(std::chrono::seconds(second));
  sweep.frame = "laser";
  sweep.angle_increment = 0.1f;
  sweep.angle_max = 0.2f;
  sweep.range_max = 8.0f;
  sweep.ranges = {1.0f, 2.0f, 3.0f};
  return sweep;
}

class WiringGateTest : public WiringTest {
 protected:
  Sink<LaserScan> scans{"scan"}, more_scans{"scan", false};
};

TEST_F(WiringGateTest, AGateStandsOnceBeforeAllWhoNeedIt) {
  wiring.add("", scans);
  wiring.add("", more_scans);
  connect();
  const auto open = wiring.ports().open();
  EXPECT_EQ(open.size(), 2u);
  EXPECT_EQ(find<LaserScan>(open, "scan"), nullptr) << "the gate makes them";
  ASSERT_NE(find<LaserSweep>(open, "scan"), nullptr);
  EXPECT_TRUE(find<LaserSweep>(open, "scan")->is_mandatory);
  EXPECT_NE(find<LaserMount>(open, "scan"), nullptr);
  put("scan", sweepAt(1));
  put("scan", sweepAt(2));
  EXPECT_EQ(heldAtGates(wiring)["laser_no_mount"], 2u) << "of one gate";
  EXPECT_TRUE(scans.got.empty());
  put("scan", LaserMount{"laser", Eigen::Isometry3d::Identity()});
  EXPECT_EQ(heldAtGates(wiring)["laser_no_mount"], 0u);
  ASSERT_EQ(scans.got.size(), 2u);
  EXPECT_EQ(more_scans.got.size(), 2u);
  EXPECT_EQ(scans.got[1].sequence, 1u) << "they went through one gate, once";
  EXPECT_EQ(scans.got[1].beams.size(), 3u);
}

TEST_F(WiringGateTest, AGateIsConfiguredAndItsCountersHaveItsName) {
  wiring.add("", scans);
  connect({"laser.sensor_pose=[1, 0, 0, 0, 0, 0]"});
  auto bad = sweepAt(1);
  bad.angle_increment = -0.1f;  // leads away from angle_max
  put("scan", bad);
  EXPECT_EQ(wiring.counters()["laser_bad_scan"], 1u);
  EXPECT_TRUE(oneSays({wiring.step().message}, {"a scan cannot be used"}));
  put("scan", sweepAt(2));
  ASSERT_EQ(scans.got.size(), 2u);
  EXPECT_EQ(scans.got[1].sensor_pose.x(), 1.0);
}

TEST_F(WiringGateTest, WhatIsWrongInTheGatesSectionIsAFault) {
  wiring.add("", scans);
  EXPECT_TRUE(
      oneSays(faultsOf([&] { connect({"laser.range_max=-1"}); }), {"laser.range_max", ">= 0"}));
}

TEST_F(WiringGateTest, ScansFromOutsideGoPastTheGate) {
  wiring.add("", scans);
  connect();
  put("scan", LaserScan());
  EXPECT_EQ(scans.got.size(), 1u);
}

/// Makes scans itself: no gate is needed.
class ScanMaker final : public Part {
 public:
  void describe(Ports& ports) override {
    ports.takes<Number>("count", "numbers", [](const Number&) {});
    ports.makes<LaserScan>("scan", scan_);
  }
  Status execute() override { return Status::ok(); }

 private:
  std::optional<LaserScan> scan_;
};

TEST_F(WiringGateTest, NoGateStandsWhereAComponentMakesTheData) {
  ScanMaker maker;
  wiring.add("", scans);
  wiring.add("", maker);
  connect();
  EXPECT_EQ(find<LaserSweep>(wiring.ports().open(), "scan"), nullptr);
  EXPECT_EQ(wiring.ports().open().size(), 1u);
}

}  // namespace
}  // namespace slam::test
