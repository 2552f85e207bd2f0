// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "slam_core/common/test/temporary_folder.hpp"
#include "slam_core/contract/map_module.hpp"
#include "slam_core/product/test/driven_component.hpp"

// Every additional module that takes in motion, a laser's scans or the back-end's poses keeps this
// contract. A program that includes this file tests the modules that are linked into it:
//   INSTANTIATE_MODULE_CONTRACT(Mine, (std::vector<RoleVariant>{{"mine", "mine"}}));

/// @param variants a vector of RoleVariant
#define INSTANTIATE_MODULE_CONTRACT(name, variants) \
  INSTANTIATE_TEST_SUITE_P(name, ModuleContract, testing::ValuesIn(variants), roleVariantName)

namespace slam::test {

class ModuleContract : public testing::TestWithParam<RoleVariant> {
 protected:
  using Driven = DrivenComponent<MapModule>;
  using Files = std::map<std::string, std::string>;  ///< bytes by the file's name

  static Files savedBy(const Driven& module) {
    const TemporaryFolder folder;
    module->save(folder / "");
    Files files;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "")) {
      std::ifstream file(entry.path(), std::ios::binary);
      files[entry.path().filename()] = {std::istreambuf_iterator<char>(file), {}};
    }
    return files;
  }
};

TEST_P(ModuleContract, SaysWhatItMakes) {
  const Driven module(GetParam());
  EXPECT_FALSE(module->sentence().empty());
  EXPECT_EQ(module->sentence().find('\n'), std::string::npos);
}

TEST_P(ModuleContract, SavesWhatItHasMade) {
  Driven module(GetParam());
  const auto before = savedBy(module);
  module.run(1, 60);
  const auto after = savedBy(module);
  EXPECT_FALSE(after.empty());
  EXPECT_NE(after, before);
}

TEST_P(ModuleContract, SavesTheSameBytesForTheSameInput) {
  Driven first(GetParam()), second(GetParam());
  first.run(3, 60);
  second.run(3, 60);
  EXPECT_EQ(savedBy(first), savedBy(second));
}

TEST_P(ModuleContract, IsFreshAfterResetAndAfterConfigure) {
  RestartedComponents<MapModule> modules(GetParam());
  for (auto* module : {&modules.fresh, &modules.reset, &modules.configured}) module->run(3, 40);
  EXPECT_EQ(savedBy(modules.fresh), savedBy(modules.reset));
  EXPECT_EQ(savedBy(modules.fresh), savedBy(modules.configured));
}

TEST_P(ModuleContract, NamesTheFileThatCannotBeWritten) {
  Driven module(GetParam());
  module.run(1, 20);
  try {
    module->save("/nowhere/at/all");
    FAIL() << "no exception";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/at/all"), std::string::npos);
  }
}

}  // namespace slam::test
