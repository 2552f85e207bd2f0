// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/mono_graph/two_views.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "slam_core/geometry/covariance.hpp"
#include "slam_core/models/chi_square.hpp"

namespace slam::mono_graph {
namespace {

constexpr double kNearestDepth = 1.0, kFarthestDepth = 50.0;  // of what a camera sees [m]
constexpr double kSearchMargin = 10.0;  // around where a feature is predicted [px]
constexpr double kHeadingSigmas = 3.0;
constexpr int kLargestDistance = 60;  // of descriptors
constexpr double kDistinct = 0.85;    // of the best one's distance to the second one's
constexpr int kLevelsApart = 1;

constexpr std::size_t kMostSearched = 400;
constexpr std::size_t kLeastAgreeing = 20;
constexpr double kLeastShare = 0.5;      // of the pairs, that agree
constexpr double kLeastBaseline = 0.01;  // [m]
constexpr double kLargestTurn = 0.6;     // [rad] from what odometry says; a view is hardly wider
constexpr double kError = 1.0;           // standard deviation of the heading that is found [px]
constexpr double kStep = 2.0, kFineStep = 0.25;  // between headings that are tried [px]

/// The part of the image in which a feature may be seen again.
using Box = Eigen::AlignedBox2d;

/// An unknown depth and an error of the heading both put a feature elsewhere along a line. Nothing
/// where it may be out of view.
std::optional<Box> reachOf(const Features& earlier, const Feature& feature, const Features& later,
                           const PosePrior& odometry) {
  const Eigen::Vector3d ray = earlier.camera().ray({}, feature.seen);
  const Eigen::Vector3d centre = earlier.camera().centre({});
  const double turn = kHeadingSigmas * std::sqrt(odometry.covariance(2, 2));
  Box box;
  for (const double depth : {kNearestDepth, kFarthestDepth}) {
    const auto expected = later.camera().project(odometry.pose, centre + depth * ray);
    if (!expected || !later.covers(*expected)) return std::nullopt;
    for (const double off : {-turn, turn}) {
      const Pose2 turned(odometry.pose.x(), odometry.pose.y(), odometry.pose.theta() + off);
      box.extend(later.camera().project(turned, centre + depth * ray).value_or(*expected));
    }
  }
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(kSearchMargin / later.focal());
  return Box(box.min() - margin, box.max() + margin);
}

/// @return the one of some features that clearly looks most alike
std::optional<std::size_t> mostAlike(const Feature& feature, const Features& later,
                                     const std::vector<std::size_t>& near) {
  BestMatch best;
  for (const std::size_t i : near) {
    const auto& other = later[i];
    if (std::abs(other.level - feature.level) > kLevelsApart ||
        turnBetween(other.angle, feature.angle) > kLargestRoll)
      continue;
    best.consider(i, distanceOf(other.descriptor, feature.descriptor));
  }
  return best.isClear(kLargestDistance, kDistinct) ? std::optional(best.candidate) : std::nullopt;
}

/// @return how much the constraint below changes with a feature's place in the image
/// @param by_ray its derivative by the feature's ray
double spread(const Eigen::Vector3d& by_ray, const NormalisedCamera& camera, const Pose2& pose) {
  const Eigen::Vector3d axis = camera.ray(pose, Eigen::Vector2d::Zero());
  return std::max(0.0, by_ray.squaredNorm() - std::pow(by_ray.dot(axis), 2));
}

/// The squared residual of a pair's epipolar constraint in its standard deviations.
double chi2Of(const Features& earlier, const Feature& a, const Features& later, const Feature& b,
              const Pose2& pose) {
  constexpr double kLeastVariance = 1e-18;
  const Eigen::Vector3d ray_a = earlier.camera().ray({}, a.seen);
  const Eigen::Vector3d ray_b = later.camera().ray(pose, b.seen);
  const Eigen::Vector3d way = later.camera().centre(pose) - earlier.camera().centre({});
  const double variance = a.sigma * a.sigma * spread(ray_b.cross(way), earlier.camera(), {}) +
                          b.sigma * b.sigma * spread(way.cross(ray_a), later.camera(), pose);
  const double residual = way.dot(ray_a.cross(ray_b));
  return residual * residual / std::max(variance, kLeastVariance);
}

/// This says how well a motion explains some pairs.
struct Agreement {
  double loss = 0.0;      ///< those that contradict it count alike (MSAC: Torr and Zisserman 2000)
  std::size_t count = 0;  ///< of those that agree
};

Agreement agreementOf(const Features& earlier, const Features& later,
                      const std::vector<FeaturePair>& pairs, const Pose2& pose) {
  Agreement agreement;
  for (const auto& pair : pairs) {
    const double chi2 = chi2Of(earlier, earlier[pair.earlier], later, later[pair.later], pose);
    agreement.loss += std::min(chi2, kGateOfOne);
    agreement.count += chi2 <= kGateOfOne ? 1 : 0;
  }
  return agreement;
}

/// @return what odometry says if the heading differs by so much from the expected one
/// @param sigma of the heading
PosePrior withHeading(const PosePrior& odometry, double off, double sigma) {
  const Eigen::Matrix3d& P = odometry.covariance;
  const Eigen::Vector3d gain = P.col(2) / P(2, 2);
  return {Pose2::fromVector(odometry.pose.vector() + gain * off),
          symmetric(P + (sigma * sigma - P(2, 2)) * gain * gain.transpose())};
}

}  // namespace

FeaturePairs pairFeatures(const Features& earlier, const Features& later, const PosePrior& odometry,
                          std::size_t most) {
  FeaturePairs found;
  std::vector<std::size_t> near;
  for (std::size_t i = 0; i < earlier.size() && found.expected < most; ++i) {
    const auto reach = reachOf(earlier, earlier[i], later, odometry);
    if (!reach) continue;
    near.clear();
    later.within(*reach, near);
    ++found.expected;
    const auto match = mostAlike(earlier[i], later, near);
    if (match) found.pairs.push_back({i, *match});
  }
  return found;
}

std::optional<PosePrior> motionBetween(const Features& earlier, const Features& later,
                                       const PosePrior& odometry) {
  const double sigma = std::sqrt(odometry.covariance(2, 2)), error = kError / later.focal();
  const Eigen::Vector3d way = later.camera().centre(odometry.pose) - earlier.camera().centre({});
  if (later.focal() != earlier.focal() || way.norm() < kLeastBaseline || !(sigma > error))
    return std::nullopt;
  const auto pairs = pairFeatures(earlier, later, odometry, kMostSearched).pairs;
  double off = 0.0;
  auto best = agreementOf(earlier, later, pairs, odometry.pose);
  const auto search = [&](double around, double reach, double step) {
    const int steps = static_cast<int>(std::ceil(reach / step));
    for (int i = -steps; i <= steps; ++i) {
      const double tried = around + i * step;
      const auto agreement =
          agreementOf(earlier, later, pairs, withHeading(odometry, tried, 0.0).pose);
      if (agreement.loss >= best.loss) continue;
      best = agreement;
      off = tried;
    }
  };
  search(0.0, std::min(kHeadingSigmas * sigma, kLargestTurn), kStep / later.focal());
  search(off, kStep / later.focal(), kFineStep / later.focal());
  const double share = static_cast<double>(best.count) / static_cast<double>(pairs.size());
  if (best.count < kLeastAgreeing || share < kLeastShare) return std::nullopt;
  return withHeading(odometry, off, error);
}

}  // namespace slam::mono_graph
