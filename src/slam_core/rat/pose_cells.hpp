// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "slam_core/common/collator.hpp"
#include "slam_core/contract/stage.hpp"
#include "slam_core/models/motion.hpp"
#include "slam_core/rat/cell_place.hpp"
#include "slam_core/rat/pose_cell_config.hpp"
#include "slam_core/rat/pose_cell_network.hpp"
#include "slam_core/rat/view_cell.hpp"

namespace slam::rat {

/// The pose cells of RatSLAM (Milford and Wyeth 2008, section IV): motion moves the packet of
/// activity, and a known view adds activity where the packet was when it was seen first. One view
/// alone moves nothing; several in succession that agree with the motion between them do.
///
/// A state comes out for each view, when motion covers its stamp. Counted: the collator's reasons,
/// "invalid_motion" and "invalid_local_view" (values that cannot be used).
class PoseCells final : public Stage {
 public:
  std::string name() const override { return PoseCellConfig::kSection; }
  void describe(Ports& ports) override;
  /// @throw ConfigError
  void configure(const PoseCellConfig& config);
  void configure(Settings& settings) override;

  void set(const Motion& motion);
  void set(const ViewCell& view);
  Status execute() override;
  bool isBusy() const override { return is_busy_; }

  const std::optional<PoseCellState>& state() const { return state_; }
  Counters counters() const override;
  void reset() override;
  bool canResume() const override { return true; }
  void saveState(ArchiveWriter& archive) const override;
  void restoreState(ArchiveReader& archive) override;

  template <class Archive>
  void persist(Archive& archive) {
    collator_.persist(archive, {ViewCell()});
    archive(network_, learnt_, next_sequence_, invalid_);
  }

 private:
  /// It says where the packet was when a view was seen first.
  struct Learnt {
    CellPlace place;
    double fading = 0.0;  ///< grows each time that the view is seen, and goes back by and by

    template <class Archive>
    void persist(Archive& archive) {
      archive(place, fading);
    }
  };
  using Inputs = Collator<Motion, ViewCell>;

  /// Whether a value can be used, by what is wrong with it.
  bool isFit(const std::string& fault, const char* counter);
  void recall(std::int64_t view);
  void learn(std::int64_t view);

  PoseCellConfig config_;
  Inputs collator_;
  PoseCellNetwork network_;
  std::map<std::int64_t, Learnt> learnt_;  ///< by the view's number
  std::uint64_t next_sequence_ = 0;
  bool is_busy_ = false;
  std::optional<PoseCellState> state_;
  Counters invalid_;   ///< values that were left out
  std::string fault_;  ///< of the last one of them, until it is told
};

}  // namespace slam::rat
