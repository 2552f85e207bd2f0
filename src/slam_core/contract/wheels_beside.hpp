// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "slam_core/contract/odometry_source.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/contract/waiting_data.hpp"
#include "slam_core/models/motion_track.hpp"

namespace slam {

/// Runs the registered odometry source "wheel" within an odometry source that has another sensor.
/// The sensor's data wait until the motion of the wheels covers their stamp, so that the order of
/// arrival does not matter, but at most for one second of the data's stamps.
///
/// Counted: what the wheels count, and "wheels_missing" for data that waited in vain.
/// @tparam Datum of the sensor, with its stamp
template <class Datum>
class WheelsBeside {
 public:
  /// @throw ConfigError
  void configure(Settings& settings) {
    wheels_ = Registry<OdometrySource>::instance().create("wheel");
    wheels_->configure(settings);
    ports_ = portsOf(*wheels_);
  }
  void reset() {
    wheels_->reset();
    track_.clear();
    waiting_.clear();
    counters_.clear();
    has_sample_ = false;
  }

  void set(const OdometrySample& sample) {
    ports_.input("odom", kindOf<OdometrySample>())->set(&sample);
    has_sample_ = true;
  }
  void set(const Datum& datum) { waiting_.add(datum); }
  /// Takes in the last sample of the wheels.
  Status execute() {
    if (!std::exchange(has_sample_, false)) return Status::ok();
    const auto status = wheels_->execute();
    if (wheels_->motion()) track_.add(*wheels_->motion());
    return status;
  }
  /// The oldest of the sensor's data, if it need not wait any more.
  std::optional<Datum> next() {
    auto due = waiting_.next(track_.end());
    if (!due) return std::nullopt;
    if (!due->is_covered) counters_.add("wheels_missing");
    return std::move(due->datum);
  }

  /// The result is empty if the wheels do not cover the whole time.
  std::optional<Motion> between(Stamp start, Stamp end) const { return track_.between(start, end); }
  Counters counters() const {
    auto all = wheels_->counters();
    all.add(counters_);
    return all;
  }
  std::uint64_t dropped() const { return wheels_->dropped(); }

  bool canResume() const { return wheels_->canResume(); }
  template <class Archive>
  void persist(Archive& archive) {
    if constexpr (Archive::kReads)
      wheels_->restoreState(archive);
    else
      wheels_->saveState(archive);
    archive(has_sample_, track_, waiting_, counters_);
  }

 private:
  std::unique_ptr<OdometrySource> wheels_;
  Ports ports_;
  bool has_sample_ = false;
  MotionTrack track_;
  WaitingData<Datum> waiting_;
  Counters counters_;
};

}  // namespace slam
