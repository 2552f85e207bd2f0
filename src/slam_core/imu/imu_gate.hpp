// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>

#include "slam_core/contract/gate.hpp"
#include "slam_core/contract/mount_queue.hpp"
#include "slam_core/imu/imu_config.hpp"
#include "slam_core/imu/imu_reading.hpp"

namespace slam {

/// The entrance of whoever takes in an IMU's samples: makes them of a driver's readings, in their
/// order, once the IMU's mount is known. Until then it holds them; an identity mount is never
/// assumed. A reading that cannot be used does not come out, nor does one of a frame without a
/// mount when one behind it can be used, nor the oldest when too many are held.
///
/// Call order: configure(), set(...) of what has come, execute() until sample() is empty.
/// Counted, of readings that did not come out: "bad_reading", "bad_mount", "no_mount",
/// "no_gyro".
class ImuGate final : public Gate {
 public:
  static constexpr std::size_t kCapacity = 2000;

  std::string name() const override { return ImuConfig::kSection; }
  void describe(Ports& ports) override;
  /// A fresh start; the mount is the configured one or none. @throw ConfigError
  void configure(const ImuConfig& config);
  void configure(Settings& settings) override { configure(settings.read<ImuConfig>()); }

  /// The mount counts for all readings of its frame that have not come out. It is ignored where the
  /// configuration gives a mount.
  void set(const ImuMount& mount) { readings_.set(mount); }
  void set(const ImuReading& reading) { readings_.push(reading); }

  /// Lets the next sample out that is due. Says what was wrong with those before it, or what the
  /// readings wait for.
  Status execute() override;
  bool isBusy() const override { return sample_.has_value(); }

  const std::optional<ImuSample>& sample() const { return sample_; }
  Counters counters() const override { return counters_; }
  std::uint64_t dropped() const override;
  Counters held() const override;

  /// The gate is as after configure(), but keeps the mount.
  void reset() override;
  bool canResume() const override { return true; }
  void saveState(ArchiveWriter& archive) const override;
  void restoreState(ArchiveReader& archive) override;

  template <class Archive>
  void persist(Archive& archive) {
    archive(readings_, sample_, counters_);
  }

 private:
  Status waiting() const;
  Status take(const ImuReading& driven);
  Status reject(const std::string& reason, const std::string& sentence);

  ImuConfig config_;
  MountQueue<ImuReading, ImuMount> readings_{kCapacity};
  std::optional<ImuSample> sample_;
  Counters counters_;
};

}  // namespace slam
