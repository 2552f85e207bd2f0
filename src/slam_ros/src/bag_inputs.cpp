// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/bag_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "slam_core/common/nearest_name.hpp"
#include "slam_ros/input_bindings.hpp"

namespace slam_ros {
namespace {

using Found = BagInputs::Found;

bool isTrigger(const slam::InputPort& input) { return input.time == slam::TimeRole::kTrigger; }
bool isMandatory(const slam::InputPort& input) { return input.is_mandatory; }

/// Whether the input goes by this name, its own or that of one of its topics.
bool isOf(const Found& found, const Input& name) {
  const auto names = found.input->names();
  return std::any_of(names.begin(), names.end(), [&](const Input& own) {
    return own.name == name.name && own.type == name.type;
  });
}

/// The inputs that robot files have names for and those of the product, so far as bindings know
/// their kinds.
std::vector<Found> candidates(const slam::DataFlow& flow, const BagContext& context) {
  const auto& bindings = InputBindings::instance();
  std::vector<Found> all;
  const auto add = [&](const std::string& port, slam::Kind kind) {
    const bool is_known = std::any_of(all.begin(), all.end(), [&](const Found& other) {
      return other.port == port && other.kind == kind;
    });
    if (!is_known && bindings.has(kind))
      all.push_back({port, kind, bindings.createInBag(context, port, kind)});
  };
  for (const auto& [port, kind] : TopicsConfig::inputs()) add(port, kind);
  for (const auto& part : flow.parts())
    for (const auto& input : part.inputs) add(input.name, input.kind);
  return all;
}

BagSearch searchOf(const BagReader& bag, const std::vector<Found>& candidates,
                   std::vector<Remap> remaps) {
  std::vector<Input> inputs;
  for (const auto& candidate : candidates) {
    for (auto& remap : remaps) remap = candidate.input->meaningOf(remap, bag.topics());
    for (auto& name : candidate.input->names()) inputs.push_back(std::move(name));
  }
  const auto read = [&bag](const auto& handlers, const auto& progress) {
    bag.read(handlers, progress);
  };
  return {bag.topics(), read, std::move(inputs), remaps};
}

}  // namespace

/// Goes through the components in the order of the data's flow and notes what it finds.
class BagInputs::Search {
 public:
  Search(const BagReader& bag, const BagContext& context, const std::vector<Remap>& remaps,
         BagInputs& inputs)
      : inputs_(inputs),
        flow_(inputs.flow_),
        candidates_(candidates(flow_, context)),
        bag_(searchOf(bag, candidates_, remaps)) {}

  void run() {
    for (const auto& part : flow_.parts()) {
      if (part.is_maker && !isNeeded(part)) {  // nobody needs what it takes
        if (!flow_.takenOutputs(part).empty()) inputs_.left_out_.push_back(part.key);
        continue;
      }
      if (part.is_maker && leavesOut(part))
        inputs_.left_out_.push_back(part.key);
      else
        for (const auto& input : part.inputs)
          if (!flow_.isMade(input)) find(input.name, input.kind);
    }
    inputs_.notes_ = std::move(bag_.notes);
    inputs_.warnings_ = std::move(bag_.warnings);
  }

  /// @throw TopicError for a remapping whose topic no input was found on
  void requireUseOfRemaps() const {
    for (const auto& chosen : bag_.chosen())
      if (!isUsed(chosen))
        throw TopicError(fmt::format("the remapping {} would have no effect: {}; leave it out",
                                     textOf(chosen.remap), whyUnused(chosen)));
  }

  /// What the product cannot do without, a text each.
  std::vector<std::string> missing() const {
    std::vector<std::string> all;
    for (const auto& part : inputs_.parts())
      for (const auto& text : missingOf(part))
        if (std::find(all.begin(), all.end(), text) == all.end()) all.push_back(text);
    return all;
  }

 private:
  /// Whether anyone takes what a component makes who is not left out himself.
  bool isNeeded(const slam::DataFlow::Part& part) const {
    const auto takes_any = [&part](const slam::DataFlow::Part& taker) {
      return std::any_of(part.outputs.begin(), part.outputs.end(), [&](const auto& output) {
        return taker.input(output.name, output.kind) != nullptr;
      });
    };
    const auto& parts = flow_.parts();
    return std::any_of(parts.begin(), parts.end(), [&](const slam::DataFlow::Part& taker) {
      return takes_any(taker) && (!taker.is_maker || (isNeeded(taker) && !isCarried(taker)));
    });
  }

  /// Whether the bag has all that others take of what a component makes, and it is to be used.
  bool isCarried(const slam::DataFlow::Part& part) const {
    if (isAskedFor(part) || sharedInput(part) != nullptr) return false;
    const auto outputs = flow_.takenOutputs(part);
    return carries(outputs, Names::kOwn) || (!hasSources(part) && carries(outputs, Names::kAny));
  }

