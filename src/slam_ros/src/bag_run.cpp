// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/bag_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "slam_core/common/config_error.hpp"
#include "slam_ros/known_inputs.hpp"
#include "slam_ros/map_folder.hpp"
#include "slam_ros/product_files.hpp"

namespace slam_ros {

std::string robotOf(const BagRunOptions& options, const BagReader& bag) {
  if (!options.robot.empty()) return options.robot;
  if (const auto name = bag.robot(); !name.empty()) return name;
  throw UnknownName("the bag " + bag.path() + " does not name its robot; give one with --robot");
}

slam::Settings settingsFor(const BagRunOptions& options, const BagReader& bag) {
  const auto product = productFile(options.product);
  return {slam::loadConfigFile(product), slam::loadConfigFile(robotFile(robotOf(options, bag))),
          options.overrides};
}

TopicsConfig configured(slam::Settings& settings, slam::MetaCoordinator& product) {
  TopicsConfig topics;
  slam::FaultCollector faults;
  faults.attempt([&] { settings.read<FilesConfig>(); });
  faults.attempt([&] { topics = settings.read<TopicsConfig>(); });
  faults.attempt([&] { product.configure(settings); });
  faults.raise();
  requireKnownInputs(product.wiring());
  requireDistinctTopics(product.wiring(), topics);
  return topics;
}

namespace {

/// Whether it tells of the robot's surroundings: not only of its motion.
bool isSight(const BagInputs::Found& found, const BagInputs& inputs) {
  const auto parts = inputs.parts();
  return found.kind != slam::kindOf<slam::Motion>() &&
         std::any_of(parts.begin(), parts.end(), [&](const auto& part) {
           return part.input(found.port, found.kind) != nullptr &&
                  !part.makes("motion", slam::kindOf<slam::Motion>());
         });
}

/// What the first sensor lacked whose data nothing could be made of, where that is so of all that
/// see; else empty.
std::string blindness(const BagInputs& inputs) {
  std::string lack;
  for (const auto& found : inputs.found()) {
    if (!isSight(found, inputs)) continue;
    const auto lacking = found.input->lacking();
    if (lacking.empty()) return "";
    if (lack.empty()) lack = lacking;
  }
  return lack;
}

std::string firstLack(const BagInputs& inputs) {
  for (const auto& found : inputs.found())
    if (const auto lacking = found.input->lacking(); !lacking.empty()) return lacking;
  return "";
}

}  // namespace

void requireSteps(const RunMetrics& metrics, std::size_t poses, const BagInputs& inputs,
                  const BagReader& bag, const slam::Counters& counters) {
  const bool has_steps = metrics.updates() > 0;
  const auto lack = has_steps ? blindness(inputs) : firstLack(inputs);
  if (has_steps && lack.empty()) return;
  printCounts(counters);
  const std::string what =
      poses == 0 ? "no step could be taken: "
                 : "nothing that the sensors saw could be used, and odometry alone is no result: ";
  if (!lack.empty()) throw std::runtime_error(what + lack);
  throw std::runtime_error(
      fmt::format("{}no observation or scan of the bag {} has a stamp that its odometry covers",
                  what, bag.path()));
}

/// The last data of a bag may well come after the last odometry, and of a few in a hundred messages
/// the counts tell enough.
std::vector<std::string> sentencesOn(const UnusedData& unused) {
  std::vector<std::string> sentences;
  if (!unused.starving.empty()) {
    std::vector<std::string> held;
    for (const auto& [what, count] : unused.held.all())
      held.push_back(fmt::format("{} messages of {}", count, what));
    sentences.push_back(fmt::format("{} were never used: {} that does not come",
                                    slam::join(held, " and "), unused.starving));
  }
  if (unused.set_aside > 0)
    sentences.push_back(
        fmt::format("{} messages at the end were not used: their stamps are from before those of "
                    "the messages before them",
                    unused.set_aside));
  if (unused.dropped * 20 > unused.messages)
    sentences.push_back(fmt::format("{} of {} messages had no effect; the counts below tell why",
                                    unused.dropped, unused.messages));
  return sentences;
}

void printCounts(const slam::Counters& counters) {
  std::vector<std::string> counts;
  for (const auto& [reason, count] : counters.all())
    counts.push_back(fmt::format("{} {}", reason, count));
  if (!counts.empty()) fmt::print("counted: {}\n", slam::join(counts));
}

}  // namespace slam_ros
