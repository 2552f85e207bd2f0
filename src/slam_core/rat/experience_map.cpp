// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/rat/experience_map.hpp"

#include <algorithm>

#include "slam_core/geometry/angle.hpp"

namespace slam::rat {

void ExperienceMap::placeAt(const Pose2& T_map_base) {
  start_ = T_map_base;
  since_ = {};
  current_.reset();
}

Pose2 ExperienceMap::pose() const {
  return (current_ ? experiences_[*current_].pose : start_) * since_;
}

bool ExperienceMap::isAt(const Experience& experience, const PoseCellState& state) const {
  return distanceOf(experience.cells, state.place, state.edge, state.headings) <=
         config_.largest_distance;
}

/// The experience of this view whose pose cells are nearest; nothing where none is near enough.
std::optional<std::size_t> ExperienceMap::known(const PoseCellState& state) const {
  const auto alike = by_view_.find(state.view);
  if (alike == by_view_.end()) return std::nullopt;
  std::optional<std::size_t> best;
  double least = config_.largest_distance;
  for (const std::size_t i : alike->second) {
    const double distance =
        distanceOf(experiences_[i].cells, state.place, state.edge, state.headings);
    if (distance > least || (best && distance == least)) continue;
    least = distance;
    best = i;
  }
  return best;
}

ExperienceMap::Arrival ExperienceMap::arrive(const PoseCellState& state) {
  if (state.view == kNoView) return Arrival::kNowhere;
  if (!current_ && !isFull()) return add(state);
  if (current_) {
    const auto& here = experiences_[*current_];
    if (here.view == state.view && isAt(here, state)) return Arrival::kStayed;
  }
  if (const auto found = known(state)) return goTo(*found);
  return add(state);
}

ExperienceMap::Arrival ExperienceMap::add(const PoseCellState& state) {
  if (isFull()) return Arrival::kNowhere;
  const std::size_t number = experiences_.size();
  experiences_.push_back({state.stamp, state.view, state.place, pose()});
  links_of_.emplace_back();
  by_view_[state.view].push_back(number);
  if (current_) link(number, false);
  current_ = number;
  since_ = {};
  return Arrival::kNew;
}

ExperienceMap::Arrival ExperienceMap::goTo(std::size_t experience) {
  if (current_ == experience) return Arrival::kStayed;
  const bool is_new = current_ && link(experience, true);
  current_ = experience;
  since_ = {};
  return is_new ? Arrival::kLoop : Arrival::kKnown;
}

bool ExperienceMap::link(std::size_t to, bool is_loop) {
  const std::size_t from = *current_;
  const auto& known = links_of_[from];
  const bool is_known =
      std::any_of(known.begin(), known.end(), [&](std::size_t i) { return links_[i].to == to; });
  if (is_known) return false;
  links_of_[from].push_back(links_.size());
  links_.push_back({from, to, since_, is_loop});
  return true;
}

void ExperienceMap::relax() {
  for (int i = 0; i < config_.relaxations; ++i) {
    // There and back, so that a correction spreads both ways.
    if (i % 2 == 0) {
      for (const auto& link : links_) relax(link);
    } else {
      for (auto link = links_.rbegin(); link != links_.rend(); ++link) relax(*link);
    }
  }
}

/// Both ends give way by half of what contradicts the link (Milford and Wyeth 2008, Eq. 13).
void ExperienceMap::relax(const ExperienceLink& link) {
  Experience &from = experiences_[link.from], &to = experiences_[link.to];
  const Pose2 led_to = from.pose * link.way;
  const Eigen::Vector2d shift = config_.correction / 2.0 * (to.pose.position() - led_to.position());
  const double turn = config_.correction / 2.0 * wrapAngle(to.pose.theta() - led_to.theta());
  const auto moved = [](const Pose2& pose, const Eigen::Vector2d& by, double angle) {
    return Pose2(pose.x() + by.x(), pose.y() + by.y(), pose.theta() + angle);
  };
  if (link.from != 0) from.pose = moved(from.pose, shift, turn);
  if (link.to != 0) to.pose = moved(to.pose, -shift, -turn);
}

}  // namespace slam::rat