  /// The same; what the bag has is among those found then, and a note says which is used.
  bool leavesOut(const slam::DataFlow::Part& part) {
    const auto outputs = flow_.takenOutputs(part);
    if (!isCarried(part)) {
      const auto* shared = isAskedFor(part) ? nullptr : sharedInput(part);
      if (shared != nullptr && carries(outputs, Names::kOwn))
        noteThatIsMade(part, outputs, *shared);
      return false;
    }
    for (const auto& output : outputs) find(output.name, output.kind);
    noteThatIsLeftOut(part, outputs);
    return true;
  }

  bool isAskedFor(const slam::DataFlow::Part& part) const {
    const auto inputs = flow_.inputsOfAlone(part);
    return std::any_of(inputs.begin(), inputs.end(), [&](const auto& input) {
      const auto* candidate = candidateFor(input.name, input.kind);
      return candidate != nullptr && candidate->input->isAskedFor(bag_);
    });
  }

  /// An input of the component that the bag has and others take as well, or null: the component
  /// makes its data of that, whatever else the bag carries.
  const slam::InputPort* sharedInput(const slam::DataFlow::Part& part) const {
    for (const auto& input : part.inputs)
      if (!flow_.isMade(input) && !isOfAlone(part, input) &&
          has(input.name, input.kind, Names::kAny))
        return &input;
    return nullptr;
  }

  bool carries(const std::vector<slam::OutputPort>& outputs, Names names) const {
    return std::all_of(outputs.begin(), outputs.end(),
                       [&](const auto& output) { return has(output.name, output.kind, names); });
  }

  /// Whether the component can make its data of what the bag has.
  bool hasSources(const slam::DataFlow::Part& part) const {
    bool has_any = false;
    for (const auto& input : part.inputs) {
      const bool is_there = flow_.isMade(input) || has(input.name, input.kind, Names::kAny);
      if (input.is_mandatory && !is_there) return false;
      has_any = has_any || is_there;
    }
    return has_any;
  }

  bool isOfAlone(const slam::DataFlow::Part& part, const slam::InputPort& input) const {
    const auto alone = flow_.inputsOfAlone(part);
    return std::any_of(alone.begin(), alone.end(),
                       [&](const auto& other) { return other.name == input.name; });
  }

  void noteThatIsMade(const slam::DataFlow::Part& part,
                      const std::vector<slam::OutputPort>& outputs, const slam::InputPort& input) {
    for (const auto& output : outputs)
      bag_.notes.push_back(
          fmt::format("the {} that the bag carries is left out: the {} makes it of the input '{}', "
                      "which others take as well",
                      output.name, part.role, input.name));
  }

  void noteThatIsLeftOut(const slam::DataFlow::Part& part,
                         const std::vector<slam::OutputPort>& outputs) {
    std::vector<std::string> names;
    for (const auto& output : outputs) names.push_back(output.name);
    auto note =
        fmt::format("the bag carries {}: the {} is left out", slam::join(names), part.title());
    for (const auto& input : flow_.inputsOfAlone(part)) {
      const auto* candidate = candidateFor(input.name, input.kind);
      const auto how = candidate == nullptr ? "" : candidate->input->howToAsk();
      if (!how.empty()) note += "; " + how;
    }
    bag_.notes.push_back(note);
  }

  const Found* candidateFor(const std::string& port, slam::Kind kind) const {
    const auto found = std::find_if(
        candidates_.begin(), candidates_.end(),
        [&](const Found& candidate) { return candidate.port == port && candidate.kind == kind; });
    return found == candidates_.end() ? nullptr : &*found;
  }

  /// Whether the bag has the input. What the search for it notes counts only once it is used.
  bool has(const std::string& port, slam::Kind kind, Names names) const {
    if (inputs_.find(port, kind) != nullptr) return true;
    const auto* candidate = candidateFor(port, kind);
    auto trial = bag_;
    trial.names = names;
    return candidate != nullptr && candidate->input->find(trial);
  }

  /// Whether the bag has the input; from then on it is among those found.
  bool find(const std::string& port, slam::Kind kind) {
    if (inputs_.find(port, kind) != nullptr) return true;
    const auto* candidate = candidateFor(port, kind);
    if (candidate == nullptr || !candidate->input->find(bag_)) return false;
    const auto at = candidates_.begin() + (candidate - candidates_.data());
    inputs_.found_.push_back(std::move(*at));
    candidates_.erase(at);
    return true;
  }

  std::string needOf(const slam::InputPort& input) const {
    return input.sentence + ": " + candidateFor(input.name, input.kind)->input->need();
  }

