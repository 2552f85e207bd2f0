// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/visual_odometry/consensus.hpp"

#include <algorithm>
#include <cmath>

namespace slam::visual_odometry {
namespace {

constexpr int kMaxTrials = 400;
constexpr double kConfidence = 0.9999;  // that a pair without outliers was drawn
constexpr double kMinScale = 0.5, kMaxScale = 2.0;

/// The similarity that takes two points exactly to two others; nothing where they nearly coincide.
std::optional<Similarity> throughPair(const PointMatch& first, const PointMatch& second) {
  const Eigen::Vector2d a = second.reference - first.reference, b = second.now - first.now;
  const double length = b.norm();
  if (!(length > 10.0 * (first.sigma + second.sigma))) return std::nullopt;
  const double scale = a.norm() / length;
  if (scale < kMinScale || scale > kMaxScale) return std::nullopt;
  const Pose2 turn(0.0, 0.0, std::atan2(b.x() * a.y() - b.y() * a.x(), b.dot(a)));
  const Eigen::Vector2d t = first.reference - scale * (turn.rotation() * first.now);
  return Similarity{scale, Pose2(t.x(), t.y(), turn.theta())};
}

/// A test that a match agrees, quick as it is asked often.
class Agreement {
 public:
  Agreement(const Similarity& motion, double threshold)
      : A_(motion.scale * motion.T_reference_now.rotation()),
        t_(motion.T_reference_now.position()),
        threshold2_(threshold * threshold) {}

  bool operator()(const PointMatch& match) const {
    const Eigen::Vector2d error = match.reference - A_ * match.now - t_;
    return error.squaredNorm() <= threshold2_ * match.sigma * match.sigma;
  }

 private:
  Eigen::Matrix2d A_;
  Eigen::Vector2d t_;
  double threshold2_;
};

int trialsFor(double inlier_share) {
  const double miss = 1.0 - inlier_share * inlier_share;
  if (miss <= 0.0) return 1;
  const double trials = std::log(1.0 - kConfidence) / std::log(miss);
  return static_cast<int>(std::min<double>(kMaxTrials, std::ceil(trials)));
}

}  // namespace

PointMatches agreeing(const PointMatches& matches, const Similarity& motion, double threshold) {
  PointMatches kept;
  std::copy_if(matches.begin(), matches.end(), std::back_inserter(kept),
               Agreement(motion, threshold));
  return kept;
}

std::optional<PointMatches> findConsensus(const PointMatches& matches, double threshold,
                                          RandomStream& random) {
  if (matches.size() < 2) return std::nullopt;
  const auto count = static_cast<double>(matches.size());
  const auto draw = [&]() -> const PointMatch& {
    return matches[static_cast<std::size_t>(random.uniform() * count)];
  };
  std::optional<Similarity> best;
  std::ptrdiff_t most = 0;
  int trials = kMaxTrials;
  for (int trial = 0; trial < trials; ++trial) {
    const auto& first = draw();
    const auto& second = draw();
    const auto motion = throughPair(first, second);
    if (!motion) continue;
    const auto agree = std::count_if(matches.begin(), matches.end(), Agreement(*motion, threshold));
    if (agree <= most) continue;
    most = agree;
    best = motion;
    trials = trialsFor(static_cast<double>(most) / count);
  }
  if (!best) return std::nullopt;
  return agreeing(matches, *best, threshold);
}

}  // namespace slam::visual_odometry
