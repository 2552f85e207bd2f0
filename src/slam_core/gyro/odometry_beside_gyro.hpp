// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <utility>

#include "slam_core/common/config_error.hpp"
#include "slam_core/common/settings.hpp"
#include "slam_core/contract/odometry_source.hpp"
#include "slam_core/contract/waiting_data.hpp"
#include "slam_core/gyro/gyro_beside.hpp"

namespace slam::gyro {

/// An odometry source of another sensor, to which a gyro says how far the robot has turned
/// (GyroBeside). The sensor's data wait for the gyro for at most a second of their stamps.
///
/// Counted: as the source and as the gyro.
/// @tparam Source with setTurnSource() @tparam Datum of its sensor
template <class Source, class Datum>
class OdometryBesideGyro : public OdometrySource {
 public:
  void configure(Settings& settings) override {
    FaultCollector faults;
    faults.attempt([&] { gyro_.configure(settings, sensor_); });
    faults.attempt([&] { source_.configure(settings); });
    faults.raise();
    reset();
  }
  void seed(std::uint64_t seed) override { source_.seed(seed); }

  void set(const Datum& datum) { waiting_.add(datum); }
  void set(const ImuSample& sample) { gyro_.add(sample); }
  Status execute() override {
    const auto due = waiting_.next(gyro_.end());
    is_handing_over_ = due.has_value();
    if (due) source_.set(due->datum);
    const auto status = source_.execute();
    if (!motion()) return status;
    return moreUrgent(status, gyro_.learn(*motion(), isMeasured()));
  }
  bool isBusy() const override { return is_handing_over_; }

  const std::optional<Motion>& motion() const override { return source_.motion(); }
  std::string name() const override { return source_.name(); }
  Counters counters() const override {
    auto all = source_.counters();
    all.add(gyro_.counters());
    return all;
  }
  std::uint64_t dropped() const override { return gyro_.dropped(); }
  Figures figures() const override {
    auto all = source_.figures();
    for (const auto& figure : gyro_.figures()) all.push_back(figure);
    return all;
  }
  void reset() override {
    waiting_.clear();
    gyro_.reset();
    source_.reset();
    is_handing_over_ = false;
  }
  /// The gyro's bias and the trust in it are kept.
  void goOnLive() override {
    waiting_.clear();
    source_.goOnLive();
    is_handing_over_ = false;
  }
  bool canResume() const override { return true; }
  void saveState(ArchiveWriter& archive) const override {
    archive(waiting_, gyro_, source_, is_handing_over_);
  }
  void restoreState(ArchiveReader& archive) override {
    archive(waiting_, gyro_, source_, is_handing_over_);
  }

 protected:
  /// @param sensor the source's, as "the laser"
  explicit OdometryBesideGyro(std::string sensor) : sensor_(std::move(sensor)) {
    source_.setTurnSource([this](Stamp start, Stamp end) { return gyro_.between(start, end); });
  }
  const Source& source() const { return source_; }

 private:
  /// Whether the source's own sensor measured the last motion from its start to its end.
  virtual bool isMeasured() const = 0;

  std::string sensor_;
  WaitingData<Datum> waiting_;
  GyroBeside gyro_;
  Source source_;
  bool is_handing_over_ = false;
};

}  // namespace slam::gyro
