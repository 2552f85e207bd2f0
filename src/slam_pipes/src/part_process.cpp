// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "part_process.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>

#include "slam_core/common/input_file.hpp"
#include "slam_core/contract/calibrator.hpp"
#include "slam_core/contract/grid_mapper.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/models/odometry_sample.hpp"
#include "slam_core/tuning/calibrated_robot.hpp"

namespace slam_pipes {
namespace {

constexpr const char* kBag = "bag";
constexpr const char* kTheBag = "the bag";

slam::Settings settingsOf(const PartOptions& options) {
  return {slam::loadConfigFile(options.product), slam::loadConfigFile(options.robot),
          options.overrides};
}

const PartPorts& partNamed(const std::vector<PartPorts>& parts, const std::string& key) {
  if (const auto* part = findPart(parts, key)) return *part;
  std::vector<std::string> keys;
  for (const auto& part : parts) keys.push_back(part.key);
  throw slam::ConfigError("the product has no part '" + key + "'; it has: " + slam::join(keys));
}

std::shared_ptr<void> valueIn(const Frame& frame, const slam::InputPort& input) {
  try {
    slam::ArchiveReader archive(frame.value);
    auto value = input.traits.restore(archive);
    if (archive.left() == 0) return value;
  } catch (const std::runtime_error&) {
    // its reasons are those of a file
  }
  throw std::runtime_error("'" + frame.port + "' (" + frame.kind +
                           ") comes by a pipe and cannot be read: start both of its ends from one "
                           "installation");
}

}  // namespace

PartProcess::PartProcess(PartOptions options) : options_(std::move(options)) {
  if (options_.status) status_.emplace(*options_.status, "the program that started it");
}

void PartProcess::run() {
  configure();
  auto mark = Frame::Type::kTurn;
  while (mark != Frame::Type::kEnd) {
    const auto turn = turns_.next();
    mark = turn.mark;
    for (const auto& frame : turn.data) take(frame);
    if (mark != Frame::Type::kTurn) step();
    for (auto& output : outputs_) output.put({mark, "", "", ""});
  }
  finish();
}

void PartProcess::fail(const std::string& sentence) {
  if (status_)
    report(report::kFault, sentence);
  else
    fmt::print(stderr, "slam_part: {}\n", sentence);
}

void PartProcess::configure() {
  settings_ = settingsOf(options_);
  slam::ProductConfig product;
  readProduct(settings_, product);
  const auto parts = partsOf(product);
  const auto& own = partNamed(parts, options_.part);
  title_ = own.title;
  slam::FaultCollector faults;
  components_ = makeComponents(settings_, own.part, faults);
  faults.raise();
  const auto frames = components_.frames;
  const auto fill_in = [frames](auto& data) {
    frames.complete(data.odometry_frame, data.base_frame);
  };
  wiring_ = slam::Wiring(
      slam::Completions().add<slam::OdometrySample>(fill_in).add<slam::Motion>(fill_in));
  connect(components_, false, wiring_);
  wiring_.connect(settings_);
  connectInputs(parts);
  for (const auto& pipe : options_.to) connectOutput(pipe, partNamed(parts, pipe.first));
  if (!components_.estimator) return;
  for (const auto& input : options_.without) components_.estimator->intake().expectNothing(input);
  if (!options_.folder.empty()) writer_.emplace(options_.folder);
}

/// In the order in which data reach the component where the whole product is one process: what
/// others make of a value at once, in their order, the value itself, what those behind it make, and
/// at last the pose of a step.
void PartProcess::connectInputs(const std::vector<PartPorts>& parts) {
  inputs_ = wiring_.ports().open();
  const auto add = [&](const std::string& key, const std::string& title) {
    for (const auto& [from, descriptor] : options_.from)
      if (from == key) turns_.add({descriptor, title});
  };
  const auto own = std::find_if(parts.begin(), parts.end(),
                                [&](const PartPorts& part) { return part.key == options_.part; });
  const auto add_all = [&](auto begin, auto end) {
    for (; begin != end; ++begin)
      if (!begin->isBackend()) add(begin->key, "the " + begin->title);
  };
  add_all(parts.begin(), own);
  add(kBag, kTheBag);
  add_all(own, parts.end());
  for (const auto& part : parts)
    if (part.isBackend()) add(part.key, "the " + part.title);
  if (turns_.isEmpty())
    throw std::runtime_error("no pipe comes from a part that there is: give --from");
}

void PartProcess::connectOutput(const PartOptions::Pipe& pipe, const PartPorts& taker) {
  auto& output = outputs_.emplace_back(pipe.second, "the " + taker.title);
  for (const auto& made : wiring_.ports().parts().front().ports.outputs()) {
    const auto* input = slam::findPort(taker.inputs, made.name, made.kind);
    if (input == nullptr) continue;
    requirePersistent(*input, taker);
    wiring_.listen(made.name, made.kind,
                   [&output, name = made.name, kind = slam::nameOf(made.kind),
                    save = input->traits.save](const void* value) {
                     slam::ArchiveWriter archive;
                     save(value, archive);
                     output.put({Frame::Type::kDatum, name, kind, archive.take()});
                   });
  }
}

void PartProcess::take(const Frame& frame) {
  const auto input = std::find_if(inputs_.begin(), inputs_.end(), [&](const auto& port) {
    return port.name == frame.port && slam::nameOf(port.kind) == frame.kind;
  });
  if (input == inputs_.end() || input->traits.restore == nullptr)
    throw std::runtime_error("'" + frame.port + "' (" + frame.kind + ") comes by a pipe, but the " +
                             title_ + " does not take it: start both from one installation");
  const auto value = valueIn(frame, *input);
  wiring_.put(input->name, input->kind, value.get());
}

void PartProcess::step() {
  if (components_.estimator)
    stepEstimator();
  else
    warn(wiring_.step());
}

void PartProcess::stepEstimator() {
  using Clock = std::chrono::steady_clock;
  while (true) {
    const auto start = Clock::now();
    warn(wiring_.step());
    const auto time = std::chrono::nanoseconds(Clock::now() - start);
    const auto& done = components_.estimator->report();
    if (!done) return;
    if (writer_) writer_->write(*done);
    if (status_) report(report::kStep, StepDone{*done, time.count()});
  }
}

void PartProcess::warn(const slam::Status& status) {
  if (status.isOk()) return;
  if (status_)
    report(report::kWarning, status);
  else
    fmt::print(stderr, "warning: {}\n", status.message);
}

template <class T>
void PartProcess::report(const char* port, const T& value) {
  status_->put({Frame::Type::kDatum, port, slam::nameOf(slam::kindOf<T>()), bytesOf(value)});
}

PartSummary PartProcess::summary() const {
  PartSummary summary;
  summary.dropped = wiring_.ports().parts().front().component->dropped();
  summary.counters = wiring_.ports().parts().front().component->counters();
  for (const auto& gate : wiring_.gates()) {
    auto& counters = summary.gate_counters[gate->name()];
    counters.add(gate->counters());
    counters.add(gate->held());
    summary.gate_dropped[gate->name()] = gate->dropped();
  }
  if (!components_.estimator) return summary;
  const auto& estimator = *components_.estimator;
  const auto arrivals = estimator.intake().arrivals();
  summary.starving = arrivals.starving;
  summary.waiting = arrivals.held();
  if (writer_) {
    summary.folder = writer_->unfinished();
    summary.poses = writer_->lines();
  }
  const auto& backend = estimator.capabilities();
  if (const auto* mapper = backend.find<slam::LandmarkMapper>())
    summary.landmarks = mapper->landmarks().size();
  if (const auto* mapper = backend.find<slam::GridMapper>()) summary.grid = mapper->grid();
  if (const auto* calibrator = backend.find<slam::Calibrator>())
    if (const auto known = calibrator->calibration())
      summary.calibration = calibrator->calibrationConfig().sentencesOn(*known);
  return summary;
}

/// The files are written when all processes have come to the end of the data.
void PartProcess::finish() {
  if (!status_) return write({options_.folder, settings_.inForce()});
  report(report::kSummary, summary());
  const auto frame = turns_.behindEnd(kTheBag);
  if (frame.port != report::kFinish)
    throw std::runtime_error("'" + frame.port +
                             "' comes behind the end of the data: start both of "
                             "the pipe's ends from one installation");
  write(valueOf<Finish>(frame.value));
  status_->put({Frame::Type::kEnd, "", "", ""});
}

void PartProcess::write(const Finish& finish) {
  for (const auto& [name, module] : components_.modules)
    if (!finish.folder.empty()) module->save(finish.folder);
  if (!writer_) return;
  const auto& backend = components_.estimator->capabilities();
  const auto robot_text = [this] { return slam::readInputFile(options_.robot, "the robot file"); };
  const auto fault =
      slam::tuning::saveCalibration(backend, settings_, robot_text, writer_->unfinished());
  if (!fault.empty()) warn(slam::Status::warning(fault));
  writer_->finish(backend, components_.frames.map, finish.config);
}

}  // namespace slam_pipes
