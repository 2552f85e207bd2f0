// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_ekf/place_search.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "slam_core/mono_ekf/consensus.hpp"
#include "slam_core/mono_ekf/corner_finder.hpp"

namespace slam::mono_ekf {
namespace {

constexpr std::size_t kMostCorners = 300, kMostAlike = 120, kMostPairs = 400;
constexpr std::size_t kCornersOfAFeature = 2;
constexpr double kScales[] = {0.71, 1.0, 1.41};  // of the surroundings, between the images
constexpr float kLeastAlike = 0.85F;             // correlation
constexpr double kCornerSigma = 2.0;             // of a corner that looks like a feature [px]
constexpr double kNearViews = 2.0;             // [m], between first sights of what is seen together
constexpr double kLargestDistanceRatio = 2.0;  // of a feature, now and at first sight
constexpr std::size_t kTested = 3, kLeastFits = 5;
constexpr double kElsewhere = 0.3;  // [m, rad], of another place
constexpr std::size_t kLeastMatched = 10;
constexpr double kLeastMatchedShare = 0.7;  // of what should be in view
constexpr double kRivalShare = 0.5;         // of what the best place has

bool isElsewhere(const Pose2& a, const Pose2& b) {
  const Pose2 apart = a.between(b);
  return apart.position().norm() > kElsewhere || std::abs(apart.theta()) > kElsewhere;
}

NormalisedCamera normalised(const PlanarCamera& camera) {
  return NormalisedCamera(camera.pose(Pose2()));
}

bool isInImage(const PlanarCamera& camera, const Pose2& pose, const Eigen::Vector3d& point) {
  const auto seen = camera.project(pose, point - camera.centre(pose));
  if (!seen) return false;
  const auto& c = camera.model().calibration();
  return (seen->pixel.array() >= 0.0).all() && seen->pixel.x() < c.width &&
         seen->pixel.y() < c.height;
}

/// @return the standard deviation, on the plane z = 1, of a corner that looks like a feature
double cornerSigmaOf(const PlanarCamera& camera) {
  return kCornerSigma / camera.model().calibration().fx;
}

}  // namespace

PoseEstimate anywhereNear(const Pose2& pose) {
  constexpr double kSigma = 1.0, kSigmaHeading = 0.5;  // [m], [rad]
  return {pose, Eigen::Vector3d(kSigma, kSigma, kSigmaHeading).cwiseAbs2().asDiagonal()};
}

PlaceSearch::PlaceSearch(const MonoEkfConfig& config, const MonoState& state, double sigma)
    : config_(config), sigma_(sigma), active_search_(config) {
  for (std::size_t i = 0; i < state.features().size(); ++i) {
    const auto& feature = state.features()[i];
    if (!feature.is_point || !feature.isProven()) continue;
    const Eigen::Vector2d middle(Patch::kStoredRadius, Patch::kStoredRadius);
    const auto descriptor = describe(smoothed(feature.first.patch), middle, 1.0);
    if (!descriptor) continue;
    known_.push_back({i, *pointOf(feature, coordinatesOf(state, feature)), feature.first.centre,
                      feature.first.ray, *descriptor});
  }
  descriptors_.resize(PatchDescriptor::RowsAtCompileTime, static_cast<Eigen::Index>(known_.size()));
  for (std::size_t i = 0; i < known_.size(); ++i)
    descriptors_.col(static_cast<Eigen::Index>(i)) = known_[i].descriptor;
}

/// Each feature once.
std::vector<PlaceSearch::Alike> PlaceSearch::fittingOnes(const NormalisedCamera& camera,
                                                         const std::vector<Alike>& matches,
                                                         const Pose2& pose) {
  std::vector<Alike> fitting;
  std::set<std::size_t> taken;
  for (const auto& match : matches)
    if (countFits(camera, {match.sighting}, pose) > 0 && taken.insert(match.known).second)
      fitting.push_back(match);
  return fitting;
}

/// Compares all corners with all features with depth.
PlaceSearch::Comparison PlaceSearch::compare(const cv::Mat& gray) const {
  Comparison comparison;
  auto& [corners, correlations] = comparison;
  corners = cornersOf(gray, {}, config_.least_gradient, config_.spacing / 2, Patch::kStoredRadius);
  if (corners.size() > kMostCorners) corners.resize(kMostCorners);
  const cv::Mat smooth = smoothed(gray);
  correlations =
      Eigen::MatrixXf::Zero(descriptors_.cols(), static_cast<Eigen::Index>(corners.size()));
  for (std::size_t c = 0; c < corners.size(); ++c)
    for (const double scale : kScales)
      if (const auto descriptor = describe(smooth, corners[c], scale)) {
        auto column = correlations.col(static_cast<Eigen::Index>(c));
        column = column.cwiseMax(descriptors_.transpose() * *descriptor);
      }
  return comparison;
}

/// Finds the corners that look most like each of these features; the best ones come first.
std::vector<PlaceSearch::Alike> PlaceSearch::alike(const Comparison& comparison,
                                                   const PlanarCamera& camera,
                                                   const std::vector<bool>& is_considered) const {
  std::vector<Alike> all;
  const auto& [corners, correlations] = comparison;
  const double sigma = cornerSigmaOf(camera);
  for (std::size_t k = 0; k < known_.size(); ++k) {
    if (!is_considered[k]) continue;
    std::vector<std::pair<float, std::size_t>> ranked;
    for (std::size_t c = 0; c < corners.size(); ++c)
      if (const float value =
              correlations(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(c));
          value >= kLeastAlike)
        ranked.emplace_back(-value, c);
    std::sort(ranked.begin(), ranked.end());
    if (ranked.size() > kCornersOfAFeature) ranked.resize(kCornersOfAFeature);
    for (const auto& [value, corner] : ranked)
      if (const auto seen = camera.model().unproject(corners[corner]))
        all.push_back({k, corner, -value, corners[corner], {known_[k].point, *seen, sigma}});
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Alike& a, const Alike& b) { return a.correlation > b.correlation; });
  if (all.size() > kMostAlike) all.resize(kMostAlike);
  return all;
}

