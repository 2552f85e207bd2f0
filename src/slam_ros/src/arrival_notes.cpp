// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_ros/arrival_notes.hpp"

#include "slam_ros/conversions.hpp"
#include "slam_ros/progress_message.hpp"

namespace slam_ros {

ArrivalNotes::ArrivalNotes(const slam::DataFlow& flow, const slam::Ports& of_backend) {
  for (const auto& part : flow.parts())
    for (const auto& input : part.inputs)
      if (!part.is_maker && input.traits.hold != nullptr &&
          of_backend.input(input.name, input.kind) == nullptr &&
          slam::findPort(inputs_, input.name, input.kind) == nullptr)
        inputs_.push_back(input);
}

void ArrivalNotes::take(const std::string& port, slam::Kind kind, const void* value) {
  if (const auto* input = slam::findPort(inputs_, port, kind))
    newest_[port] = input->traits.hold(value).stamp;
}

void ArrivalNotes::taken(const std::string& topic, const std::optional<slam::Stamp>& motion) {
  if (std::exchange(last_motion_, motion) != motion) motion_topic_ = topic;
}

void ArrivalNotes::acknowledge(const slam::Intake::Arrivals& arrivals,
                               slam_msgs::Progress& message) const {
  message.motion = toRos(arrivals.motion.value_or(slam::Stamp()));
  for (const auto& source : arrivals.triggers)
    if (newest_.count(source.input) == 0)
      setProgress(message, source.input, source.last.value_or(slam::Stamp()));
  for (const auto& [input, stamp] : newest_) setProgress(message, input, stamp);
}

void ArrivalNotes::forget() {
  newest_.clear();
  last_motion_.reset();
  motion_topic_.clear();
}

}  // namespace slam_ros
