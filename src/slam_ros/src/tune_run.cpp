// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/tune_run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>

#include "slam_core/common/atomic_file.hpp"
#include "slam_core/common/config_error.hpp"
#include "slam_core/common/input_file.hpp"
#include "slam_core/product/meta_coordinator.hpp"
#include "slam_core/tuning/robot_file_text.hpp"
#include "slam_ros/bag_inputs.hpp"
#include "slam_ros/bag_transforms.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/product_files.hpp"

namespace slam_ros {
namespace {

using slam::tuning::NoiseTuner;
using slam::tuning::RecordedLog;
using slam::tuning::TuningResult;

slam::Settings settingsFor(const TuneOptions& options, const std::vector<std::string>& more) {
  auto overrides = options.overrides;
  overrides.insert(overrides.end(), more.begin(), more.end());
  return {slam::loadConfigFile(productFile(options.product)),
          slam::loadConfigFile(robotFile(options.robot)), overrides};
}

/// What the tuner's filter takes in, whatever the product's own takes: landmarks, which the
/// product's detector may make, and the wheels' motion.
slam::ProductComponents tunedComponents(const slam::ProductConfig& product) {
  slam::ProductConfig tuned;
  tuned.backend = "ekf";
  tuned.odometry = "wheel";
  tuned.detector = product.detector;
  return slam::createComponents(tuned);
}

/// Collects what a bag holds; images go through the detector.
class Recorder {
 public:
  Recorder(const TuneOptions& options, const std::string& bag)
      : bag_(bag), settings_(settingsFor(options, {})) {
    const BagContext context{settings_.read<TopicsConfig>(), settings_.read<slam::FramesConfig>(),
                             GivenMounts(settings_)};
    map_frame_ = frameId(context.frames.map);
    front_end_.configure(settings_, {slam::ProductPart::Extent::kDetector, ""});
    front_end_.listen<slam::LandmarkObservationArray>(
        "observations", [this](const auto& array) { log_.inputs.emplace_back(array); });
    inputs_.emplace(bag_, tunedComponents(front_end_.components().product), context,
                    parseRemaps(options.remaps));
  }

  RecordedLog record() {
    log_.name = bag_.path();
    const auto transforms = staticTransforms(bag_, map_frame_);
    bag_.read(inputs_->readers([&](const BagInputs::Found& found) {
      BagSinks sinks;
      sinks.put = [this, &port = found.port](const slam::Datum& value, slam::Stamp) {
        take(port, value);
      };
      sinks.static_transforms = transforms;
      return sinks;
    }));
    return std::move(log_);
  }

 private:
  void take(const std::string& port, const slam::Datum& value) {
    const bool is_recorded = record<slam::OdometrySample>(value) || record<slam::Motion>(value) ||
                             record<slam::LandmarkObservationArray>(value);
    if (!is_recorded) front_end_.put(port, value.kind(), value.value());
  }

  template <class Data>
  bool record(const slam::Datum& value) {
    const auto* data = value.as<Data>();
    if (data != nullptr) log_.inputs.emplace_back(*data);
    return data != nullptr;
  }

  BagReader bag_;
  slam::Settings settings_;
  std::string map_frame_;
  slam::MetaCoordinator front_end_;
  std::optional<BagInputs> inputs_;
  RecordedLog log_;
};

std::string bagNames(const TuneOptions& options) {
  std::vector<std::string> names;
  for (const auto& bag : options.bags)
    names.push_back(std::filesystem::path(bag).filename().string());
  return slam::join(names);
}

/// A file with the values that were there before would pass for a tuned one.
void requireSomethingSeen(const TuningResult& result, const std::string& bags) {
  std::map<std::string, std::vector<std::string>> names;  // by why they cannot be seen
  for (const auto& parameter : result.parameters) {
    if (parameter.why_unseen.empty()) return;
    names[parameter.why_unseen].push_back(parameter.name());
  }
  std::vector<std::string> reasons;
  for (const auto& [why, whose] : names)
    reasons.push_back(fmt::format("{} ({})", slam::join(whose), why));
  throw std::runtime_error(
      fmt::format("nothing can be tuned on {}, which does not show {}; "
                  "no file was written",
                  bags, slam::join(reasons)));
}

void print(const TuningResult& result) {
  fmt::print("{:<38} {:>10} {:>10} {:>12}\n", "", "before", "tuned", "uncertainty");
  for (const auto& parameter : result.parameters) {
    fmt::print("{:<38} {:>10.4g} ", parameter.name(), parameter.before);
    if (parameter.is_bound)
      fmt::print("{:>10.4g} {:>12}\n", parameter.value,
                 parameter.value < parameter.before ? "at most" : "at least");
    else if (parameter.why_unseen.empty())
      fmt::print("{:>10.4g} {:>12.2g}\n", parameter.value, parameter.sigma);
    else
      fmt::print("cannot be seen: {}; it is kept\n", parameter.why_unseen);
  }
  fmt::print("log-likelihood of {} innovations{}: {:.1f} before, {:.1f} tuned ({} filter runs)\n",
             result.innovations,
             result.of_resightings ? " of landmarks seen again after a while" : "",
             result.log_likelihood_before, result.log_likelihood, result.evaluations);
  if (!result.has_converged)
    fmt::print("the search ended before it was sure of the maximum; tune the result again\n");
}

/// Goes on in one line of a terminal; nothing elsewhere.
NoiseTuner::Progress progressLine() {
  if (::isatty(STDERR_FILENO) != 1) return {};
  return [](int evaluations, double log_likelihood) {
    fmt::print(stderr, "\rfilter run {}: log-likelihood {:.1f}   ", evaluations, log_likelihood);
    std::fflush(stderr);
  };
}

}  // namespace

RecordedLog recordedLog(const TuneOptions& options, const std::string& bag) {
  return Recorder(options, bag).record();
}

void tune(const TuneOptions& options) {
  const auto robot = slam::readInputFile(robotFile(options.robot), "the robot's file");
  slam::requireWritable(options.out);
  std::vector<RecordedLog> logs;
  for (const auto& bag : options.bags) logs.push_back(recordedLog(options, bag));
  const NoiseTuner tuner(
      [&](const std::vector<std::string>& overrides) {
        auto all = overrides;
        all.push_back("detector=none");  // what it saw is in the logs
        return settingsFor(options, all);
      },
      std::move(logs));
  const auto names = options.parameters.empty() ? tuner.defaultParameters() : options.parameters;
  const auto remark = slam::tuning::tuningRemark(options.product, bagNames(options));
  // A file that cannot take the values is reported before the search.
  slam::tuning::withTunedValues(robot, tuner.start(names), remark);
  const auto result = tuner.run(names, progressLine());
  if (::isatty(STDERR_FILENO) == 1) fmt::print(stderr, "\n");
  requireSomethingSeen(result, bagNames(options));
  print(result);
  slam::writeFileAtomically(options.out,
                            slam::tuning::withTunedValues(robot, result.parameters, remark));
  fmt::print("{}\n", options.out);
}

}  // namespace slam_ros
