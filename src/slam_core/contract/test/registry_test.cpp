// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/contract/registry.hpp"

#include <gtest/gtest.h>

#include "slam_core/common/test/faults.hpp"
#include "slam_core/contract/known_sections.hpp"

namespace slam::test {

/// A role of the test's own.
struct Voice {
  static constexpr const char* kRole = "voice";
  virtual ~Voice() = default;
  virtual int pitch() const = 0;
};

struct Alto : Voice {
  int pitch() const override { return 2; }
};

struct Bass : Voice {
  int pitch() const override { return 1; }
};

struct ChoirConfig {
  static constexpr const char* kSection = "choir";
  int voices = 4;
  void describe(Fields& fields) { fields.add("voices", &voices, "how many sing"); }
};

struct CathedralConfig {
  static constexpr const char* kSection = "choir";
  int seats = 100;
  void describe(Fields& fields) { fields.add("seats", &seats, "beside the altar"); }
};

namespace {

/// A class that any library may have one of.
struct Hidden : Voice {
  int pitch() const override { return 3; }
};

class RegistryTest : public testing::Test {
 protected:
  template <class T>
  void add(const std::string& name, const char* file) {
    registry.add(name, Registration::of<T>(file), [] { return std::make_unique<T>(); });
  }
  std::vector<std::string> faultsOfCreating(const std::string& name) {
    return faultsOf([&] { registry.create(name); });
  }

  Registry<Voice> registry;
};

TEST_F(RegistryTest, TwoComponentsOfOneNameAreRefusedWithBothClasses) {
  add<Alto>("solo", "/one/alto.cpp");
  add<Bass>("solo", "/two/bass.cpp");
  const auto faults = faultsOfCreating("solo");
  EXPECT_EQ(faults.size(), 1u);
  EXPECT_TRUE(oneSays(faults, {"voice 'solo' is there twice", "slam::test::Alto (alto.cpp)",
                               "slam::test::Bass (bass.cpp)", "leave one of the two libraries"}));
}

TEST_F(RegistryTest, OthersCanBeUsedAllTheSame) {
  add<Alto>("solo", "alto.cpp");
  add<Bass>("solo", "bass.cpp");
  add<Bass>("bass", "bass.cpp");
  EXPECT_EQ(registry.create("bass")->pitch(), 1);
  EXPECT_EQ(registry.names(), (std::vector<std::string>{"bass", "solo"}));
}

TEST_F(RegistryTest, TheSameComponentMayRegisterTwice) {
  add<Alto>("alto", "/build/alto.cpp");
  add<Alto>("alto", "/build/alto.cpp");      // its library is loaded from two places
  add<Alto>("alto", "/elsewhere/alto.cpp");  // and was built in two
  EXPECT_EQ(registry.create("alto")->pitch(), 2);
}

TEST_F(RegistryTest, ClassesOfUnnamedNamespacesAreToldApartByTheirFiles) {
  add<Hidden>("hidden", "a.cpp");
  add<Hidden>("hidden", "a.cpp");
  EXPECT_EQ(registry.create("hidden")->pitch(), 3);
  add<Hidden>("hidden", "b.cpp");
  EXPECT_TRUE(oneSays(faultsOfCreating("hidden"), {"(a.cpp)", "(b.cpp)"}));
}

TEST(Registrar, TellsTheFileThatItStandsIn) {
  const Registrar<Voice, Alto> first("quartet"), again("quartet");
  EXPECT_EQ(Registry<Voice>::instance().create("quartet")->pitch(), 2);
  const Registrar<Voice, Bass> other("quartet");
  EXPECT_TRUE(oneSays(faultsOf([] { Registry<Voice>::instance().create("quartet"); }),
                      {"Bass (registry_test.cpp)"}));
}

TEST(KnownSections, TwoConfigurationsOfOneSectionAreRefusedWhereverSectionsAreRead) {
  KnownSections sections;
  sections.add<ChoirConfig>("choir.cpp");
  sections.add<ChoirConfig>("another_component.cpp");  // that reads the same section
  Settings settings;
  EXPECT_TRUE(faultsOf([&] { sections.readAll(settings); }).empty());
  sections.add<CathedralConfig>("cathedral.cpp");
  for (const auto& faults : {faultsOf([&] { sections.readAll(settings); }),
                             faultsOf([&] { sections.checkUnused(settings); })})
    EXPECT_TRUE(oneSays(faults, {"the section choir is read in two ways", "ChoirConfig",
                                 "CathedralConfig (cathedral.cpp)"}));
}

}  // namespace
}  // namespace slam::test
