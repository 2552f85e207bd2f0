// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/offline_run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "slam_core/common/atomic_file.hpp"
#include "slam_core/common/input_file.hpp"
#include "slam_core/contract/calibrator.hpp"
#include "slam_core/contract/correction_reporter.hpp"
#include "slam_core/contract/grid_mapper.hpp"
#include "slam_core/contract/session_keeper.hpp"
#include "slam_core/product/map_files.hpp"
#include "slam_core/product/map_fragment.hpp"
#include "slam_core/tuning/calibrated_robot.hpp"
#include "slam_ros/bag_transforms.hpp"
#include "slam_ros/conversions.hpp"
#include "slam_ros/ground_truth.hpp"
#include "slam_ros/product_files.hpp"

namespace slam_ros {
namespace {

constexpr std::uint64_t kFewUpdates = 20;  // so few may correct nothing in a good run
constexpr double kMuchDoubt = 0.1;         // share of the time

}  // namespace

OfflineRun::OfflineRun(const OfflineOptions& options)
    : options_(options),
      progress_(std::cerr, ::isatty(STDERR_FILENO) == 1),
      bag_(options.bag),
      settings_(settingsFor(options, bag_)) {
  configure();
  const auto& begins_with = {options.load_map, options.load_session, options.merge_session};
  if (options.resumes && std::any_of(begins_with.begin(), begins_with.end(),
                                     [](const auto& file) { return !file.empty(); }))
    throw std::runtime_error(
        "a checkpoint holds what its run began with: leave out --load-map, --load-session and "
        "--merge-session");
  if (!options.load_map.empty()) loadMap();
  if (!options.load_session.empty()) loadSession();
  if (!options.merge_session.empty()) mergeSession();
  if (!options.save_session.empty()) requireSession();
}

void OfflineRun::configure() {
  const auto topics = configured(settings_, coordinator_);
  const auto& parts = coordinator_.components();
  inputs_.emplace(bag_, parts, BagContext{topics, parts.frames, GivenMounts(settings_)},
                  parseRemaps(options_.remaps));
  for (const auto& trigger : inputs_->flow().triggersOfBackend())
    if (!inputs_->isSupplied(trigger))
      coordinator_.estimator().intake().expectNothing(trigger.name);
}

std::string OfflineRun::mapFrame() const { return frameId(coordinator_.components().frames.map); }

void OfflineRun::loadMap() {
  const bool has_grid = coordinator_.estimator().capabilities().find<slam::GridMapper>() != nullptr;
  const auto map = slam::loadMap(options_.load_map, mapFrame(), has_grid).map;
  if (has_grid && !map.grid)
    warn("no grid found at " + options_.load_map + "; the grid begins empty");
  if (!map.landmarks.empty() && map.joint_covariance.size() == 0)
    warn(options_.load_map + " has no joint covariance; its marginals are inflated");
  const auto status = coordinator_.estimator().startWith(map);
  if (status.level == slam::Status::Level::kError)
    throw std::runtime_error("cannot use the map " + options_.load_map + ": " + status.message);
  if (!status.isOk()) warn(options_.load_map + ": " + status.message);
}

void OfflineRun::loadSession() {
  const auto& path = options_.load_session;
  if (!options_.load_map.empty())
    throw std::runtime_error(
        "a session holds its map: give --load-map or --load-session, not both");
  const auto status = coordinator_.estimator().startWith(
      slam::SavedSession{slam::readInputFile(path, "the session")});
  if (status.level == slam::Status::Level::kError)
    throw std::runtime_error("cannot use the session " + path + ": " + status.message);
  if (!status.isOk()) warn(path + ": " + status.message);
}

void OfflineRun::mergeSession() {
  const auto& path = options_.merge_session;
  const auto status =
      merge(slam::SavedSession{slam::readInputFile(path, "the session")}, coordinator_.estimator());
  if (!status.isOk())
    throw std::runtime_error("cannot use the session " + path + ": " + status.message);
}

std::string OfflineRun::session() const {
  const auto* keeper = coordinator_.estimator().capabilities().find<slam::SessionKeeper>();
  if (keeper == nullptr)
    throw std::runtime_error(
        "the back-end of this product keeps no session: use the graph, or leave out "
        "--save-session");
  return keeper->session().bytes;
}

/// Reports before the run what would keep the session from being saved.
void OfflineRun::requireSession() const {
  session();
  slam::requireWritable(options_.save_session);
}

void OfflineRun::run() {
  for (const auto& note : inputs_->notes()) fmt::print("{}\n", note);
  for (const auto& warning : inputs_->warnings()) warn(warning);
  using Start = slam::RunWriter::Start;
  slam::RunWriter writer(options_.folder, options_.resumes ? Start::kResumed : Start::kAnew);
  autosave_ = slam::Autosave(options_.autosave.value_or(0.0));
  if (options_.resumes) resume(writer);
  read(writer);
  requireSteps(metrics_, writer.lines(), *inputs_, bag_, counters());
  warnOfNoCorrection();
  if (writer.lines() == 1)
    warn(
        "one step could be taken in the whole bag, so that the path is a single pose; `rosbag "
        "info` "
        "and the counts below show which sensor lacks messages");
  const auto truth = writeGroundTruth(bag_, writer.unfinished());
  if (const auto& source = coordinator_.components().odometry;
      source && slam::ownsOdometryEdge(*source) && !inputs_->isLeftOut("odometry"))
    writeWheelOdometry(bag_, writer.unfinished());
  const auto& backend = coordinator_.estimator().capabilities();
  for (const auto& [name, module] : coordinator_.components().modules)
    module->save(writer.unfinished());
  metrics_.setGrid(backend);
  slam::writeFileAtomically(writer.unfinished() + "/metrics.json",
                            options_.origin.addedToMetrics(metrics_.toJson(
                                bag_.end() - bag_.begin(), coordinator_.dropped())));
  if (!options_.save_session.empty()) slam::writeFileAtomically(options_.save_session, session());
  const auto robot_text = [this] {
    return slam::readInputFile(robotFile(robotOf(options_, bag_)), "the robot file");
  };
  if (const auto fault =
          slam::tuning::saveCalibration(backend, settings_, robot_text, writer.unfinished());
      !fault.empty())
    warn(fault);
  writer.finish(backend, coordinator_.components().frames.map,
                options_.origin.addedToConfig(settings_.inForce()));
  printSummary(writer);
  if (truth.poses == 0) fmt::print("the bag holds no true trajectory to compare with\n");
}

slam::RunIdentity OfflineRun::identity() const {
  std::size_t messages = 0;
  for (const auto& topic : bag_.topics()) messages += topic.messages;
  const auto data = fmt::format("{} bytes with {} messages from {} to {} ns",
                                std::filesystem::file_size(bag_.path()), messages,
                                slam::nanoseconds(bag_.begin()), slam::nanoseconds(bag_.end()));
  return {coordinator_.components().product.product, robotOf(options_, bag_), data,
          settings_.inForce() + slam::join(inputs_->notes(), "\n")};
}

/// What the handlers of messages know is not saved: they see the messages again.
void OfflineRun::resume(slam::RunWriter& writer) {
  const auto path = writer.unfinished() + "/" + slam::RunFolder::kCheckpoint;
  try {
    const auto state = slam::stateIn(slam::readInputFile(path, "the checkpoint"), identity());
    slam::ArchiveReader archive(state);
    std::string of_product;
    double interval = 0.0;
    archive(resumed_, interval, last_step_, was_corrected_, of_product, metrics_);
    slam::restore(of_product, coordinator_);
    writer.restoreState(archive);
    autosave_ = slam::Autosave(options_.autosave.value_or(interval));
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("cannot resume from " + path + ": " + error.what());
  }
  fmt::print("{}: goes on after {} messages, at {:.3f} s\n", writer.folder(), resumed_,
             slam::seconds(last_step_ - bag_.begin()));
}

void OfflineRun::save(slam::RunWriter& writer) {
  const auto path = writer.unfinished() + "/" + slam::RunFolder::kCheckpoint;
  const auto fault = autosave_.save(last_step_, path, [&] {
    slam::ArchiveWriter archive;
    archive(messages_, autosave_.interval(), last_step_, was_corrected_,
            slam::stateOf(coordinator_), metrics_);
    writer.saveState(archive);
    return slam::checkpointOf(identity(), archive.take());
  });
  if (!fault.empty()) warn(fault, true);
}

void OfflineRun::stop(slam::RunWriter& writer) {
  save(writer);
  throw std::runtime_error("stopped after " + std::to_string(messages_) +
                           " messages: go on with --resume " + writer.folder());
}

void OfflineRun::read(slam::RunWriter& writer) {
  if (const auto title = slam::notResumable(coordinator_.wiring());
      autosave_.isOn() && !title.empty()) {
    warn("no checkpoints are written: the " + title + " cannot be resumed yet", true);
    autosave_ = slam::Autosave();
  }
  const auto handlers = this->handlers();
  progress_.begin(bag_.path(), bag_.messages(handlers));
  const auto take = [&](std::size_t done) {
    const bool is_known = isResuming();
    messages_ = done;
    if (!is_known) drain(writer);
    if (!is_known && autosave_.isDue(last_step_)) save(writer);
    progress_.update(done);
    return !options_.is_stopped();
  };
  try {
    bag_.read(handlers, take);
  } catch (const std::runtime_error&) {
    if (!options_.is_stopped()) throw;  // else the process that reads was stopped as well
  }
  progress_.end();
  if (options_.is_stopped() && !isResuming() && autosave_.isOn()) stop(writer);
  tellOfUnused();
}

BagHandlers OfflineRun::handlers() {
  const auto transforms = staticTransforms(bag_, mapFrame());
  auto handlers = inputs_->readers([&](const BagInputs::Found& input) {
    auto sinks = sinksOf(input);
    sinks.static_transforms = transforms;
    return sinks;
  });
  for (auto& entry : handlers)
    entry.second = [this, handler = entry.second](const BagMessage& message) {
      arrival_ = RunMetrics::Clock::now();
      handler(message);
    };
  return handlers;
}

BagSinks OfflineRun::sinksOf(const BagInputs::Found& input) {
  const bool is_for_steps = inputs_->flow().leadsToSteps(input.port, input.kind);
  BagSinks sinks;
  sinks.put = [this, &input, is_for_steps](const slam::Datum& value, slam::Stamp stamp) {
    if (isResuming()) return;
    coordinator_.put(input.port, value.kind(), value.value());
    if (is_for_steps) metrics_.addFrontEnd(stamp, RunMetrics::Clock::now() - arrival_);
  };
  sinks.warn = [this](const std::string& sentence) { warn(sentence); };
  sinks.count = [this](const std::string& reason) { input_counters_.add(reason); };
  return sinks;
}

void OfflineRun::tellOfUnused() {
  const auto arrivals = coordinator_.estimator().intake().arrivals();
  UnusedData unused;
  unused.dropped = coordinator_.dropped();
  unused.messages = messages_;
  unused.set_aside = coordinator_.estimator().counters()["set_aside"];
  unused.held = arrivals.held();
  unused.starving = arrivals.starving;
  for (const auto& sentence : sentencesOn(unused)) warn(sentence);
}

void OfflineRun::warnOfNoCorrection() {
  if (!was_corrected_ && metrics_.updates() >= kFewUpdates)
    warn(
        "nothing that the sensors saw has corrected the pose, which is odometry's alone: check the "
        "mounts, the calibration, and the parameters that were changed");
}

/// A back-end that does not report what corrects its pose is taken to be corrected.
void OfflineRun::noteCorrection(const slam::StepReport& report) {
  const auto& capabilities = coordinator_.estimator().capabilities();
  const auto* reporter = capabilities.find<slam::CorrectionReporter>();
  const bool reports = reporter != nullptr || capabilities.find<slam::LandmarkMapper>() != nullptr;
  was_corrected_ = was_corrected_ || !reports || report.statistics.used > 0 ||
                   (reporter != nullptr && reporter->correctedBy());
}

void OfflineRun::drain(slam::RunWriter& writer) {
  while (true) {
    const auto start = RunMetrics::Clock::now();
    const auto status = coordinator_.execute();
    const auto time = RunMetrics::Clock::now() - start;
    if (!status.isOk()) warn(status.message, status.isUrgent());
    const auto& report = coordinator_.estimator().report();
    if (!report) return;
    last_step_ = report->stamp;
    if (report->restarted) warn(kStampsWentBack);
    if (report->hasTrigger()) {
      metrics_.addUpdate(time);
      metrics_.addLatency(report->stamp, time);
      metrics_.addTrust(report->stamp, report->trust);
    }
    noteCorrection(*report);
    metrics_.addEvents(*report);
    writer.write(*report);
  }
}

void OfflineRun::warn(const std::string& sentence, bool is_urgent) {
  if (isResuming()) return;  // it was said when the message came first
  const auto line = warnings_.add(sentence, is_urgent);
  if (line.empty()) return;
  progress_.clear();
  fmt::print(stderr, "warning: {}\n", line);
}

slam::Counters OfflineRun::counters() const {
  auto counters = coordinator_.counters();
  counters.add(input_counters_);
  counters.add(slam::heldAtGates(coordinator_.wiring()));
  for (const auto& [what, count] : coordinator_.estimator().intake().arrivals().held().all())
    counters.add("never_stepped", count);
  return counters;
}

void OfflineRun::printSummary(const slam::RunWriter& writer) const {
  const double data_time = slam::seconds(bag_.end() - bag_.begin());
  const double wall = metrics_.wallSeconds();
  const auto* mapper = coordinator_.estimator().capabilities().find<slam::LandmarkMapper>();
  fmt::print("{}: {} poses, {} landmarks, {:.1f} s of data in {:.2f} s\n", writer.folder(),
             writer.lines(), mapper ? mapper->landmarks().size() : 0, data_time, wall);
  printCounts(counters());
  for (const auto& line : warnings_.summary()) fmt::print("{}\n", line);
  if (const double share = metrics_.doubtfulShare(); share >= kMuchDoubt)
    fmt::print("in doubt for {:.0f} % of the time: {}/events.csv holds when and why\n",
               100.0 * share, writer.folder());
  if (const auto* fragment = coordinator_.estimator().capabilities().find<slam::MapFragment>())
    if (const auto unmerged = fragment->unmerged().size(); unmerged > 0)
      fmt::print("not merged, and no part of the map: {}/{}1.session{}\n", writer.folder(),
                 slam::RunFolder::kUnmerged, unmerged > 1 ? fmt::format(" to {}", unmerged) : "");
  if (const auto* calibrator = coordinator_.estimator().capabilities().find<slam::Calibrator>())
    if (const auto known = calibrator->calibration())
      for (const auto& line : calibrator->calibrationConfig().sentencesOn(*known))
        fmt::print("{}\n", line);
}

}  // namespace slam_ros
