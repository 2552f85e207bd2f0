// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "slam_core/graph_slam/submap.hpp"

namespace slam::graph_slam {

/// The submaps of a path. Two are drawn at a time, begun in turn: scans are matched with the older
/// one, so that it always holds at least the given way, until it is finished (Hess et al. 2016). Of
/// the finished ones only those that were used last stay drawn.
class Submaps {
 public:
  /// A finished submap.
  struct Finished {
    Submap submap;
    double ended;  ///< the way that had been gone with its last scan [m]
    std::size_t used;

    template <class Archive>
    void persist(Archive& archive, const grid_map::GridMapConfig& config) {
      submap.persist(archive, config);
      archive(ended, used);
    }
  };

  /// @param config outlives this @param way of a submap [m]
  Submaps(const grid_map::GridMapConfig& config, double way);

  /// Scans are matched with this one to begin with.
  void startWith(Submap submap) { older_ = std::move(submap); }
  void insert(const SharedScan& scan, const scan_matching::ScanLevels& points, graph::Key node,
              const Pose2& pose);

  /// To match with.
  const Submap& current() const { return older_; }
  scan_matching::MapView currentView() { return older_.map().view(); }
  const std::vector<Finished>& finished() const { return finished_; }
  /// Drops the one that was finished last.
  void dropLast() { finished_.pop_back(); }
  /// Whether the node has a scan in one that is not finished.
  bool isInHand(graph::Key node) const;
  /// Draws a finished one where it is not drawn. The view is valid until the next call.
  scan_matching::MapView view(std::size_t number);
  /// The length of the way up to the last scan [m].
  double way() const { return gone_; }
  std::size_t bytes() const;  ///< of all drawings

  template <class Archive>
  void persist(Archive& archive) {
    auto size = std::uint64_t{finished_.size()};
    archive.count(size);
    if constexpr (Archive::kReads) {
      finished_.clear();
      for (; size > 0; --size) finished_.push_back({Submap(config_), 0.0, 0});
    }
    for (auto& each : finished_) each.persist(archive, config_);
    older_.persist(archive, config_);
    bool has_younger = younger_.has_value();
    archive(has_younger);
    if constexpr (Archive::kReads)
      younger_ = has_younger ? std::optional<Submap>(Submap(config_)) : std::nullopt;
    if (younger_) younger_->persist(archive, config_);
    archive(gone_, renewed_, last_, uses_);
  }

 private:
  friend struct SessionParts;  // writes and reads its members

  void renew();
  void giveUpDrawings(std::size_t kept);

  const grid_map::GridMapConfig& config_;
  double way_;
  std::vector<Finished> finished_;
  Submap older_;
  std::optional<Submap> younger_;
  double gone_ = 0.0, renewed_ = 0.0;  ///< [m]
  Pose2 last_;
  std::size_t uses_ = 0;
};

}  // namespace slam::graph_slam
