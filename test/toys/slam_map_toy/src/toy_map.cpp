// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "toy_map.hpp"

#include <cmath>
#include <sstream>
#include <utility>

#include "slam_core/common/atomic_file.hpp"
#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam_toy {
namespace {

constexpr double kLargest = 1e6;  // a pose is never so far from the map's origin [m]

const slam::Registrar<slam::MapModule, ToyMap> kRegistrar("map_toy");
const slam::SectionRegistrar<ToyMapConfig> kSectionRegistrar;

}  // namespace

void ToyMapConfig::describe(slam::Fields& fields) {
  fields.add("cell", &cell, "edge of a cell").unit("m").in(slam::Range::above(0.01));
}

void ToyMap::configure(slam::Settings& settings) {
  config_ = settings.read<ToyMapConfig>();
  reset();
}

void ToyMap::describe(slam::Ports& ports) {
  ports.takes<slam::FilterPose>("pose", "the back-end's pose", this);
}

void ToyMap::reset() {
  pose_.reset();
  visits_.clear();
  counters_.clear();
}

slam::Status ToyMap::execute() {
  const auto pose = std::exchange(pose_, std::nullopt);
  if (!pose) return slam::Status::ok();
  if (!(std::abs(pose->x) < kLargest && std::abs(pose->y) < kLargest)) {
    counters_.add("invalid_pose");
    return slam::Status::warning("a pose that is no place in the map is left out");
  }
  ++visits_[{std::lround(pose->x / config_.cell), std::lround(pose->y / config_.cell)}];
  return slam::Status::ok();
}

void ToyMap::save(const std::string& folder) const {
  std::ostringstream text;
  text << "x,y,poses\n";
  for (const auto& [cell, count] : visits_)
    text << static_cast<double>(cell.first) * config_.cell << ','
         << static_cast<double>(cell.second) * config_.cell << ',' << count << '\n';
  slam::writeFileAtomically(folder + "/toy_map.csv", text.str());
}

}  // namespace slam_toy
