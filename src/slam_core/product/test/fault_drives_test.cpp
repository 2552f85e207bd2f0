// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <string>

#include "slam_core/product/test/fault_drive.hpp"

namespace slam {
namespace {

using test::FaultDrive;
using test::FaultyProduct;

double numberIn(const char* variable, double otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::strtod(text, nullptr);
}

/// The command that repeats a drive of the test that runs.
std::string repeating(std::uint64_t seed) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return fmt::format("FAULT_SEED={} FAULT_DRIVES=1 {} --gtest_filter={}.{}", seed,
                     program_invocation_name, test->test_suite_name(), test->name());
}

class FaultDrives : public testing::TestWithParam<FaultyProduct> {
 protected:
  void drive(std::uint64_t seed) {
    FaultDrive drive(GetParam(), seed);
    const auto broken = drive.run();
    hours_ += drive.simulatedHours();
    largest_ = std::max(largest_, drive.largestCheckpoint());
    if (!broken.empty()) ADD_FAILURE() << broken << "\n" << repeating(seed);
  }
  /// A long run says what it has covered.
  void TearDown() override {
    std::cout << fmt::format("{:.1f} h of {} in {:.0f} s of CPU, checkpoints of up to {:.2f} MB\n",
                             hours_, GetParam().name, double(std::clock()) / CLOCKS_PER_SEC - cpu_,
                             double(largest_) / 1e6);
  }

  double hours_ = 0.0;  ///< simulated
  double cpu_ = double(std::clock()) / CLOCKS_PER_SEC;
  std::size_t largest_ = 0;  ///< checkpoint [bytes]
};

INSTANTIATE_TEST_SUITE_P(
    Products, FaultDrives,
    testing::Values(FaultyProduct{"ekf", {"backend=ekf"}, false, 12},
                    FaultyProduct{"ekf_jcbb", {"backend=ekf", "association=jcbb"}, false, 6},
                    FaultyProduct{"pf", {"backend=pf", "pf.particles=10"}, false, 12},
                    FaultyProduct{"graph", {"backend=graph"}, false, 8},
                    FaultyProduct{"seif", {"backend=seif"}, false, 8},
                    FaultyProduct{"grid", {"backend=grid", "map=grid"}, true, 2},
                    FaultyProduct{"grid_laser_odometry",
                                  {"backend=grid", "map=grid", "odometry=laser", "pointmap=true"},
                                  true},
                    FaultyProduct{
                        "pf_grid", {"backend=pf", "map=grid", "pf.particles=10"}, true, 1},
                    FaultyProduct{"graph_grid", {"backend=graph", "map=grid"}, true, 2}),
    [](const auto& product) { return product.param.name; });

/// FAULT_HOURS=H drives each product for so many simulated hours, as in a night; FAULT_SEED=S
/// begins with another drive, FAULT_DRIVES=N ends after so many.
TEST_P(FaultDrives, BreakNothing) {
  const auto first = static_cast<std::uint64_t>(numberIn("FAULT_SEED", 1));
  const double hours = numberIn("FAULT_HOURS", 0.0);
  const double drives = numberIn("FAULT_DRIVES", hours > 0.0 ? 1e9 : GetParam().drives);
  for (auto seed = first; double(seed - first) < drives; ++seed) {
    if (hours > 0.0 && hours_ >= hours) break;
    drive(seed);
  }
}

/// Ten seconds are missing, in which the robot drove most of a lap: what the odometry's poses say
/// of them is not as sure as if it had gone the shortest way.
TEST(FaultDrive, IsHonestBehindALongPause) {
  for (const std::uint64_t seed : {5222, 10216})
    EXPECT_EQ(FaultDrive({"ekf", {"backend=ekf"}}, seed).run(), "") << seed;
}

}  // namespace
}  // namespace slam
