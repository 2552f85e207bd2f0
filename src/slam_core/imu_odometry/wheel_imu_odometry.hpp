// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <deque>
#include <memory>
#include <optional>

#include "slam_core/contract/odometry_source.hpp"
#include "slam_core/gyro/calibrated_gyro.hpp"
#include "slam_core/imu_odometry/standstill.hpp"
#include "slam_core/models/imu_sample.hpp"

namespace slam::imu_odometry {

/// The wheels' way along a gyro's heading: the increments of the registered odometry source
/// "wheel", each turned as the gyro was while it was measured (Borenstein and Feng 1996). The
/// gyro's bias and noise are measured while the wheels stand. Where the gyro is silent, repeats one
/// value while the wheels turn, or contradicts them as only a gyro can that counts in other units
/// or is mounted otherwise, the wheels' own increment is handed on as it is.
///
/// A motion waits until the gyro's samples have come as far, so that the order of arrival does not
/// matter; a second of the wheels later it waits no longer. It moves along the wheel driver's
/// odometry frame, as that of calibrated wheels does.
///
/// Counted: as the wheels and CalibratedGyro.
class WheelImuOdometry final : public OdometrySource {
 public:
  void configure(Settings& settings) override;
  void describe(Ports& ports) override;
  void set(const OdometrySample& sample);
  void set(const ImuSample& sample) { gyro_.add(sample); }
  Status execute() override;
  bool isBusy() const override { return !waiting_.empty() && isDue(waiting_.front()); }

  const std::optional<Motion>& motion() const override { return motion_; }
  Counters counters() const override;
  std::uint64_t dropped() const override;
  Figures figures() const override { return gyro::figuresOf(gyro_.calibration()); }
  void reset() override;
  bool canResume() const override { return wheels_->canResume(); }
  void saveState(ArchiveWriter& archive) const override;
  void restoreState(ArchiveReader& archive) override;

  template <class Archive>
  void persist(Archive& archive) {
    if constexpr (Archive::kReads)
      wheels_->restoreState(archive);
    else
      wheels_->saveState(archive);
    archive(has_sample_, waiting_, gyro_, standstill_, motion_, next_sequence_);
  }

 private:
  Status takeWheels();
  bool isDue(const Motion& wheels) const;
  Status follow(const Motion& wheels);
  Motion turned(const Motion& wheels, const gyro::GyroTurn& turn) const;

  std::unique_ptr<OdometrySource> wheels_;
  Ports wheel_ports_;
  bool has_sample_ = false;     ///< of the wheels, that has not been taken in
  std::deque<Motion> waiting_;  ///< the wheels' motions, for the gyro
  gyro::CalibratedGyro gyro_;
  Standstill standstill_;
  std::optional<Motion> motion_;
  std::uint64_t next_sequence_ = 0;
};

}  // namespace slam::imu_odometry
