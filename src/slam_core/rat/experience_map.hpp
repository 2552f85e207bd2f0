// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "slam_core/geometry/pose2.hpp"
#include "slam_core/rat/cell_place.hpp"
#include "slam_core/rat/experience_config.hpp"

namespace slam::rat {

/// A place: what the robot sees there, where the packet of pose cells is, and where in the map it
/// is drawn.
struct Experience {
  Stamp first_visit;
  std::int64_t view = kNoView;
  CellPlace cells;
  Pose2 pose;  ///< T_map_experience

  template <class Archive>
  void persist(Archive& archive) {
    archive(first_visit, view, cells, pose);
  }
};

/// The robot went from one experience to another, and odometry measured the way.
struct ExperienceLink {
  std::size_t from = 0, to = 0;
  Pose2 way;             ///< T_from_to
  bool is_loop = false;  ///< it led to an experience that was known already

  template <class Archive>
  void persist(Archive& archive) {
    archive(from, to, way, is_loop);
  }
};

/// The experience map of RatSLAM (Milford and Wyeth 2008, section V): a graph of experiences whose
/// poses are relaxed until links and poses agree as well as they can. It keeps the topology right
/// and is metric only as far as odometry was. The first experience stays in its place.
class ExperienceMap {
 public:
  enum class Arrival {
    kStayed,   ///< at the current experience
    kNew,      ///< a new experience was made
    kKnown,    ///< the robot came to another experience along a link that there was
    kLoop,     ///< the same, and the link is new: a place was recognised
    kNowhere,  ///< nothing could be recognised, or the map is full
  };

  ExperienceMap() = default;
  explicit ExperienceMap(const ExperienceConfig& config) : config_(config) {}

  /// The robot is there, whatever led to it. With the next view a new experience begins, which is
  /// linked with none before it; where the map is full, a known one may be recognised.
  void placeAt(const Pose2& T_map_base);
  void move(const Pose2& increment) { since_ = since_ * increment; }
  Arrival arrive(const PoseCellState& state);
  void relax();

  Pose2 pose() const;  ///< of the robot in the map
  /// The experience where the robot is or was last; nothing before the first one.
  std::optional<std::size_t> current() const { return current_; }
  const Pose2& sinceCurrent() const { return since_; }  ///< T_current_base
  const std::vector<Experience>& experiences() const { return experiences_; }
  const std::vector<ExperienceLink>& links() const { return links_; }
  bool isFull() const {
    return experiences_.size() >= static_cast<std::size_t>(config_.most_experiences);
  }

  template <class Archive>
  void persist(Archive& archive) {
    archive(experiences_, links_, by_view_, links_of_, start_, since_, current_);
  }

 private:
  bool isAt(const Experience& experience, const PoseCellState& state) const;
  std::optional<std::size_t> known(const PoseCellState& state) const;
  Arrival add(const PoseCellState& state);
  Arrival goTo(std::size_t experience);
  /// @return whether there was none
  bool link(std::size_t to, bool is_loop);
  void relax(const ExperienceLink& link);

  ExperienceConfig config_;
  std::vector<Experience> experiences_;
  std::vector<ExperienceLink> links_;
  std::map<std::int64_t, std::vector<std::size_t>> by_view_;  ///< experiences that show a view
  std::vector<std::vector<std::size_t>> links_of_;            ///< from each experience
  Pose2 start_;                                               ///< where there is no current one
  Pose2 since_;
  std::optional<std::size_t> current_;
};

}  // namespace slam::rat
