// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "slam_core/camera/view_drawer.hpp"
#include "slam_core/contract/landmark_detector.hpp"

namespace slam {

/// A detector whose ports have other names, so that it stands in a product beside another one of
/// the same or of another kind: all else is the detector's own.
class PlacedDetector final : public LandmarkDetector, public ViewDrawer {
 public:
  /// The new names of ports by the detector's own ones. A port that is not listed keeps its name.
  using Names = std::map<std::string, std::string>;

  PlacedDetector(std::unique_ptr<LandmarkDetector> detector, Names names)
      : detector_(std::move(detector)), names_(std::move(names)) {}

  void describe(Ports& ports) override;
  void configure(Settings& settings) override { detector_->configure(settings); }
  Status execute() override { return detector_->execute(); }
  bool isBusy() const override { return detector_->isBusy(); }
  const std::optional<LandmarkObservationArray>& observations() const override {
    return detector_->observations();
  }
  LandmarkTraits traits() const override { return detector_->traits(); }
  void startIdsAt(LandmarkId first) override { detector_->startIdsAt(first); }
  std::vector<IdRange> ids() const override { return detector_->ids(); }
  /// Empty where the detector draws nothing.
  cv::Mat drawing() const override;

  Counters counters() const override { return detector_->counters(); }
  std::uint64_t dropped() const override { return detector_->dropped(); }
  Figures figures() const override { return detector_->figures(); }
  void reset() override { detector_->reset(); }
  bool canResume() const override { return detector_->canResume(); }
  void saveState(ArchiveWriter& archive) const override { detector_->saveState(archive); }
  void restoreState(ArchiveReader& archive) override { detector_->restoreState(archive); }

 private:
  std::string nameOf(const std::string& port) const;

  std::unique_ptr<LandmarkDetector> detector_;
  Names names_;
};

}  // namespace slam
