// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <optional>
#include <string>

#include "slam_core/association/sightings.hpp"
#include "slam_core/contract/association_chooser.hpp"
#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/contract/landmark_remover.hpp"
#include "slam_core/contract/map_keeper.hpp"
#include "slam_core/landmark_graph/associator.hpp"
#include "slam_core/seif/interval.hpp"
#include "slam_core/seif/local_maps.hpp"
#include "slam_core/seif/seif_config.hpp"
#include "slam_core/seif/surroundings.hpp"

namespace slam::seif {

/// SLAM with an exactly sparse extended information filter (Thrun, Liu, Koller, Ng, Ghahramani,
/// Durrant-Whyte 2004; Walter, Eustice, Leonard 2007): what is known of robot and map is an
/// information matrix that joins only landmarks that were seen together. Poses of the past are
/// marginalised (Interval), so that it grows with the map and not with the way.
class SeifSlam final : public Backend,
                       LandmarkMapper,
                       LandmarkRemover,
                       MapKeeper,
                       AssociationChooser {
 public:
  /// @throw ConfigError
  void configure(const SeifConfig& config);
  void configure(Settings& settings) override;
  void describe(Ports& ports) override;
  void describe(Capabilities& capabilities) override;

  void set(const Motion& motion);
  void set(const LandmarkObservationArray& observations) { observations_ = observations; }
  void set(const PoseEstimate& initial_pose) override { initial_pose_ = initial_pose; }

  Status execute() override;

  PoseEstimate pose() const override { return filter_->path.robot(); }
  Counters counters() const override { return counters_; }
  Figures figures() const override;
  void reset() override;
  bool canResume() const override { return true; }
  void saveState(ArchiveWriter& archive) const override;
  void restoreState(ArchiveReader& archive) override;

  template <class Archive>
  void persist(Archive& archive) {
    if constexpr (Archive::kReads) filter_ = std::make_unique<Filter>(config_, PoseEstimate());
    archive(*filter_, associator_, sightings_, statistics_, counters_, fixed_map_, map_,
            initial_pose_, motion_, observations_);
  }

 private:
  // what it offers as capabilities
  LandmarkMap landmarks() const override;
  UpdateStatistics statistics() const override { return statistics_; }
  Status remove(LandmarkId id) override;
  MapState state() const override;
  void set(const MapState& map) override { map_ = map; }
  void useAssociation(const std::string& policy) override { association_ = policy; }

  /// The information filter: the poses of the interval, the landmarks, and what joins them.
  struct Filter {
    Filter(const SeifConfig& config, const PoseEstimate& start);
    void solve(int iterations) {
      path.optimize(iterations, interval.active(), surroundings.follow(interval.observed()));
    }

    landmark_graph::PathGraph path;
    landmark_graph::LandmarkGraph landmarks{path};
    LocalMaps maps;
    Interval interval;
    Surroundings surroundings;

    template <class Archive>
    void persist(Archive& archive) {
      archive(path, landmarks, maps, interval, surroundings);
    }
  };

  void settle(LandmarkMap& map) const;
  void replaceMap();
  void relocate();
  void predict();
  Status takeObservations();
  void marginalise();
  Status reconsider(const landmark_graph::Association& association, const Pose2& sensor);
  Status reinitialize(const association::Sightings::Verdict& verdict, const Pose2& sensor);
  Status augment(landmark_graph::Association& association, const Pose2& sensor);
  bool append(LandmarkId id, const LandmarkObservation& z, const Pose2& sensor);
  void removeGhosts(const landmark_graph::Association& association, const Pose2& sensor);

  std::string association_ = "known_ids";
  SeifConfig config_;
  landmark_graph::Associator associator_;
  std::unique_ptr<Filter> filter_;
  association::Sightings sightings_;
  UpdateStatistics statistics_;
  Counters counters_;
  LandmarkMap fixed_map_;  ///< as it was loaded, to localise in

  std::optional<MapState> map_;
  std::optional<PoseEstimate> initial_pose_;
  std::optional<Motion> motion_;  ///< all motions since the last step as one
  std::optional<LandmarkObservationArray> observations_;
};

}  // namespace slam::seif