/// Whether a patch may be recognised from there.
bool PlaceSearch::isSeenAlike(const NormalisedCamera& camera, const Pose2& pose,
                              const Known& known) const {
  const Eigen::Vector3d vector = known.point - camera.centre(pose);
  const double ratio = vector.norm() / (known.point - known.centre).norm();
  return ratio < kLargestDistanceRatio && ratio > 1.0 / kLargestDistanceRatio &&
         vector.dot(known.ray) > std::cos(config_.largest_view_change) * vector.norm();
}

/// It begins where the first feature was seen first, with the camera turned to where it is now.
std::optional<Pose2> PlaceSearch::poseOf(const NormalisedCamera& camera, const Alike& a,
                                         const Alike& b) const {
  const auto& first = known_[a.known];
  const Eigen::Vector3d in_base = camera.ray(Pose2(), a.sighting.seen);
  const double heading =
      std::atan2(first.ray.y(), first.ray.x()) - std::atan2(in_base.y(), in_base.x());
  const Eigen::Vector3d offset = camera.centre(Pose2(0.0, 0.0, heading));
  const Pose2 start(first.centre.x() - offset.x(), first.centre.y() - offset.y(), heading);
  const auto fit = fitPose(camera, {a.sighting, b.sighting}, start, std::nullopt);
  if (!fit || fit->count < 2 || !isSeenAlike(camera, fit->pose, first) ||
      !isSeenAlike(camera, fit->pose, known_[b.known]))
    return std::nullopt;
  return fit->pose;
}

/// The poses that most others fit come first.
std::vector<PlaceSearch::Hypothesis> PlaceSearch::hypotheses(
    const NormalisedCamera& camera, const std::vector<Alike>& matches) const {
  std::vector<PoseSighting> sightings;
  for (const auto& match : matches) sightings.push_back(match.sighting);
  std::vector<Hypothesis> found;
  std::size_t pairs = 0;
  for (std::size_t j = 1; j < matches.size(); ++j)
    for (std::size_t i = 0; i < j && pairs < kMostPairs; ++i) {
      const auto &a = matches[i], &b = matches[j];
      if (a.known == b.known || a.corner == b.corner ||
          (known_[a.known].centre - known_[b.known].centre).norm() > kNearViews)
        continue;
      ++pairs;
      const auto pose = poseOf(camera, a, b);
      if (!pose) continue;
      const auto fits = countFits(camera, sightings, *pose);
      if (fits >= kLeastFits) found.push_back({*pose, fits});
    }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.fits > b.fits; });
  return found;
}

/// The features that may be recognised from a pose, and the robot there, as the corners that look
/// like features have it: where the robot is in the map is known better then than where the map is.
MonoState PlaceSearch::placed(const MonoState& state, const Pose2& pose, const PlanarCamera& camera,
                              const std::vector<Alike>& fitting,
                              std::vector<std::size_t>& features) const {
  std::map<std::size_t, std::size_t> part_of;  // by feature
  for (const auto& known : known_)
    if (isSeenAlike(normalised(camera), pose, known)) {
      part_of[known.feature] = features.size();
      features.push_back(known.feature);
    }
  auto part = partOf(state, features);
  part.place(anywhereNear(pose));
  std::vector<Measurement> measurements;
  for (const auto& match : fitting) {
    const auto in_part = part_of.find(known_[match.known].feature);
    if (in_part == part_of.end()) continue;
    const auto& feature = part.features()[in_part->second];
    const auto prediction = predictedPixel(camera, pose, feature, coordinatesOf(part, feature));
    if (prediction)
      measurements.push_back({feature.offset, *prediction, match.pixel - prediction->pixel});
  }
  part.update(measurements, kCornerSigma);
  return part;
}