  std::vector<std::string> missingOf(const slam::DataFlow::Part& part) const {
    std::vector<std::string> missing;
    for (const auto& input : part.inputs)
      if (input.is_mandatory && candidateFor(input.name, input.kind) && !flow_.isMade(input))
        missing.push_back(needOf(input));
    if (!part.is_maker || missing.empty()) return missing;
    // A bag may well carry what triggers steps. Of other data, such as motion, it has the sources,
    // and so it has of what a stage makes.
    std::vector<std::string> instead;
    bool is_needed = false;
    for (const auto& output : flow_.takenOutputs(part)) {
      const auto takers = flow_.takersOf(output);
      const auto trigger = std::find_if(takers.begin(), takers.end(), isTrigger);
      is_needed = is_needed || std::any_of(takers.begin(), takers.end(), isMandatory);
      if (trigger != takers.end() && candidateFor(trigger->name, trigger->kind))
        instead.push_back(needOf(*trigger));
    }
    if (!is_needed) return {};
    if (instead.empty() || part.role == slam::Stage::kRole) return missing;
    return {slam::join(instead) + ", or " + slam::join(missing, " and ")};
  }

  bool isUsed(const ChosenTopic& chosen) const {
    return std::any_of(inputs_.found_.begin(), inputs_.found_.end(), [&](const Found& found) {
      const auto topics = found.input->topics();
      return isOf(found, chosen.input) &&
             std::find(topics.begin(), topics.end(), chosen.topic) != topics.end();
    });
  }

  /// One clause on a remapping that is not used.
  std::string whyUnused(const ChosenTopic& chosen) const {
    for (const auto& found : inputs_.found_)
      if (isOf(found, chosen.input))
        return fmt::format("the input '{}' comes from {}", found.port,
                           slam::join(found.input->topics()));
    for (const auto& candidate : candidates_)
      if (isOf(candidate, chosen.input))
        for (const auto& part : flow_.parts())
          if (part.makes(candidate.port, candidate.kind) && !inputs_.isLeftOut(part.key))
            return fmt::format("the {} makes what the input '{}' takes in", part.title(),
                               candidate.port);
    return fmt::format("no component of the product takes the input '{}'", chosen.input.name);
  }

  BagInputs& inputs_;
  const slam::DataFlow& flow_;
  std::vector<Found> candidates_;  ///< that have not been found
  BagSearch bag_;
};

BagInputs::BagInputs(const BagReader& bag, const slam::ProductComponents& product,
                     const BagContext& context, const std::vector<Remap>& remaps)
    : flow_(product) {
  Search search(bag, context, remaps, *this);
  search.run();
  search.requireUseOfRemaps();
  if (const auto missing = search.missing(); !missing.empty())
    throw TopicError(fmt::format("the bag {} lacks {}; it has {}", bag.path(),
                                 slam::join(missing, " and "), listTopics(bag.topics())));
  requireSensorsOfTheirOwn(bag);
}

/// A bag with one camera has no images for the rear one, although their type would fit, nor has one
/// with the observations of one detector those of a second one.
void BagInputs::requireSensorsOfTheirOwn(const BagReader& bag) const {
  for (const auto& found : found_)
    for (const std::string prefix : {"rear_second_", "rear_", "second_"}) {
      if (found.port.rfind(prefix, 0) != 0) continue;
      const auto other = found.port.substr(prefix.size());
      const auto own = found.input->topics(), of_other = topicsOf(other);
      if (!own.empty() && !of_other.empty() && own.front() == of_other.front())
        throw TopicError(
            fmt::format("the bag {} has no data of {}, only of {} on {}: name their topic with "
                        "--remap {}:=TOPIC, or leave the second detector or sensor out of the "
                        "product",
                        bag.path(), found.port, other, own.front(), found.port));
    }
}

const Found* BagInputs::find(const std::string& port, slam::Kind kind) const {
  const auto found = std::find_if(found_.begin(), found_.end(), [&](const Found& input) {
    return input.port == port && input.kind == kind;
  });
  return found == found_.end() ? nullptr : &*found;
}

std::vector<std::string> BagInputs::topicsOf(const std::string& port) const {
  for (const auto& found : found_)
    if (found.port == port) return found.input->topics();
  return {};
}

bool BagInputs::isLeftOut(const std::string& key) const {
  return std::find(left_out_.begin(), left_out_.end(), key) != left_out_.end();
}

std::vector<slam::DataFlow::Part> BagInputs::parts() const {
  auto parts = flow_.parts();
  parts.erase(std::remove_if(parts.begin(), parts.end(),
                             [this](const auto& part) { return isLeftOut(part.key); }),
              parts.end());
  return parts;
}

bool BagInputs::isSupplied(const slam::InputPort& input) const {
  if (find(input.name, input.kind) != nullptr) return true;
  const auto parts = this->parts();
  return std::any_of(parts.begin(), parts.end(), [&](const slam::DataFlow::Part& part) {
    return part.makes(input.name, input.kind) &&
           std::all_of(part.inputs.begin(), part.inputs.end(), [&](const auto& source) {
             return !source.is_mandatory || isSupplied(source);
           });
  });
}

void BagInputs::add(BagHandlers more, BagHandlers& handlers) {
  for (auto& [topic, handler] : more) {
    auto& there = handlers[topic];
    if (!there)
      there = std::move(handler);
    else
      there = [first = there, second = std::move(handler)](const BagMessage& message) {
        first(message);
        second(message);
      };
  }
}

}  // namespace slam_ros
