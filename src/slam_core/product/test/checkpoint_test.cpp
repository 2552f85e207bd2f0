// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/checkpoint.hpp"

#include <gtest/gtest.h>

#include "slam_core/common/sealed_bytes.hpp"
#include "slam_core/common/test/faults.hpp"

namespace slam {
namespace {

const RunIdentity kRun = {"ekf_wheel", "office", "office.bag with 12 messages",
                          "seed: 1\nekf:\n  mode: slam\n"};

std::string said(const std::string& bytes, const RunIdentity& run = kRun) {
  return test::sentenceOf([&] { stateIn(bytes, run); });
}

TEST(Checkpoint, GivesBackTheState) {
  const std::string state("a\0state", 7);
  EXPECT_EQ(stateIn(checkpointOf(kRun, state), kRun), state);
}

TEST(Checkpoint, RefusesEveryOtherRunAndNamesWhatDiffers) {
  const auto bytes = checkpointOf(kRun, "state");
  auto run = kRun;
  run.product = "pf_wheel";
  EXPECT_EQ(said(bytes, run),
            "it is of another product, 'ekf_wheel' instead of 'pf_wheel': resume it with its own");
  run = kRun;
  run.robot = "rover";
  EXPECT_EQ(said(bytes, run),
            "it is of another robot, 'office' instead of 'rover': resume it with its own");
  run = kRun;
  run.data = "other.bag with 12 messages";
  EXPECT_TRUE(test::oneSays({said(bytes, run)}, {"another bag", "office.bag", "other.bag"}));
}

TEST(Checkpoint, NamesTheFirstValueOfAnotherConfiguration) {
  auto run = kRun;
  run.configuration = "seed: 2\nekf:\n  mode: slam\n";
  EXPECT_TRUE(test::oneSays({said(checkpointOf(kRun, ""), run)},
                            {"another configuration", "'seed: 1' instead of 'seed: 2'"}));
  run.configuration = kRun.configuration + "  more: 1\n";
  EXPECT_TRUE(test::oneSays({said(checkpointOf(kRun, ""), run)}, {"'' instead of '  more: 1'"}));
  EXPECT_TRUE(test::oneSays({said(checkpointOf(run, ""))}, {"'  more: 1' instead of ''"}));
}

TEST(Checkpoint, RefusesWhatIsCutOrDamagedOrNoCheckpoint) {
  const auto bytes = checkpointOf(kRun, std::string(100, 'x'));
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_NE(said(bytes.substr(0, size)), "") << size;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    auto flipped = bytes;
    flipped[i] = static_cast<char>(flipped[i] ^ 0x10);
    EXPECT_NE(said(flipped), "") << i;
  }
  EXPECT_TRUE(test::oneSays({said("stamp x y theta")}, {"it is no checkpoint"}));
}

TEST(Checkpoint, RefusesThoseOfALaterVersion) {
  auto bytes = checkpointOf(kRun, "state");
  bytes[8] = 99;
  EXPECT_TRUE(test::oneSays({said(bytes)}, {"it is of version 99", "use the program that has"}));
}

}  // namespace
}  // namespace slam
