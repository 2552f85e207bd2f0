// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/mono_ekf.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <utility>

#include "slam_core/camera/camera_config.hpp"
#include "slam_core/contract/known_sections.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/mono_ekf/consensus.hpp"
#include "slam_core/mono_ekf/corner_finder.hpp"
#include "slam_core/mono_ekf/drawing.hpp"
#include "slam_core/mono_ekf/feature_seeds.hpp"

namespace slam::mono_ekf {
namespace {

const Registrar<Backend, MonoEkf> kRegistrar("mono_ekf");
const SectionRegistrar<MonoEkfConfig> kSectionRegistrar;

constexpr double kInitialVariance = 1e-6;  // [m^2, rad^2]
constexpr std::size_t kLeastCorners = 8;   // an image with fewer shows nothing
constexpr std::size_t kLeastMatches = 4;   // fewer may agree by chance
// of a feature: images after which it has left the view, matches that make it worth to be kept
// although its depth is not known
constexpr int kImagesInView = 3, kEnoughMatches = 10;
// of the inverse depth of a feature that is clearly before the camera, or behind it
constexpr double kClearSigmas = 2.0;

PoseEstimate start() { return {Pose2(), kInitialVariance * Eigen::Matrix3d::Identity()}; }

std::size_t countOf(const std::vector<Search>& searches, Search::Outcome outcome) {
  return static_cast<std::size_t>(std::count_if(
      searches.begin(), searches.end(), [&](const auto& each) { return each.outcome == outcome; }));
}

/// @return the inverse depth of a feature in its standard deviations
double depthScore(const MonoState& state, const Feature& feature) {
  const int at = feature.offset + 4;
  return state.mean()(at) / std::sqrt(state.covariance()(at, at));
}

Status lost() {
  return Status::alarm(
      "the robot is lost: the features are not where they are predicted, as after the robot or "
      "its camera was moved by hand; drive on slowly where the robot has been, or set an initial "
      "pose");
}

}  // namespace

void MonoEkf::describe(Ports& ports) {
  ports.takes<Motion>("motion", "motion", &inputs_).carrier();
  ports.takes<CameraView>(CameraConfig::kSection, "what the camera sees", &inputs_);
}

void MonoEkf::describe(Capabilities& capabilities) {
  capabilities.offer<CorrectionReporter>(*this);
  capabilities.offer<FeatureMapper>(*this);
  capabilities.offer<LostReporter>(*this);
  capabilities.offer<ViewDrawer>(*this);
  capabilities.offer<ViewReporter>(*this);
}

void MonoEkf::configure(const MonoEkfConfig& config) {
  requireUsable(config);
  config_ = config;
  active_search_ = ActiveSearch(config);
  reset();
}

void MonoEkf::configure(Settings& settings) { configure(settings.read<MonoEkfConfig>()); }

void MonoEkf::reset() {
  state_ = MonoState(start());
  errors_ = OdometryErrors(config_.systematic_share);
  noise_ = PixelNoise(config_.pixel_sigma);
  doubt_ = TrackingDoubt();
  agreement_.clear();
  before_.reset();
  place_search_.reset();
  corrected_by_.reset();
  inputs_ = {};
  next_id_ = 0;
  nis_ = 0.0;
  seen_ = {};
  has_view_ = false;
  counters_.clear();
}

Status MonoEkf::execute() {
  corrected_by_.reset();
  has_view_ = false;
  relocate();
  for (const auto& motion : std::exchange(inputs_.motions, {})) {
    state_.predict(errors_.divide(motion));
    agreement_.move(motion);
  }
  const auto view = std::exchange(inputs_.view, std::nullopt);
  return view ? look(*view) : Status::ok();
}

void MonoEkf::relocate() {
  if (!inputs_.initial_pose) return;
  putAt(*std::exchange(inputs_.initial_pose, std::nullopt));
}

void MonoEkf::putAt(const PoseEstimate& robot) {
  state_.place(robot);
  doubt_.settle();
  agreement_.clear();
  before_.reset();
  place_search_.reset();
}

Status MonoEkf::look(const CameraView& view) {
  seen_ = {};
  nis_ = 0.0;
  const auto& gray = view.image.gray;
  if (!view.isUsable() || gray.empty()) {
    counters_.add("unusable");
    return Status::ok();  // the camera's gate has said why
  }
  const PlanarCamera camera(view.camera, view.mount.T_base_camera);
  seen_.gray = gray;
  has_view_ = true;
  if (doubt_.isLost() && !findItself(camera, gray)) return lost();
  if (!before_) before_ = state_;
  take(active_search_.searchFar(state_, camera, gray, noise_.sigma()), camera);
  take(active_search_.searchNear(state_, camera, gray, noise_.sigma(), seen_.searches), camera);
  corrected_by_ = firstSeen();
  judgeExistence();
  const auto corners = beginFeatures(camera, gray, view.stamp);
  const auto status = judge(view.stamp, corners);
  if (doubt_.isLost()) return status;
  convertSure(state_, camera.centre(state_.robot().pose), config_.largest_linearity_index);
  removeFeatures();
  return status;
}

/// A lost robot maps nothing. Several images in a row have to show where it is before it is put
/// there.
bool MonoEkf::findItself(const PlanarCamera& camera, const cv::Mat& gray) {
  if (!place_search_) place_search_.emplace(config_, state_, noise_.sigma());
  const auto place = place_search_->find(state_, camera, gray);
  if (!place || !agreement_.add(place->pose)) return false;
  putAt(anywhereNear(place->pose));
  take(place->searches, camera);
  return true;
}

/// Updates the state with what the image agrees on; those become matched.
void MonoEkf::take(std::vector<Search> searches, const PlanarCamera& camera) {
  measure(searches, camera);
  for (const auto& search : searches) {
    seen_.searches.push_back(search);
    seen_.are_points.push_back(state_.features()[search.feature].is_point);
  }
}

void MonoEkf::measure(std::vector<Search>& searches, const PlanarCamera& camera) {
  std::vector<Match> matches;
  std::vector<Search*> found;
  for (auto& search : searches) {
    if (search.outcome == Search::Outcome::kNotFound) continue;
    matches.push_back({search.feature, search.found});
    found.push_back(&search);
  }
  const auto consensus = consensusOf(state_, matches, camera, noise_.sigma());
  for (std::size_t i = 0; i < matches.size(); ++i)
    found[i]->outcome =
        consensus.agrees[i] ? Search::Outcome::kMatched : Search::Outcome::kRejected;
  const auto agreed = consensus.measurements.size();
  const bool is_enough = agreed >= kLeastMatches && 2 * agreed >= matches.size();
  const auto statistics =
      is_enough ? state_.update(consensus.measurements, noise_.sigma()) : UpdateStatistics();
  if (!is_enough || !statistics.is_credible) {  // patterns that repeat, or a wrong mount
    for (auto* search : found) search->outcome = Search::Outcome::kRejected;
    if (agreed < matches.size()) noise_.doubt();
    return;
  }
  noise_.learn(statistics.score);
  nis_ = statistics.nis / static_cast<double>(2 * agreed);
}

/// Returns the stamp by which as many of the matched features as an update needs had begun.
std::optional<Stamp> MonoEkf::firstSeen() const {
  std::vector<Stamp> begun;
  for (const auto& search : seen_.searches)
    if (search.outcome == Search::Outcome::kMatched)
      begun.push_back(state_.features()[search.feature].begun);
  if (begun.size() < kLeastMatches) return std::nullopt;
  std::nth_element(begun.begin(), begun.begin() + (kLeastMatches - 1), begun.end());
  return begun[kLeastMatches - 1];
}

void MonoEkf::judgeExistence() {
  const auto& searches = seen_.searches;
  const auto matched = countOf(searches, Search::Outcome::kMatched);
  counters_.add("matched", matched);
  counters_.add("rejected", countOf(searches, Search::Outcome::kRejected));
  counters_.add("not_found", countOf(searches, Search::Outcome::kNotFound));
  for (auto& feature : state_.features()) ++feature.images_unsearched;
  const bool is_good = 3 * matched >= searches.size();  // else the image is at fault
  for (const auto& search : searches) {
    auto& feature = state_.features()[search.feature];
    feature.images_unsearched = 0;
    if (search.outcome == Search::Outcome::kMatched) {
      ++feature.matches;
      feature.existence = std::min(feature.existence + 1, Feature::kSurest);
    } else if (is_good || !feature.isProven()) {
      --feature.existence;
    }
  }
}

/// It begins features where the image has few. @return how many corners it has beside the features
std::size_t MonoEkf::beginFeatures(const PlanarCamera& camera, const cv::Mat& gray, Stamp stamp) {
  const auto matched = countOf(seen_.searches, Search::Outcome::kMatched);
  const auto wanted = static_cast<std::size_t>(config_.features_in_view);
  if (matched + wanted / 8 >= wanted) return 0;
  std::vector<Eigen::Vector2d> occupied;
  for (const auto& search : seen_.searches)
    occupied.push_back(search.outcome == Search::Outcome::kNotFound ? search.predicted
                                                                    : search.found);
  const auto corners =
      cornersOf(gray, occupied, config_.least_gradient, config_.spacing, Patch::kStoredRadius + 1);
  const double rho = 1.0 / config_.typical_distance;
  std::vector<MonoState::Seed> seeds;
  for (const auto& corner : corners) {
    if (matched + seeds.size() >= wanted) break;
    auto seed = seedAt(corner, gray, camera, state_.robot().pose, rho);
    if (!seed) continue;
    seed->feature.id = next_id_++;
    seed->feature.begun = stamp;
    seeds.push_back(std::move(*seed));
    seen_.added.push_back(corner);
  }
  state_.add(seeds, noise_.sigma(), (1.0 / config_.nearest - rho) / 2.0);
  counters_.add("added", seeds.size());
  return corners.size();
}

/// It removes features that are not there, those that left the view before much was known of them,
/// and where there are too many those that were seen least.
void MonoEkf::removeFeatures() {
  const auto& features = state_.features();
  std::vector<bool> kept;
  std::vector<std::pair<int, std::size_t>> out_of_view;  // by how often they were seen
  for (const auto& feature : features) {
    const bool is_fleeting = !feature.is_point && feature.matches < kEnoughMatches;
    const bool is_in_view = feature.images_unsearched <= kImagesInView;
    kept.push_back(feature.existence > 0 && (is_in_view || !is_fleeting));
    if (kept.back() && !is_in_view) out_of_view.emplace_back(feature.matches, kept.size() - 1);
  }
  auto count = std::count(kept.begin(), kept.end(), true);
  std::sort(out_of_view.begin(), out_of_view.end());
  for (const auto& [matches, which] : out_of_view) {
    if (count <= config_.most_features) break;
    kept[which] = false;
    --count;
  }
  counters_.add("given_up", features.size() - static_cast<std::size_t>(count));
  state_.keep(kept);
}

Status MonoEkf::judge(Stamp stamp, std::size_t corners) {
  const auto matched = countOf(seen_.searches, Search::Outcome::kMatched);
  const bool has_texture = matched + corners >= kLeastCorners;
  if (!has_texture && matched < kLeastMatches) {
    counters_.add("blank");
    return Status::warning(
        "the camera sees nothing that it could track, as in a dark room, before a blank wall or "
        "behind a lens cap: the pose goes on by odometry meanwhile");
  }
  if (has_texture) {
    doubt_.judge(viewOfMap(), state_.robot().pose, stamp);
    if (doubt_.isContradicted()) counters_.add("contradicted");
  }
  if (!doubt_.doubtedSince()) before_.reset();
  if (!doubt_.isLost()) return judgeDepths();
  lose();
  return lost();
}

/// Judges whether most features lie clearly behind the camera. Then odometry or the mount is wrong,
/// and the image corrects nothing.
Status MonoEkf::judgeDepths() {
  std::size_t behind = 0, before = 0;
  for (const auto& search : seen_.searches) {
    if (search.outcome != Search::Outcome::kMatched) continue;
    const auto& feature = state_.features()[search.feature];
    const double score = feature.is_point ? kClearSigmas : depthScore(state_, feature);
    before += score >= kClearSigmas ? 1 : 0;
    behind += score <= -kClearSigmas ? 1 : 0;
  }
  if (behind < kLeastCorners || behind <= before) return Status::ok();
  counters_.add("behind");
  corrected_by_.reset();
  return Status::warning(
      "what the camera sees moves as if it were behind the camera: odometry reports the reverse "
      "of how the robot drives, or the camera looks the other way than its mount says; check both");
}

/// Features that began in the doubt agree with the pose whether it is right or not.
ViewOfMap MonoEkf::viewOfMap() const {
  const auto since = doubt_.doubtedSince();
  ViewOfMap view;
  for (const auto& search : seen_.searches) {
    const auto& feature = state_.features()[search.feature];
    if (!feature.isProven() || (since && feature.begun >= *since)) continue;
    ++view.expected;
    view.found += search.outcome == Search::Outcome::kMatched ? 1 : 0;
  }
  return view;
}

/// The map is again what it was before the doubt; the robot may be anywhere in it.
void MonoEkf::lose() {
  counters_.add("tracking_lost");
  corrected_by_.reset();
  auto robot = state_.robot();
  state_ = *std::exchange(before_, std::nullopt);
  robot.covariance = start().covariance;
  state_.place(robot);
  agreement_.clear();
}

double MonoEkf::radiusOfMap() const {
  double radius = 1.0;
  for (const auto& feature : state_.features())
    if (const auto point = pointOf(feature, coordinatesOf(state_, feature)); feature.is_point)
      radius = std::max(radius, (point->head<2>() - state_.robot().pose.position()).norm());
  return radius;
}

PoseEstimate MonoEkf::pose() const {
  if (!doubt_.isLost()) return state_.robot();
  const Eigen::Vector3d sigmas(radiusOfMap(), radiusOfMap(), M_PI);
  return {state_.robot().pose, sigmas.cwiseAbs2().asDiagonal()};
}

std::vector<MappedFeature> MonoEkf::features() const {
  std::vector<MappedFeature> mapped;
  for (const auto& feature : state_.features())
    if (feature.is_point)
      mapped.push_back({feature.id, coordinatesOf(state_, feature),
                        state_.covariance().block<3, 3>(feature.offset, feature.offset)});
  return mapped;
}

cv::Mat MonoEkf::drawing() const {
  return draw(seen_.gray, seen_.searches, seen_.are_points, seen_.added);
}

std::optional<ViewStatistics> MonoEkf::viewStatistics() const {
  if (!has_view_) return std::nullopt;
  ViewStatistics view;
  view.expected = seen_.searches.size();
  view.matched = countOf(seen_.searches, Search::Outcome::kMatched);
  view.rejected = countOf(seen_.searches, Search::Outcome::kRejected);
  view.features = view.matched + view.rejected + seen_.added.size();
  return view;
}

Component::Figures MonoEkf::figures() const {
  const auto& features = state_.features();
  const auto points = std::count_if(features.begin(), features.end(),
                                    [](const auto& each) { return each.is_point; });
  return {
      {"features", static_cast<double>(features.size())},
      {"features_with_depth", static_cast<double>(points)},
      {"features_in_view", static_cast<double>(countOf(seen_.searches, Search::Outcome::kMatched))},
      {"image_nis", nis_},
      {"pixel_sigma", noise_.sigma()}};
}

void MonoEkf::saveState(ArchiveWriter& archive) const { archive(*this); }

void MonoEkf::restoreState(ArchiveReader& archive) { archive(*this); }

}  // namespace slam::mono_ekf
