// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/bag_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "slam_ros/progress_message.hpp"

namespace slam_ros {
namespace {

constexpr const char* kForPointMap = " for the point map";
constexpr const char* kMotionForPointMap = "motion for the point map";
constexpr const char* kPosesForPointMap = "poses for the point map";

/// Whether a component makes its data of what another one makes.
bool hasChain(const BagInputs& inputs) {
  const auto parts = inputs.parts();
  return std::any_of(parts.begin(), parts.end(), [&](const slam::DataFlow::Part& part) {
    return part.is_maker &&
           std::any_of(part.inputs.begin(), part.inputs.end(),
                       [&](const auto& input) { return inputs.flow().isMade(input); });
  });
}

/// Counts the inputs that have data and that steps are taken for.
std::size_t triggers(const BagInputs& inputs) {
  const auto& triggers = inputs.flow().triggersOfBackend();
  return static_cast<std::size_t>(
      std::count_if(triggers.begin(), triggers.end(),
                    [&](const auto& input) { return inputs.isSupplied(input); }));
}

}  // namespace

BagFlow::BagFlow(const BagInputs& inputs, Options options)
    : inputs_(inputs), options_(std::move(options)) {
  for (const auto& found : inputs_.found()) limit(found);
  has_chain_ = hasChain(inputs_);
  if (triggers(inputs_) > 1 || has_chain_) max_ahead_ = options_.source_timeout / 2;
}

void BagFlow::limit(const BagInputs::Found& found) {
  const auto play = found.input->play();
  for (const auto& answer : answersTo(found)) {
    const auto [entry, is_new] = limits_.emplace(answer, play.in_flight);
    entry->second = std::min(entry->second, play.in_flight);
    window_.limit(answer, entry->second);
    if (play.held > 0) held_[answer] = play.held;
  }
}

/// Names the acknowledgements that follow once a message of the input has been taken.
std::vector<std::string> BagFlow::answersTo(const BagInputs::Found& found) const {
  std::vector<std::string> answers;
  bool is_of_module = false;
  for (const auto& part : inputs_.parts()) {
    const auto* input = part.input(found.port, found.kind);
    if (input == nullptr) continue;
    if (part.is_backend) answers.push_back(progressName(found.port));
    if (part.is_maker && isWaitedFor(found, part))
      for (const auto& output : inputs_.flow().lastOutputs(part))
        answers.push_back(progressName(output.name));
    const bool is_trigger = input->time == slam::TimeRole::kTrigger;
    is_of_module = is_of_module || (part.isModule() && is_trigger);
  }
  const auto own = progressName(found.port);
  if (is_of_module && options_.has_point_map)
    answers.insert(answers.begin(), own + kForPointMap);
  else if (is_of_module && answers.empty())
    answers.push_back(own);  // in one process it is the product's nodelet that takes them
  return answers;
}

/// Whether the input is the one whose messages the flow waits for. Among the inputs that a
/// component makes its data of, these are the ones with the largest messages; the others are sent
/// in between. So is what only carries time forward between the triggers that others make.
bool BagFlow::isWaitedFor(const BagInputs::Found& found, const slam::DataFlow::Part& maker) const {
  const auto* taken = maker.input(found.port, found.kind);
  const bool has_triggers =
      std::any_of(maker.inputs.begin(), maker.inputs.end(),
                  [](const auto& input) { return input.time == slam::TimeRole::kTrigger; });
  if (taken->time == slam::TimeRole::kCarrier && has_triggers) return false;
  const auto in_flight = found.input->play().in_flight;
  return std::all_of(inputs_.found().begin(), inputs_.found().end(),
                     [&](const BagInputs::Found& other) {
                       return maker.input(other.port, other.kind) == nullptr ||
                              other.input->play().in_flight >= in_flight;
                     });
}

BagInput::Gate BagFlow::gateOf(const BagInputs::Found& found) {
  return [this, answers = answersTo(found)](slam::Stamp stamp) {
    return std::all_of(answers.begin(), answers.end(),
                       [&](const auto& answer) { return waitForRoom(answer, stamp); });
  };
}

/// Lets no source run ahead of the one whose data take longest, which would be taken for a silent
/// one. Where that one is not acknowledged at all, nobody waits for it any more.
void BagFlow::waitForSlowest(slam::Stamp stamp) {
  if (!max_ahead_ || window_.waitForAllBefore(stamp - *max_ahead_, options_.patience) || stopped_)
    return;
  options_.warn(fmt::format(
      "messages sent {:g} s of the bag's time ago were not acknowledged for {:g} s; from "
      "now on the inputs are no longer kept within that time of one another",
      slam::seconds(*max_ahead_), slam::seconds(options_.patience)));
  max_ahead_.reset();
}

bool BagFlow::waitForRoom(const std::string& answer, slam::Stamp stamp) {
  waitForSlowest(stamp);
  if (!window_.waitForRoom(answer, options_.patience) && !stopped_) {
    if (const auto held = held_.find(answer); held != held_.end()) {
      window_.limit(answer, held->second);  // calibration or mount may come later
      held_.erase(held);
      return waitForRoom(answer, stamp);
    }
    options_.warn(fmt::format("nothing of the {} sent was acknowledged for {:g} s; going on",
                              answer, slam::seconds(options_.patience)));
    window_.clear();
  }
  if (stopped_) return false;
  window_.sent(answer, stamp);
  if (has_chain_ && answer == progressName("motion")) last_motion_ = stamp;
  return true;
}

void BagFlow::acknowledge(const slam_msgs::Progress& message) {
  if (options_.has_point_map) expectOfPointMap(message);
  for (const auto& [input, newest] : progressOf(message)) window_.acknowledged(input, newest);
}

/// What the back-end has had and has reported must reach the point map as well.
void BagFlow::expectOfPointMap(const slam_msgs::Progress& message) {
  // it may have been faster than this message
  if (message.motion > told_.motion && message.motion > point_map_told_.motion)
    window_.sent(kMotionForPointMap, fromRos(message.motion));
  if (message.step > told_.step && message.step > point_map_told_.step)
    window_.sent(kPosesForPointMap, fromRos(message.step));
  told_ = message;
}

void BagFlow::acknowledgeOfPointMap(const slam_msgs::Progress& message) {
  point_map_told_ = message;
  for (const auto& [input, newest] : progressOf(message))
    window_.acknowledged(input + kForPointMap, newest);
  window_.acknowledged(kPosesForPointMap, fromRos(message.step));
}

/// In a chain of components data beyond the last motion are never acknowledged: they wait for more
/// motion before the last component.
std::size_t BagFlow::finish() {
  const bool is_through =
      last_motion_ ? window_.waitForAllBefore(*last_motion_ + slam::Duration(1), options_.patience)
                   : window_.waitUntilEmpty(options_.patience);
  return is_through || stopped_ ? 0 : window_.inFlight();
}

void BagFlow::stop() {
  stopped_ = true;
  window_.stop();
}

}  // namespace slam_ros
