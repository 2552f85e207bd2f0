// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/observation_intake.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace slam {
namespace {

using Observations = std::vector<LandmarkObservation>;

/// Empty, or why nothing can be done with what such a sensor sees. @param pose T_base_sensor
std::string faultOfSensorPose(const Pose2& pose) {
  constexpr double kFarthestSensor =
      1000.0;  // from the robot [m]; squares of far more are no numbers
  if (!pose.isFinite())
    return "observations with a sensor pose that holds a value that is not a number are left out";
  if (pose.position().cwiseAbs().maxCoeff() > kFarthestSensor)
    return fmt::format(
        "observations with a sensor pose that is more than {:g} m from the robot are left out",
        kFarthestSensor);
  return "";
}

std::string leaveOutInvalid(Observations& all, Counters& counters) {
  std::string told;
  const auto is_invalid = [&](const LandmarkObservation& observation) {
    const auto fault = faultOf(observation);
    if (fault.empty()) return false;
    counters.add("invalid_observation");
    told = fault + "; it is left out";
    return true;
  };
  all.erase(std::remove_if(all.begin(), all.end(), is_invalid), all.end());
  return told;
}

/// @param size of all descriptors; 0 before the first one
std::string leaveOutDescriptors(Observations& all, Eigen::Index& size, Counters& counters) {
  std::string told;
  for (auto& z : all) {
    if (z.descriptor.isEmpty()) continue;
    auto fault = faultOf(z.descriptor);
    if (fault.empty() && size > 0 && z.descriptor.size() != size)
      fault = fmt::format(" has a descriptor of {} elements and those before had {}",
                          z.descriptor.size(), size);
    if (fault.empty()) {
      size = z.descriptor.size();
      continue;
    }
    z.descriptor = {};
    counters.add("invalid_descriptor");
    told = fmt::format("observation of landmark {}{}; the descriptor is left out", z.id, fault);
  }
  return told;
}

std::string leaveOutLines(Observations& all, Counters& counters) {
  const auto is_line = [](const LandmarkObservation& z) { return z.isLine(); };
  const auto lines = std::count_if(all.begin(), all.end(), is_line);
  if (lines == 0) return "";
  counters.add("line_observation", static_cast<std::uint64_t>(lines));
  all.erase(std::remove_if(all.begin(), all.end(), is_line), all.end());
  return "observations of lines are left out, since this back-end maps points only: use "
         "backend=ekf";
}

/// Those without an id, which come first, go first.
std::string leaveOutBeyond(std::size_t most, Observations& sorted, Counters& counters) {
  if (sorted.size() <= most) return "";
  const auto told = fmt::format(
      "an array holds {} observations, more than the {} that one step takes in; the others are "
      "left out: check the detector",
      sorted.size(), most);
  counters.add("observations_beyond_limit", sorted.size() - most);
  const auto has_id = [](const LandmarkObservation& z) { return z.id != kUnknownId; };
  const auto with_id = std::find_if(sorted.begin(), sorted.end(), has_id);
  const auto excess = static_cast<std::ptrdiff_t>(sorted.size() - most);
  const auto without_id = std::min(excess, with_id - sorted.begin());
  sorted.erase(sorted.end() - (excess - without_id), sorted.end());
  sorted.erase(sorted.begin(), sorted.begin() + without_id);
  return told;
}

}  // namespace

std::string ObservationIntake::screen(LandmarkObservationArray& array, Counters& counters) {
  completeCovariances(sensor_, array);
  auto& all = array.observations;
  if (auto fault = faultOfSensorPose(array.sensor_pose); !fault.empty()) {
    counters.add("invalid_observation", all.size());
    all.clear();
    return fault;
  }
  const auto invalid = leaveOutInvalid(all, counters);
  correct(sensor_, array);
  const auto descriptors = leaveOutDescriptors(all, descriptor_size_, counters);
  const auto lines = takes_lines_ ? std::string() : leaveOutLines(all, counters);
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.id < b.id; });
  const auto beyond = leaveOutBeyond(kMostObservations, all, counters);
  if (!beyond.empty()) return beyond;
  if (!invalid.empty()) return invalid;
  if (!descriptors.empty()) return descriptors;
  return lines.empty() ? watchIds(all) : lines;
}

/// @return a warning, once, if the first kMostWithoutId arrays hold no id
std::string ObservationIntake::watchIds(const Observations& all) {
  constexpr std::size_t kMostWithoutId = 20;
  if (!misses_ids_ || all.empty()) return "";
  misses_ids_ = all.back().id == kUnknownId;  // they are sorted
  if (!misses_ids_ || ++arrays_without_id_ != kMostWithoutId) return "";
  return "no observation so far has an id, and ids are what this product associates by: use "
         "association=jcbb, or check the detector";
}

std::string ObservationIntake::admit(LandmarkObservationArray& array, Counters& counters) {
  std::size_t added = 0, left_out = 0;
  const auto is_beyond = [&](const LandmarkObservation& z) {
    if (z.id == kUnknownId || known_.count(z.id) > 0) return false;
    if (added == kMostNewLandmarks) return ++left_out > 0;
    ++added;
    known_.insert(z.id);
    return false;
  };
  auto& all = array.observations;
  all.erase(std::remove_if(all.begin(), all.end(), is_beyond), all.end());
  counters.add("new_landmarks_beyond_limit", left_out);
  if (left_out == 0) return "";
  return fmt::format(
      "an array holds {} new landmarks, more than the {} that one step adds; the others wait for "
      "the next array that sees them: check the detector",
      added + left_out, kMostNewLandmarks);
}

void ObservationIntake::knowOnly(const LandmarkMap& map) {
  known_.clear();
  descriptor_size_ = 0;
  for (const auto& landmark : map) known_.insert(landmark.id);
}

}  // namespace slam
