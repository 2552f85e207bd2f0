// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>

#include "slam_core/camera/camera_view.hpp"
#include "slam_core/contract/stage.hpp"
#include "slam_core/rat/local_view_config.hpp"
#include "slam_core/rat/view_cell.hpp"
#include "slam_core/rat/view_memory.hpp"

namespace slam::rat {

/// The local view cells of RatSLAM (Milford and Wyeth 2008, section III; Ball et al. 2013): each
/// image of the camera activates the cell of the view that looks most like it, or a new one. Views
/// are compared as reduced images, moved sideways (sum of absolute differences).
///
/// Every image makes a ViewCell, also one that shows nothing: it moves time on. Counted: "unusable"
/// (images without calibration, mount or pixels), "blank" (without contrast), "views_full" (images
/// of new views beyond the memory).
class LocalView final : public Stage {
 public:
  std::string name() const override { return LocalViewConfig::kSection; }
  void describe(Ports& ports) override;
  /// @throw ConfigError
  void configure(const LocalViewConfig& config);
  void configure(Settings& settings) override;

  void set(const CameraView& view) { seen_ = view; }
  Status execute() override;
  bool isBusy() const override { return cell_.has_value(); }

  const std::optional<ViewCell>& cell() const { return cell_; }
  Counters counters() const override { return counters_; }
  Figures figures() const override;
  void reset() override;
  bool canResume() const override { return true; }
  void saveState(ArchiveWriter& archive) const override;
  void restoreState(ArchiveReader& archive) override;

  template <class Archive>
  void persist(Archive& archive) {
    archive(memory_, next_sequence_, counters_);
  }

 private:
  Status recognise(const CameraView& seen);

  LocalViewConfig config_;
  ViewMemory memory_;
  std::uint64_t next_sequence_ = 0;
  std::optional<CameraView> seen_;
  std::optional<ViewCell> cell_;
  Counters counters_;
};

}  // namespace slam::rat
