// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/wired_ports.hpp"

#include <gtest/gtest.h>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/product/data_flow.hpp"
#include "slam_core/product/wiring.hpp"

namespace slam::test {

struct Ore {
  int weight = 0;
};
struct Metal {
  int weight = 0;
};
struct Slag {
  int weight = 0;
};
struct Tool {
  int weight = 0;
};

namespace {

/// What all components of this test have in common.
template <class Role>
class Plain : public Role {
 public:
  void configure(Settings&) override {}
  Counters counters() const override { return counters_; }
  void reset() override {}

 protected:
  Counters counters_;
};

/// Makes two kinds of data of one.
class Smelter final : public Plain<Gate> {
 public:
  std::string name() const override { return "smelter"; }
  void describe(Ports& ports) override {
    ports.takes<Ore>("mine", "ore", [this](const Ore& ore) { ore_ = ore; });
    ports.makes<Metal>("metal", metal_);
    ports.makes<Slag>("slag", slag_);
  }
  Status execute() override {
    counters_.add("executed");
    metal_ = Metal{ore_.weight / 2};
    slag_ = Slag{ore_.weight - ore_.weight / 2};
    return Status::ok();
  }

 private:
  Ore ore_;
  std::optional<Metal> metal_;
  std::optional<Slag> slag_;
};

/// Needs what another gate makes.
class Forge final : public Plain<Gate> {
 public:
  std::string name() const override { return "forge"; }
  void describe(Ports& ports) override {
    ports.takes<Metal>("metal", "metal",
                       [this](const Metal& metal) { tool_ = Tool{metal.weight}; });
    ports.makes<Tool>("tool", tool_);
  }
  Status execute() override { return Status::ok(); }

 private:
  std::optional<Tool> tool_;
};

/// Needs what it makes.
class Recycler final : public Plain<Gate> {
 public:
  std::string name() const override { return "recycler"; }
  void describe(Ports& ports) override {
    ports.takes<Slag>("waste", "slag", [](const Slag&) {});
    ports.makes<Slag>("waste", slag_);
  }
  Status execute() override { return Status::ok(); }

 private:
  std::optional<Slag> slag_;
};

const GateRegistrar<Smelter> kSmelter("smelter");
const GateRegistrar<Forge> kForge("forge");
const GateRegistrar<Recycler> kRecycler("recycler");

/// Takes data of one kind at one port.
template <class T>
class Buyer final : public Plain<Component> {
 public:
  explicit Buyer(std::string input) : input_(std::move(input)) {}

  void describe(Ports& ports) override {
    ports.takes<T>(input_, "goods", [this](const T& value) { bought.push_back(value.weight); });
  }
  Status execute() override { return Status::ok(); }

  std::vector<int> bought;

 private:
  std::string input_;
};

/// Takes ore at one port and makes ore at another.
class Carter final : public Plain<Component> {
 public:
  Carter(std::string from, std::string to) : from_(std::move(from)), to_(std::move(to)) {}

  void describe(Ports& ports) override {
    ports.takes<Ore>(from_, "ore", [this](const Ore& ore) { load_ = ore; });
    ports.makes<Ore>(to_, load_);
  }
  Status execute() override { return Status::ok(); }

