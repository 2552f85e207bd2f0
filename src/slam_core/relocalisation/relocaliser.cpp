// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/relocalisation/relocaliser.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "slam_core/contract/grid_mapper.hpp"
#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/contract/landmark_remover.hpp"
#include "slam_core/contract/lost_reporter.hpp"
#include "slam_core/relocalisation/grid_fit.hpp"
#include "slam_core/relocalisation/pose_agreement.hpp"

namespace slam::relocalisation {
namespace {

const SectionRegistrar<RelocalisationConfig> kSectionRegistrar;

constexpr const char* kTooLarge =
    "the grid is too large to be searched for the robot (more than 500 m), so that its pose is "
    "believed as it is: set an initial pose where the robot is elsewhere";
constexpr const char* kTooFewPoints =
    "the map has fewer than two landmarks that are points, by which the robot is searched for, so "
    "that its pose is believed as it is: set an initial pose where the robot is elsewhere";
constexpr const char* kContradicted =
    "the robot is lost: what is seen contradicts the map around it; it is looked for in the whole "
    "map; ";
constexpr const char* kCarried =
    "the robot is lost: what its laser sees has changed at once, as if it had been carried; it is "
    "looked for in the whole map; ";
constexpr const char* kLostUnsearched =
    "the robot is lost: what is seen contradicts the map around it; it is not looked for, since ";
constexpr const char* kOnlyLines =
    "the robot sees only lines, and the loaded map is searched by points, so that its pose is "
    "believed as it is: set an initial pose where the robot is elsewhere";

/// Few of a filter's particles, or none, are near the robot.
bool isVague(const PoseEstimate& estimate) {
  constexpr double kSigma = 1.0;  // [m]
  return estimate.covariance.topLeftCorner<2, 2>().trace() > kSigma * kSigma;
}

/// A detector of lines sees no points: then nothing can confirm the pose of the loaded map.
bool seesOnlyLines(const LandmarkObservationArray& array) {
  const auto is_line = [](const LandmarkObservation& z) { return z.isLine(); };
  const auto& seen = array.observations;
  return !seen.empty() && std::all_of(seen.begin(), seen.end(), is_line);
}

}  // namespace

void Relocaliser::configure(Settings& settings, const Capabilities& capabilities,
                            LocalLandmarks::Ids ids) {
  capabilities_ = capabilities;
  grid_map::GridMapConfig grid;
  scan_matching::MatcherConfig matcher;
  const bool has_grid = capabilities.find<GridMapper>() != nullptr;
  FaultCollector faults;
  faults.attempt([&] { config_ = settings.read<RelocalisationConfig>(); });
  if (has_grid) faults.attempt([&] { settings.read(grid); });
  if (has_grid) faults.attempt([&] { settings.read(matcher); });
  faults.raise();
  ids_ = ids;
  landmarks_ = LandmarkRecogniser(config_, ids);
  doubt_ = LandmarkDoubt(ids);
  grid_.reset();
  if (has_grid) grid_.emplace(config_, grid, matcher);
  reset();
}

void Relocaliser::reset() {
  assume(Belief::kSure);
  doubt_.forget();
  counters_.clear();
}

Status Relocaliser::assume(Belief belief, const MapState* loaded) {
  end();
  belief_ = belief;
  gating_ = GatingRate(kWindow);
  is_lost_by_scans_ = is_ambiguous_ = is_grid_too_large_ = sees_only_lines_ = false;
  was_carried_ = false;
  unsearched_radius_.reset();
  scan_change_.forget();
  changed_.reset();
  forgetSurroundings();
  const bool can_search = config_.enabled && belief != Belief::kSure && begin(loaded);
  doubt_.relocate();
  if (loaded != nullptr) {
    doubt_.forget();
    doubt_.know(pointsOf(loaded->landmarks));
  }
  if (can_search) return Status::ok();
  belief_ = Belief::kSure;
  if (is_grid_too_large_) return Status::warning(kTooLarge);
  return loaded != nullptr && config_.enabled ? unsearched(*loaded) : Status::ok();
}

/// @return a warning where a map that is not searched has landmarks
Status Relocaliser::unsearched(const MapState& loaded) const {
  return loaded.landmarks.empty() ? Status::ok() : Status::warning(kTooFewPoints);
}

std::string Relocaliser::whyUnsearched() const {
  const std::string why = !config_.enabled     ? "relocalisation.enabled is false"
                          : is_grid_too_large_ ? "the grid is larger than 500 m"
                                               : "the map has too little to be searched by";
  return why + ": set an initial pose";
}

/// Forgets what was seen before: the robot may have been carried, so that it was seen from
/// elsewhere.
void Relocaliser::forgetSurroundings() {
  landmarks_.forget();
  if (grid_) grid_->forget();
}

void Relocaliser::searchAnyway() {
  if (grid_) grid_->searchAnyway();
}

/// The points of the map, without those that a lost robot has added: it has mapped them relative to
/// its wrong pose, at which a search would find it again.
LandmarkMap Relocaliser::landmarksToSearch(const MapState* loaded) const {
  auto map = pointsOf(loaded != nullptr ? loaded->landmarks
                                        : capabilities_.find<LandmarkMapper>()->landmarks());
  const auto is_doubtful = [this](const Landmark& mark) { return !doubt_.isTrusted(mark.id); };
  if (doubt_.isLost()) map.erase(std::remove_if(map.begin(), map.end(), is_doubtful), map.end());
  return map;
}

/// Starts the searches that the map allows. @return whether there is any
bool Relocaliser::begin(const MapState* loaded) {
  constexpr std::size_t kLeastLandmarks = 2;
  if (capabilities_.find<LandmarkMapper>() != nullptr) {
    auto map = landmarksToSearch(loaded);
    searches_landmarks_ = map.size() >= kLeastLandmarks;
    if (searches_landmarks_) landmarks_.begin(std::move(map));
  }
  if (grid_) {
    const auto grid = loaded != nullptr ? loaded->grid : capabilities_.find<GridMapper>()->grid();
    searches_grid_ = grid && GridRecogniser::canSearch(*grid);
    is_grid_too_large_ = grid && !grid->cells.empty() && !searches_grid_;
    const bool has_place = loaded != nullptr && belief_ == Belief::kUnconfirmed;
    if (searches_grid_)
      grid_->begin(*grid, has_place ? std::make_optional(loaded->robot.pose) : std::nullopt);
  }
  return searches_landmarks_ || searches_grid_;
}

void Relocaliser::end() {
  searches_landmarks_ = searches_grid_ = false;
  landmarks_.end();
  if (grid_) grid_->end();
}

bool Relocaliser::usesScans() const { return searches_grid_ || (grid_ && isTesting(*grid_)); }

void Relocaliser::predict(const Motion& motion) {
  if (searches_landmarks_) landmarks_.move(motion);
  doubt_.move(motion);
  scan_change_.move(motion);
  if (usesScans()) grid_->move(motion);
}

bool Relocaliser::see(const LandmarkObservationArray& array) {
  if (belief_ == Belief::kUnconfirmed && !searches_grid_ && seesOnlyLines(array)) {
    assume(Belief::kSure);
    sees_only_lines_ = true;
  }
  if (searches_landmarks_) landmarks_.see(array);
  if (belief_ == Belief::kSure) doubt_.see(array);
  if (!isCarriedAway(*this) && (!searches_landmarks_ || is_lost_by_scans_)) return true;
  counters_.add("withheld", array.observations.size());
  return false;
}

bool Relocaliser::see(const LaserScan& scan) {
  using Verdict = ScanChange::Verdict;
  const auto change = grid_ && config_.enabled ? scan_change_.judge(scan) : Verdict::kGoesOn;
  if (change != Verdict::kGoesOn) {
    counters_.add("unlike_last");
    if (change == Verdict::kChanged) changed_ = scan;
    return false;
  }
  if (usesScans()) grid_->see(scan);
  has_new_scan_ = true;
  return belief_ != Belief::kAnywhere && !isCarriedAway(*this);
}

bool Relocaliser::isLostByScans() const {
  const auto* reporter = capabilities_.find<LostReporter>();
  return reporter != nullptr && !reporter->findsItself() && reporter->lostSince().has_value();
}

/// Whether enough observations fit the map since a loss that nobody looked for.
bool Relocaliser::isAgreedAgain() const {
  constexpr int kAgreeing = 10;  // observations
  return !contradiction() && gating_.observations() >= kAgreeing &&
         2 * gating_.gated() < gating_.observations();
}

std::optional<Relocaliser::Cause> Relocaliser::contradiction() const {
  if (gating_.isExcessive() || doubt_.isLost()) return Cause::kLandmarks;
  return isLostByScans() ? std::make_optional(Cause::kScans) : std::nullopt;
}

void Relocaliser::watch(const Pose2& believed, Stamp stamp) {
  if (is_lost_by_scans_ && !isLostByScans()) assume(Belief::kSure);
  if (const auto changed = std::exchange(changed_, std::nullopt)) heedChange(*changed, believed);
  if (belief_ != Belief::kSure) return;
  if (const auto* mapper = capabilities_.find<LandmarkMapper>()) {
    const auto statistics = mapper->statistics();
    gating_.add(statistics);
    doubt_.judge(statistics, believed, stamp);
  }
  if (!unsearched_radius_) {
    if (const auto cause = contradiction()) lose(believed, *cause);
  } else if (isAgreedAgain()) {
    assume(Belief::kSure);
  }
}

/// Looks for the robot, or reports that it is lost where its map is not searched.
void Relocaliser::lose(const Pose2& believed, Cause cause) {
  const auto doubtful = doubt_.isLost() ? doubt_.doubtful() : std::vector<LandmarkId>();
  assume(Belief::kLost);
  removeLandmarks(doubtful);
  is_lost_by_scans_ = cause == Cause::kScans;
  was_carried_ = cause == Cause::kChange;
  if (is_lost_by_scans_ && searches_grid_) expect(*grid_, believed);
  if (belief_ == Belief::kSure) unsearched_radius_ = radiusOfMap(believed);
}

/// A robot that is searched for anywhere stays so: what it has seen until now is of another place.
void Relocaliser::heedChange(const LaserScan& changed, const Pose2& believed) {
  if (unsearched_radius_) return;
  if (belief_ == Belief::kAnywhere)
    assume(Belief::kAnywhere);
  else if ((belief_ == Belief::kLost && !is_lost_by_scans_) || isElsewhere(changed, believed))
    lose(believed, Cause::kChange);
}

/// A scan of the same place fits the grid, though people have come or gone, or the robot was
/// pushed. A grid that cannot be searched leaves the robot where it is believed to be.
bool Relocaliser::isElsewhere(const LaserScan& changed, const Pose2& believed) const {
  constexpr double kFits = 0.5;
  const auto grid = capabilities_.find<GridMapper>()->grid();
  return grid && GridRecogniser::canSearch(*grid) &&
         bestShareOnSurfaces(*grid, changed, believed) < kFits;
}

/// They were mapped since the doubt began, so that they are not where the map has them.
void Relocaliser::removeLandmarks(const std::vector<LandmarkId>& doubtful) {
  auto* remover = capabilities_.find<LandmarkRemover>();
  if (remover == nullptr) return;
  for (const auto id : doubtful) remover->remove(id);
}

/// @return the radius of a circle that holds the landmarks, the grid and the robot, from which the
/// outermost landmarks may be seen from outside [m]
double Relocaliser::radiusOfMap(const Pose2& believed) const {
  constexpr double kReach = 3.0;  // [m]
  Eigen::AlignedBox2d box(believed.position());
  if (const auto* mapper = capabilities_.find<LandmarkMapper>())
    for (const auto& landmark : mapper->landmarks()) box.extend(landmark.position);
  const auto* gridder = capabilities_.find<GridMapper>();
  const auto grid = gridder == nullptr ? std::nullopt : gridder->grid();
  if (grid && !grid->cells.empty()) {
    box.extend(grid->origin);
    box.extend(grid->origin + grid->resolution * Eigen::Vector2d(grid->width, grid->height));
  }
  return 0.5 * box.diagonal().norm() + kReach;
}

std::optional<PoseEstimate> Relocaliser::judge(const PoseEstimate& believed, Stamp stamp) {
  watch(believed.pose, stamp);
  if (std::exchange(has_new_scan_, false)) testPlace(believed.pose);
  std::optional<Recognition> found;
  if (searches_landmarks_) found = landmarks_.find(stamp);
  if (searches_grid_ && !(found && found->hasPlace()))
    if (const auto by_scans = grid_->find()) {
      is_ambiguous_ = by_scans->verdict == Recognition::Verdict::kAmbiguous;
      return settleByScans(*by_scans, believed);
    }
  if (!found) return std::nullopt;
  is_ambiguous_ = found->verdict == Recognition::Verdict::kAmbiguous;
  return found->hasPlace() ? settle(*found, believed) : std::nullopt;
}

/// What the scans have confirmed may be refuted by those that follow.
void Relocaliser::testPlace(const Pose2& believed) {
  if (!grid_ || !isTesting(*grid_)) return;
  const auto test = grid_->test(believed);
  if (test == GridRecogniser::Test::kPassed) {
    grid_->end();
    was_carried_ = false;
  }
  if (test != GridRecogniser::Test::kRefuted) return;
  counters_.add("withdrawn");
  const bool was_carried = was_carried_;
  assume(Belief::kLost);
  was_carried_ = was_carried;
}

/// The back-end may have been led to its pose by the same scans, so that its agreement confirms
/// nothing; but then it keeps its state.
std::optional<PoseEstimate> Relocaliser::settleByScans(const Recognition& found,
                                                       const PoseEstimate& believed) {
  if (found.verdict != Recognition::Verdict::kConfirmed) return std::nullopt;
  const bool stays = belief_ != Belief::kAnywhere && !isCarriedAway(*this) && !isLostByScans() &&
                     agree(found.robot, believed);
  believePlaceOfScans();
  if (stays) return std::nullopt;
  counters_.add("relocalised");
  return found.robot;
}

/// Does the same as assume(Belief::kSure), but the place that was found is tested on.
void Relocaliser::believePlaceOfScans() {
  belief_ = Belief::kSure;
  gating_ = GatingRate(kWindow);
  is_lost_by_scans_ = is_ambiguous_ = false;
  searches_landmarks_ = searches_grid_ = false;
  landmarks_.end();
  landmarks_.forget();
  doubt_.relocate();
  grid_->beginTest();
}

/// A place that agrees with the back-end's pose needs no further confirmation, and the back-end
/// keeps its state; but with a vague one every place agrees.
std::optional<PoseEstimate> Relocaliser::settle(const Recognition& found,
                                                const PoseEstimate& believed) {
  const bool may_stay = belief_ != Belief::kAnywhere && !isCarriedAway(*this);
  if (may_stay && !isVague(believed) && agree(found.robot, believed)) {
    assume(Belief::kSure);
    return std::nullopt;
  }
  if (found.verdict != Recognition::Verdict::kConfirmed) return std::nullopt;
  counters_.add("relocalised");
  assume(Belief::kSure);
  return found.robot;
}

PoseEstimate Relocaliser::told(PoseEstimate believed) const {
  if (belief() == Belief::kSure) return believed;
  const double searched = std::max(landmarks_.radius(), grid_ ? radiusOf(*grid_) : 0.0);
  const double radius = unsearched_radius_.value_or(searched);
  believed.covariance.diagonal() +=
      Eigen::Vector3d(radius * radius, radius * radius, M_PI * M_PI / 3.0);
  return believed;
}

Status Relocaliser::status() const {
  if (unsearched_radius_) return Status::alarm(kLostUnsearched + whyUnsearched());
  if (belief_ == Belief::kSure)
    return sees_only_lines_ ? Status::warning(kOnlyLines) : Status::ok();
  const std::string how = searches_grid_ ? "drive on until the laser has seen more"
                                         : "drive on until several of its landmarks are seen";
  const std::string ways = is_ambiguous_ ? "several places of the map look alike; " : "";
  if (belief_ == Belief::kLost)
    return Status::alarm((was_carried_ ? kCarried : kContradicted) + ways + how +
                         ", or set an initial pose");
  const std::string what = belief_ == Belief::kAnywhere
                               ? "the robot is looked for in the whole map: "
                               : "the place in the loaded map has not been recognised yet: ";
  return Status::warning(what + ways + how + ", or set an initial pose");
}

}  // namespace slam::relocalisation
