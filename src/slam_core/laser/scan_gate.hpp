// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <utility>

#include "slam_core/contract/gate.hpp"
#include "slam_core/contract/mount_queue.hpp"
#include "slam_core/laser/laser_config.hpp"
#include "slam_core/laser/laser_sweep.hpp"

namespace slam {

/// The entrance of whoever takes in laser scans: makes them of a driver's sweeps, in their order,
/// once the laser's mount is known. Until then it holds them; an identity mount is never assumed.
/// A sweep that cannot be used comes out as a scan without beams, which moves time on; so does one
/// of a frame without a mount when one behind it can be used, and the oldest when too many are
/// held.
///
/// Call order: configure(), set(...) of what has come, execute() until scan() is empty.
/// Counted, of scans without beams: "bad_scan", "bad_mount", "no_mount", "no_range" (a laser that
/// is blind: worth a word after a second).
class ScanGate : public Gate {
 public:
  static constexpr std::size_t kCapacity = 200;

  ScanGate() : ScanGate(LaserConfig::kSection, "scan", "laser scans") {}

  std::string name() const override { return section_; }
  void describe(Ports& ports) override;
  /// A fresh start; the mount is the configured one or none. @throw ConfigError
  void configure(const LaserConfig& config);
  void configure(Settings& settings) override { configure(settings.read<LaserConfig>()); }

  /// For scans of its frame, in force for all that have not come out. Where the configuration gives
  /// the mount it counts for nothing.
  void set(const LaserMount& mount) { sweeps_.set(mount); }
  void set(LaserSweep sweep) { sweeps_.push(std::move(sweep)); }

  /// Lets the next scan out that is due. Says what is wrong with it, or what the scans wait for.
  Status execute() override;
  bool isBusy() const override { return scan_.has_value(); }

  const std::optional<LaserScan>& scan() const { return scan_; }
  Counters counters() const override { return counters_; }
  Counters held() const override;

  /// The gate is as after configure(), but keeps the mount.
  void reset() override;
  bool canResume() const override { return true; }
  void saveState(ArchiveWriter& archive) const override;
  void restoreState(ArchiveReader& archive) override;

  template <class Archive>
  void persist(Archive& archive) {
    archive(sweeps_, sequence_, blind_since_, scan_, counters_);
  }

 protected:
  /// @param section of the configuration @param port of its inputs and its output
  /// @param sentence what comes in there
  ScanGate(std::string section, std::string port, std::string sentence)
      : section_(std::move(section)), port_(std::move(port)), sentence_(std::move(sentence)) {}

 private:
  struct Fault {
    std::string reason, sentence;
  };

  std::string unknownMount(const std::string& frame) const;
  std::optional<Fault> faultOfSweep(const LaserSweep& sweep) const;
  Status watchBlindness();

  std::string section_, port_, sentence_;
  LaserConfig config_;
  MountQueue<LaserSweep, LaserMount> sweeps_{kCapacity};
  std::uint64_t sequence_ = 0;
  std::optional<Stamp> blind_since_;  ///< all sweeps from there on had no range
  std::optional<LaserScan> scan_;
  Counters counters_;
};

/// The gate of the second laser.
class RearScanGate final : public ScanGate {
 public:
  RearScanGate() : ScanGate(RearLaserConfig::kSection, "rear_scan", "scans of the rear laser") {}

  using ScanGate::configure;
  void configure(Settings& settings) override { configure(settings.read<RearLaserConfig>()); }
};

}  // namespace slam