 private:
  std::string from_, to_;
  std::optional<Ore> load_;
};

std::vector<std::string> namesOf(const std::vector<InputPort>& inputs) {
  std::vector<std::string> names;
  for (const auto& input : inputs) names.push_back(input.name);
  return names;
}

using NamesOfPorts = std::vector<std::string>;

TEST(WiredPorts, AGateThatNeedsAGateGetsIt) {
  Buyer<Tool> buyer("tool");
  Wiring wiring;
  wiring.add("", buyer);
  Settings settings;
  wiring.connect(settings);
  EXPECT_EQ(wiring.gates().size(), 2u);
  EXPECT_EQ(namesOf(wiring.ports().open()), NamesOfPorts{"mine"});
  const Ore ore{10};
  wiring.put("mine", kindOf<Ore>(), &ore);
  EXPECT_EQ(buyer.bought, std::vector<int>{5}) << "it went through both";
}

TEST(WiredPorts, AGateWithTwoOutputsStandsOnce) {
  Buyer<Metal> metal("metal");
  Buyer<Slag> slag("slag");
  Wiring wiring;
  wiring.add("", metal);
  wiring.add("", slag);
  Settings settings;
  wiring.connect(settings);
  EXPECT_EQ(wiring.gates().size(), 1u);
  const Ore ore{5};
  wiring.put("mine", kindOf<Ore>(), &ore);
  EXPECT_EQ(wiring.counters()["smelter_executed"], 1u);
  EXPECT_EQ(metal.bought, std::vector<int>{2});
  EXPECT_EQ(slag.bought, std::vector<int>{3});
}

TEST(WiredPorts, TellWhoMakesWhatForEveryInput) {
  Buyer<Tool> tools("tool");
  Carter carter("quarry", "mine");
  WiredPorts ports;
  ports.add("buyer", tools);
  ports.add("carter", carter);
  ports.placeGates();
  const auto makerOf = [&](const WiredPorts::Part& part) {
    const auto* maker = ports.makerOf(part.ports.inputs().front());
    return maker == nullptr ? "" : maker->title;
  };
  ASSERT_EQ(ports.parts().size(), 4u);
  EXPECT_EQ(makerOf(ports.parts()[0]), "gate 'forge'");
  EXPECT_EQ(makerOf(ports.parts()[1]), "") << "it comes from outside";
  EXPECT_EQ(makerOf(ports.parts()[2]), "gate 'smelter'");
  EXPECT_EQ(makerOf(ports.parts()[3]), "carter") << "a gate may need what a component makes";
  ports.requireJoinable();
}

std::vector<std::string> faultsOfWiring(const std::vector<Component*>& components) {
  Wiring wiring;
  for (auto* component : components)
    wiring.add("", *component, Wiring::Turn::kAtOnce,
               "component '" + std::to_string(wiring.ports().parts().size()) + "'");
  Settings settings;
  return faultsOf([&] { wiring.connect(settings); });
}

TEST(WiredPorts, ACircleOfComponentsIsOneSentence) {
  Carter first("a", "b"), second("b", "c"), third("c", "b2"), back("c", "a");
  EXPECT_TRUE(faultsOfWiring({&first, &second, &third}).empty()) << "a chain is none";
  const auto faults = faultsOfWiring({&third, &first, &second, &back});
  EXPECT_EQ(faults.size(), 1u) << join(faults, "\n");
  EXPECT_TRUE(oneSays(faults, {"in a circle",
                               "the component '2' takes 'b' (slam::test::Ore) from the component "
                               "'1', the component '1' takes 'a' (slam::test::Ore) from the "
                               "component '3', the component '3' takes 'c'",
                               "leave one of them out"}));
}

TEST(WiredPorts, AComponentThatTakesWhatItMakesIsRefused) {
  Carter carter("a", "a");
  EXPECT_TRUE(oneSays(faultsOfWiring({&carter}), {"takes 'a' (slam::test::Ore) from itself"}));
}

TEST(WiredPorts, ACircleThroughAGateIsRefused) {
  Buyer<Slag> buyer("waste");
  EXPECT_TRUE(oneSays(faultsOfWiring({&buyer}), {"the gate 'recycler' takes 'waste'", "itself"}));
}

TEST(WiredPorts, TwoWaysToTheSameMakerAreNoCircle) {
  Carter maker("a", "b"), left("b", "c"), right("b", "d"), end("c", "e"), other_end("d", "f");
  EXPECT_TRUE(faultsOfWiring({&end, &other_end, &left, &right, &maker}).empty());
}

/// A module of a product that takes what the gates make.
template <class First, class Second>
class Smith final : public Plain<MapModule> {
 public:
  Smith(std::string first, std::string second)
      : first_(std::move(first)), second_(std::move(second)) {}

  void describe(Ports& ports) override {
    ports.takes<First>(first_, "goods", [](const First&) {});
    ports.takes<Second>(second_, "goods", [](const Second&) {});
  }
  Status execute() override { return Status::ok(); }
  std::string sentence() const override { return "a smith"; }
  void save(const std::string&) const override {}

 private:
  std::string first_, second_;
};

NamesOfPorts inputsOfFlow(std::unique_ptr<MapModule> module) {
  ProductComponents product;
  product.modules["smith"] = std::move(module);
  return namesOf(DataFlow(product).parts().front().inputs);
}

TEST(DataFlow, LeadsThroughGatesToWhatComesFromOutsideOnceEach) {
  EXPECT_EQ(inputsOfFlow(std::make_unique<Smith<Tool, Slag>>("tool", "slag")),
            NamesOfPorts{"mine"});
}

TEST(DataFlow, EndsWhereAGateNeedsItself) {
  EXPECT_EQ(inputsOfFlow(std::make_unique<Smith<Slag, Ore>>("waste", "mine")),
            NamesOfPorts{"mine"});
}

}  // namespace
}  // namespace slam::test