/// Searches for everything that should be in view from there.
PlaceSearch::Tested PlaceSearch::test(const MonoState& state, const Pose2& pose,
                                      const PlanarCamera& camera, const cv::Mat& gray,
                                      const std::vector<Alike>& fitting) const {
  std::vector<std::size_t> features;
  const auto part = placed(state, pose, camera, fitting, features);
  Tested tested;
  auto& searches = tested.place.searches;
  searches = active_search_.searchNear(part, camera, gray, sigma_, {});
  std::vector<Match> matches;
  std::vector<Search*> found;
  for (auto& search : searches)
    if (search.outcome == Search::Outcome::kRejected) {
      matches.push_back({search.feature, search.found});
      found.push_back(&search);
    }
  const auto agrees = consensusOf(part, matches, camera, sigma_).agrees;
  std::vector<PoseSighting> sightings;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!agrees[i]) continue;
    found[i]->outcome = Search::Outcome::kMatched;
    const auto& feature = part.features()[found[i]->feature];
    const auto seen = camera.model().unproject(found[i]->found);
    if (seen) sightings.push_back({coordinatesOf(part, feature), *seen, cornerSigmaOf(camera)});
  }
  tested.matched = sightings.size();
  const auto fit = fitPose(normalised(camera), sightings, pose, std::nullopt);
  tested.place.pose = fit ? fit->pose : pose;
  tested.is_good = fit && tested.matched >= kLeastMatched &&
                   static_cast<double>(tested.matched) >=
                       kLeastMatchedShare * static_cast<double>(searches.size());
  for (auto& search : searches) search.feature = features[search.feature];
  return tested;
}

/// Tests the first of these places; those that lead to the same one count once.
std::vector<PlaceSearch::Tested> PlaceSearch::placesOf(const MonoState& state,
                                                       const PlanarCamera& camera,
                                                       const cv::Mat& gray,
                                                       const std::vector<Alike>& matches) const {
  std::vector<Tested> tested;
  std::vector<Pose2> begun;
  const auto isNew = [&](const Pose2& pose) {
    return std::all_of(begun.begin(), begun.end(),
                       [&](const Pose2& other) { return isElsewhere(pose, other); });
  };
  const auto lens = normalised(camera);
  for (const auto& place : hypotheses(lens, matches)) {
    if (begun.size() >= kTested) break;
    if (!isNew(place.pose)) continue;
    const auto fitting = fittingOnes(lens, matches, place.pose);
    std::vector<PoseSighting> sightings;
    for (const auto& match : fitting) sightings.push_back(match.sighting);
    const auto fit = fitPose(lens, sightings, place.pose, std::nullopt);
    const Pose2 pose = fit ? fit->pose : place.pose;
    if (!isNew(pose)) continue;
    begun.push_back(pose);
    tested.push_back(test(state, pose, camera, gray, fitting));
  }
  return tested;
}

std::optional<FoundPlace> PlaceSearch::find(const MonoState& state, const PlanarCamera& camera,
                                            const cv::Mat& gray) const {
  const auto comparison = compare(gray);
  std::vector<bool> is_considered(known_.size(), true);
  auto places = placesOf(state, camera, gray, alike(comparison, camera, is_considered));
  const auto best =
      std::max_element(places.begin(), places.end(), [](const Tested& a, const Tested& b) {
        return std::make_tuple(a.is_good, a.matched) < std::make_tuple(b.is_good, b.matched);
      });
  if (best == places.end() || !best->is_good) return std::nullopt;
  const auto isRival = [&](const Tested& other) {
    return isElsewhere(other.place.pose, best->place.pose) &&
           static_cast<double>(other.matched) > kRivalShare * static_cast<double>(best->matched);
  };
  if (std::any_of(places.begin(), places.end(), isRival)) return std::nullopt;
  for (std::size_t k = 0; k < known_.size(); ++k)
    is_considered[k] = !isInImage(camera, best->place.pose, known_[k].point);
  const auto others = placesOf(state, camera, gray, alike(comparison, camera, is_considered));
  if (std::any_of(others.begin(), others.end(), isRival)) return std::nullopt;
  return std::move(best->place);
}

}  // namespace slam::mono_ekf
