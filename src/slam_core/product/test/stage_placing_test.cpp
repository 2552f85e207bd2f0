// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/stage_placing.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "slam_core/product/data_flow.hpp"
#include "slam_core/product/meta_coordinator.hpp"

namespace slam::test {

struct Grain {
  int number = 0;
};
struct Flour {
  int number = 0;
};
struct Dough {
  int number = 0;
};

namespace {

using Titles = std::vector<std::string>;

template <class In, class Out>
class Work : public Stage {
 public:
  Work(std::string name, std::string input, std::string output)
      : name_(std::move(name)), input_(std::move(input)), output_(std::move(output)) {}

  std::string name() const override { return name_; }
  void describe(Ports& ports) override {
    ports.takes<In>(input_, input_, [this](const In& value) { made_ = Out{value.number + 1}; });
    ports.makes<Out>(output_, made_);
  }
  void configure(Settings&) override {}
  Status execute() override { return Status::ok(); }
  Counters counters() const override { return {}; }
  void reset() override {}

 private:
  std::string name_, input_, output_;
  std::optional<Out> made_;
};

// Named so that the registry has the taker before the maker.
class Kneading final : public Work<Flour, Dough> {
 public:
  Kneading() : Work("a_kneading", "flour", "dough") {}
};
class Milling final : public Work<Grain, Flour> {
 public:
  Milling() : Work("b_milling", "grain", "flour") {}
};

const StageRegistrar<Kneading> kKneading("a_kneading");
const StageRegistrar<Milling> kMilling("b_milling");

/// Takes dough, and flour beside it.
class Oven final : public MapModule {
 public:
  explicit Oven(std::string dough = "dough") : dough_(std::move(dough)) {}

  void describe(Ports& ports) override {
    ports.takes<Dough>(dough_, "dough", [this](const Dough& dough) { taken = dough.number; });
    ports.takes<Flour>("flour", "flour", [](const Flour&) {});
  }
  void configure(Settings&) override {}
  Status execute() override { return Status::ok(); }
  Counters counters() const override { return {}; }
  void reset() override {}
  std::string sentence() const override { return "bread"; }
  void save(const std::string&) const override {}

  int taken = 0;

 private:
  std::string dough_;
};

std::vector<ProductComponent> productOf(Component& component) {
  return {{"oven", "oven", "oven", &component, {"bread"}}};
}

Titles namesOf(const std::vector<ProductStage>& stages) {
  Titles names;
  for (const auto& stage : stages) names.push_back(stage.component->name());
  return names;
}

TEST(Stages, StandBeforeWhoNeedsThemMakersFirstAndOnce) {
  Oven oven;
  const auto stages = placeStages(productOf(oven));
  EXPECT_EQ(namesOf(stages), (Titles{"b_milling", "a_kneading"}));
  for (const auto& stage : stages) EXPECT_EQ(stage.features, Titles{"bread"});
}

TEST(Stages, StandNowhereWhereNobodyNeedsWhatTheyMakeOrOthersMakeIt) {
  Oven other("pastry");
  Kneading kneading;
  EXPECT_EQ(namesOf(placeStages(productOf(other))), Titles{"b_milling"});
  auto components = productOf(other);
  components.push_back({"kneading", "kneading", "kneading", &kneading, {}});
  EXPECT_EQ(namesOf(placeStages(components)), Titles{"b_milling"});
}

TEST(Stages, AreJoinedByTheirPortsWhateverPartTheyAreIn) {
  ProductComponents product;
  auto oven = std::make_unique<Oven>();
  auto& taker = *oven;
  product.modules["oven"] = std::move(oven);
  product.stages = placeStages(inOrder(product));
  Wiring wiring;
  connect(product, true, wiring);
  Settings settings;
  wiring.connect(settings);
  const Grain grain{1};
  wiring.put("grain", kindOf<Grain>(), &grain);
  EXPECT_EQ(taker.taken, 3) << "through both";
  const Dough dough{7};
  wiring.put("dough", kindOf<Dough>(), &dough);
  EXPECT_EQ(taker.taken, 7) << "made elsewhere";
}

TEST(DataFlow, KnowsWhatComesOfDataAtLast) {
  ProductComponents product;
  product.modules["oven"] = std::make_unique<Oven>();
  product.stages = placeStages(inOrder(product));
  const DataFlow flow(product);
  ASSERT_EQ(flow.parts().size(), 3u);
  Titles last;
  for (const auto& output : flow.lastOutputs(flow.parts()[0])) last.push_back(output.name);
  EXPECT_EQ(last, (Titles{"dough", "flour"})) << "of flour, which is taken in two places";
  EXPECT_EQ(flow.parts()[1].title(), "a_kneading component");
}

TEST(DataFlow, KnowsThatRatSlamStepsForImagesThroughTwoStages) {
  ProductConfig config;
  config.backend = "rat";
  config.detector = "none";
  const auto product = createComponents(config);
  const DataFlow flow(product);
  Titles parts, last;
  for (const auto& part : flow.parts()) parts.push_back(part.key);
  EXPECT_EQ(parts, (Titles{"odometry", "local_view", "pose_cells", "backend"}));
  for (const auto& output : flow.lastOutputs(flow.parts()[1])) last.push_back(output.name);
  EXPECT_EQ(last, Titles{"pose_cells"});
  for (const auto& stage : product.stages) EXPECT_EQ(stage.features, Titles{"backend"});
  const auto alone = createComponents(config, {ProductPart::Extent::kBackend, ""});
  EXPECT_TRUE(alone.stages.empty()) << "their nodelets bring them";
  const auto view = createComponents(config, {ProductPart::Extent::kStage, "local_view"});
  EXPECT_EQ(inOrder(view).front().title(), "stage 'local_view'");
}

}  // namespace
}  // namespace slam::test
