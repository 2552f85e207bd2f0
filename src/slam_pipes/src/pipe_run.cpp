// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "pipe_run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <set>

#include "slam_core/common/atomic_file.hpp"
#include "slam_ros/bag_transforms.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/ground_truth.hpp"
#include "slam_ros/product_files.hpp"

namespace slam_pipes {
PipeRun::PipeRun(const RunOptions& options)
    : options_(options),
      progress_(std::cerr, ::isatty(STDERR_FILENO) == 1),
      bag_(options.bag),
      product_file_(slam_ros::productFile(options.product)),
      robot_file_(slam_ros::robotFile(slam_ros::robotOf(options, bag_))),
      settings_(slam_ros::settingsFor(options, bag_)) {
  configure();
  choosePartsToStart();
}

void PipeRun::configure() {
  const auto topics = slam_ros::configured(settings_, whole_);
  const auto& components = whole_.components();
  inputs_.emplace(bag_, components,
                  slam_ros::BagContext{topics, components.frames, slam_ros::GivenMounts(settings_)},
                  slam_ros::parseRemaps(options_.remaps));
}

/// A component whose data the bag carries is left out.
void PipeRun::choosePartsToStart() {
  auto all = partsOf(whole_.components().product);
  for (auto& part : all)
    if (!inputs_->isLeftOut(part.key)) parts_.push_back(std::move(part));
  for (const auto& part : parts_)
    for (const auto& input : part.inputs)
      if (comes(input)) requirePersistent(input, part);
}

/// Whether the bag has the data or a component makes them. What is latched comes with the data of
/// the same port.
bool PipeRun::comes(const slam::InputPort& input) const {
  const auto& found = inputs_->found();
  return inputs_->isSupplied(input) ||
         std::any_of(found.begin(), found.end(),
                     [&](const auto& other) { return other.port == input.name; });
}

void PipeRun::run() {
  for (const auto& note : inputs_->notes()) fmt::print("{}\n", note);
  for (const auto& warning : inputs_->warnings()) warn(warning);
  std::fflush(stdout);
  read();
  complete(processes().end());
}

/// They are started with the first message: the process that reads the bag is a copy of this one,
/// and would hold the ends of their pipes open.
PipedProduct& PipeRun::processes() {
  if (processes_) return *processes_;
  ProcessOptions options{options_.program,   product_file_,   robot_file_,
                         options_.overrides, options_.folder, {}};
  for (const auto& trigger : inputs_->flow().triggersOfBackend())
    if (!inputs_->isSupplied(trigger)) options.without.push_back(trigger.name);
  const auto warn = [this](const slam::Status& status) {
    this->warn(status.message, status.isUrgent());
  };
  processes_.emplace(parts_, options, PipedProduct::Listeners{warn, [this](const StepDone& step) {
                                                                takeStep(step);
                                                              }});
  return *processes_;
}

void PipeRun::read() {
  const auto transforms =
      slam_ros::staticTransforms(bag_, slam_ros::frameId(whole_.components().frames.map));
  const auto handlers = inputs_->readers([&](const slam_ros::BagInputs::Found& input) {
    auto sinks = sinksOf(input);
    sinks.static_transforms = transforms;
    return sinks;
  });
  progress_.begin(bag_.path(), bag_.messages(handlers));
  bag_.read(handlers, [&](std::size_t done) {
    messages_ = done;
    processes().step();
    progress_.update(done);
    return true;
  });
  progress_.end();
}

slam_ros::BagSinks PipeRun::sinksOf(const slam_ros::BagInputs::Found& input) {
  slam_ros::BagSinks sinks;
  sinks.put = [this, &input](const slam::Datum& value, slam::Stamp /*stamp*/) {
    processes().put(input.port, value);
  };
  sinks.warn = [this](const std::string& sentence) { warn(sentence); };
  sinks.count = [this](const std::string& reason) { input_counters_.add(reason); };
  return sinks;
}

void PipeRun::takeStep(const StepDone& step) {
  if (step.report.restarted) warn(slam_ros::kStampsWentBack);
  if (step.report.hasTrigger()) {
    metrics_.addUpdate(std::chrono::nanoseconds(step.nanoseconds));
    metrics_.addTrust(step.report.stamp, step.report.trust);
  }
  metrics_.addEvents(step.report);
}

/// Beside what the processes write themselves stands what only the bag and this process know.
void PipeRun::complete(const std::vector<PartSummary>& summaries) {
  tellOfUnused(summaries);
  const auto& of_backend = ofBackend(summaries);
  slam_ros::requireSteps(metrics_, of_backend.poses, *inputs_, bag_, counters(summaries));
  const auto truth = slam_ros::writeGroundTruth(bag_, of_backend.folder);
  if (const auto& source = whole_.components().odometry;
      source && slam::ownsOdometryEdge(*source) && !inputs_->isLeftOut("odometry"))
    slam_ros::writeWheelOdometry(bag_, of_backend.folder);
  if (of_backend.grid) metrics_.setGrid(*of_backend.grid);
  const auto metrics = metrics_.toJson(bag_.end() - bag_.begin(), dropped(summaries));
  slam::writeFileAtomically(of_backend.folder + "/metrics.json",
                            options_.origin.addedToMetrics(metrics));
  processes().finish({of_backend.folder, options_.origin.addedToConfig(settings_.inForce())});
  printSummary(summaries);
  if (truth.poses == 0) fmt::print("the bag holds no true trajectory to compare with\n");
}

const PartSummary& PipeRun::ofBackend(const std::vector<PartSummary>& summaries) const {
  const auto backend = std::find_if(parts_.begin(), parts_.end(),
                                    [](const PartPorts& part) { return part.isBackend(); });
  return summaries[static_cast<std::size_t>(backend - parts_.begin())];
}

/// An input gate that stands in several processes has dropped the same in each.
std::uint64_t PipeRun::dropped(const std::vector<PartSummary>& summaries) const {
  std::uint64_t sum = 0;
  std::map<std::string, std::uint64_t> of_gates;
  for (const auto& summary : summaries) {
    sum += summary.dropped;
    of_gates.insert(summary.gate_dropped.begin(), summary.gate_dropped.end());
  }
  for (const auto& [name, count] : of_gates) sum += count;
  return sum;
}

void PipeRun::tellOfUnused(const std::vector<PartSummary>& summaries) {
  const auto& of_backend = ofBackend(summaries);
  slam_ros::UnusedData unused;
  unused.dropped = dropped(summaries);
  unused.messages = messages_;
  unused.set_aside = of_backend.counters["set_aside"];
  unused.held = of_backend.waiting;
  unused.starving = of_backend.starving;
  for (const auto& sentence : slam_ros::sentencesOn(unused)) warn(sentence);
}

slam::Counters PipeRun::counters(const std::vector<PartSummary>& summaries) const {
  auto counters = input_counters_;
  std::set<std::string> gates;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    counters.add(summaries[i].counters, parts_[i].isBackend() ? "" : parts_[i].key + "_");
    for (const auto& [name, count] : summaries[i].gate_counters)
      if (gates.insert(name).second) counters.add(count, name + "_");
    for (const auto& [what, count] : summaries[i].waiting.all())
      counters.add("never_stepped", count);
  }
  return counters;
}

void PipeRun::printSummary(const std::vector<PartSummary>& summaries) const {
  const auto& of_backend = ofBackend(summaries);
  fmt::print("{}: {} poses, {} landmarks, {:.1f} s of data in {:.2f} s, {} processes\n",
             options_.folder, of_backend.poses, of_backend.landmarks,
             slam::seconds(bag_.end() - bag_.begin()), metrics_.wallSeconds(), parts_.size());
  slam_ros::printCounts(counters(summaries));
  for (const auto& line : warnings_.summary()) fmt::print("{}\n", line);
  for (const auto& line : of_backend.calibration) fmt::print("{}\n", line);
}

void PipeRun::warn(const std::string& sentence, bool is_urgent) {
  const auto line = warnings_.add(sentence, is_urgent);
  if (line.empty()) return;
  progress_.clear();
  fmt::print(stderr, "warning: {}\n", line);
}

}  // namespace slam_pipes
