// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <malloc.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cpu_time.hpp"
#include "slam_core/common/settings.hpp"
#include "slam_core/product/meta_coordinator.hpp"
#include "slam_core/product/run_writer.hpp"
#include "slam_core/product/test/fault_world.hpp"
#include "slam_ros/command_line.hpp"

// Drives a product for days of stamps and prints, for each hour, how much memory the process takes,
// and how much of it is what a checkpoint holds. Every other hour the robot stands still; else it
// drives rounds past what it has mapped in the first one.

namespace slam::eval {
namespace {

using test::FaultWorld;
using test::Message;

struct DaysConfig {
  std::string product, out;
  std::vector<std::string> overrides;
  double hours = 24.0, interval = 1.0;  ///< interval of messages [s]
  int seed = 1;
};

/// Of this process, without what has been freed [MB].
double residentMegabytes() {
  ::malloc_trim(0);
  std::ifstream file("/proc/self/statm");
  double size = 0.0, resident = 0.0;
  if (!(file >> size >> resident)) throw std::runtime_error("/proc/self/statm cannot be read");
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
}

/// The world's messages with the stamps of a slower robot that stands still every other hour.
class SlowDrive {
 public:
  SlowDrive(const DaysConfig& config, bool has_scans)
      : world_(static_cast<std::uint64_t>(config.seed), has_scans, true),
        interval_(durationFromSeconds(config.interval)) {}

  std::vector<test::ProductInput> begin() const { return world_.begin(); }

  std::vector<Message> next() {
    ++count_;
    if (last_.empty() || !stands()) last_ = world_.next();
    for (auto& message : last_) std::visit([this](auto& value) { date(value); }, message);
    return last_;
  }
  /// @return how many messages each sensor has sent so far
  std::size_t messages() const { return static_cast<std::size_t>(count_); }
  Stamp now() const { return begin_ + count_ * interval_; }

 private:
  bool stands() const { return ((now() - begin_) / std::chrono::hours(1)) % 2 == 1; }
  template <class T>
  void date(T& message) {
    message.stamp = now();
  }
  void date(LandmarkObservationArray& array) {
    array.stamp = now();
    array.sequence = static_cast<std::uint64_t>(count_);
  }
  void date(Motion&) {}  // this world sends what wheels measure

  FaultWorld world_;
  Duration interval_;
  Stamp begin_ = stampFromNanoseconds(1000000000000);
  std::int64_t count_ = 0;
  std::vector<Message> last_;
};

/// A product whose steps are written like those of any run.
class LongRun {
 public:
  explicit LongRun(const DaysConfig& config) : writer_(config.out) {
    Settings settings(loadConfigFile(config.product), {}, config.overrides);
    product_.configure(settings);
    const auto& inputs = inputsOf(settings.read<ProductConfig>());
    for (const auto& input : inputs) has_scans_ = has_scans_ || input.kind == kindOf<LaserScan>();
  }

  bool hasScans() const { return has_scans_; }
  void take(const test::ProductInput& input) { input(product_); }
  void take(const std::vector<Message>& messages) {
    for (const auto& message : messages)
      std::visit([this](const auto& value) { product_.set(value); }, message);
    while (true) {
      const auto status = product_.execute();
      if (status.level == Status::Level::kError) throw std::runtime_error(status.message);
      const auto& report = product_.estimator().report();
      if (!report) return;
      writer_.write(*report);
      ++steps_;
    }
  }
  /// @throw std::runtime_error where the product waits for what the world has not
  void printRow(double hour, std::size_t messages) const {
    if (2 * steps_ < messages)
      throw std::runtime_error(
          "the product takes few steps only: it needs other sensors than wheels and either "
          "landmarks or a laser");
    const double checkpoint = static_cast<double>(stateOf(product_).size()) / 1e6;
    std::printf("%.0f,%.3f,%.3f,%zu,%.1f\n", hour, residentMegabytes(), checkpoint, steps_,
                cpuMilliseconds() / 1e3);
    std::fflush(stdout);
  }

 private:
  RunWriter writer_;
  MetaCoordinator product_;
  bool has_scans_ = false;
  std::size_t steps_ = 0;
};

void run(const DaysConfig& config) {
  LongRun run(config);
  SlowDrive drive(config, run.hasScans());
  for (const auto& input : drive.begin()) run.take(input);
  const auto begin = drive.now();
  std::puts("hour,resident_mb,checkpoint_mb,steps,cpu_s");
  double hour = 1.0;
  while (hour <= config.hours) {
    run.take(drive.next());
    if (seconds(drive.now() - begin) < 3600.0 * hour) continue;
    run.printRow(hour, drive.messages());
    hour += 1.0;
  }
}

}  // namespace
}  // namespace slam::eval

int main(int argc, char** argv) {
  slam_ros::CommandLine line(
      "slam_eval_days", "memory of a product over days of stamps, as CSV: a line for each hour");
  slam::eval::DaysConfig config;
  line.add("product", config.product, "product file").required().existingFile();
  line.add("--out", config.out, "folder of the run, whose files grow").required();
  line.add("--set", config.overrides, "section.key=value");
  line.add("--hours", config.hours, "of stamps").between(1.0, 1e4).withDefault();
  line.add("--interval", config.interval, "between messages of a sensor [s]")
      .between(0.01, 4.0)
      .withDefault();
  line.add("--seed", config.seed, "of the world").nonNegative().withDefault();
  return line.run(argc, argv, [&] { slam::eval::run(config); });
}
