// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "slam_core/common/test/fuzz/fuzz_target.hpp"

namespace slam::test {
namespace {

namespace fs = std::filesystem;

/// A line "NAME FOLDER" for each target, written by CMake.
std::map<std::string, fs::path> foldersOfInputs() {
  std::ifstream file(FUZZ_TARGETS);
  std::map<std::string, fs::path> folders;
  for (std::string name, folder; file >> name && std::getline(file >> std::ws, folder);)
    folders[name] = folder;
  return folders;
}

std::vector<fs::path> inputsIn(const fs::path& folder) {
  const fs::directory_iterator entries(folder);
  std::vector<fs::path> inputs(begin(entries), end(entries));
  std::sort(inputs.begin(), inputs.end());
  return inputs;
}

void give(const std::string& input, FuzzTarget target) {
  target(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

class FuzzTargets : public testing::TestWithParam<std::pair<const std::string, fs::path>> {};

/// An input that a target does not take ends the program: the last line names it.
TEST_P(FuzzTargets, TakeTheirSeedsAndWhatWasFound) {
  const auto& [name, folder] = GetParam();
  const auto target = fuzzTargets().at(name);
  give("", target);
  const auto inputs = inputsIn(folder);
  EXPECT_FALSE(inputs.empty());
  for (const auto& path : inputs) {
    std::cout << path.string() << std::endl;
    std::ifstream file(path, std::ios::binary);
    ASSERT_TRUE(file);
    give({std::istreambuf_iterator<char>(file), {}}, target);
  }
}

INSTANTIATE_TEST_SUITE_P(All, FuzzTargets, testing::ValuesIn(foldersOfInputs()),
                         [](const auto& target) { return target.param.first; });

TEST(FuzzTargets, AreAllGivenInputs) { EXPECT_EQ(foldersOfInputs().size(), fuzzTargets().size()); }

}  // namespace
}  // namespace slam::test
