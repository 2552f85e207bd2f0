// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/models/landmark_observation.hpp"

#include <fmt/format.h>

#include <cmath>

#include "slam_core/models/motion.hpp"

namespace slam {
namespace {

/// [m]; no sensor reaches as far, and the fourth power of it is a number still.
constexpr double kLargestRange = 1e15;
/// [m]; nearer to a sensor there is no room for a landmark, and the direction of one tells nothing.
constexpr double kSmallestRange = 1e-3;
/// [rad]; a driver counts turns, but not so many.
constexpr double kLargestBearing = 1e3;
/// [m], [rad]; no sensor is as sure. Information far beyond it leaves, by rounding, nothing of what
/// else is known.
constexpr double kSmallestSigma = 1e-9;

std::string faultOfSigmas(const Eigen::Vector2d& sigma) {
  std::string why;
  if (sigma.minCoeff() < kSmallestSigma)
    why = fmt::format("of which one is less than {:g}", kSmallestSigma);
  if (sigma.x() > kLargestInputSigmaLength || sigma.y() > kLargestInputSigmaAngle)
    why = fmt::format("more than {:g} m or {:g} rad", kLargestInputSigmaLength,
                      kLargestInputSigmaAngle);
  if (why.empty()) return why;
  return fmt::format(" has standard deviations of {:.3g} m and {:.3g} rad, ", sigma.x(),
                     sigma.y()) +
         why;
}

std::string faultOfKind(const LandmarkObservation& observation) {
  const auto& [begin, end] = observation.extent;
  if (observation.kind == LandmarkKind::kPoint) return "";
  if (!observation.isLine()) return " is of a kind that is neither point nor line";
  const bool is_part = begin < end && std::abs(begin) < kLargestRange && end < kLargestRange;
  return is_part ? "" : " is a line of which no part was seen";
}

}  // namespace

std::string faultOf(const LandmarkObservation& observation) {
  const auto name = "observation of landmark " + std::to_string(observation.id);
  if (observation.id < kUnknownId) return name + " has an impossible id";
  if (!std::isfinite(observation.range) || !std::isfinite(observation.bearing))
    return name + " holds a value that is not a number";
  if (observation.range <= 0.0) return name + " has a range that is not positive";
  if (observation.range < kSmallestRange && !observation.isLine())
    return name + fmt::format(" has a range of {:.3g} m, less than {:g} m", observation.range,
                              kSmallestRange);
  if (std::abs(observation.bearing) > kLargestBearing)
    return name +
           fmt::format(" has a bearing of {:.3g} rad, which is no angle", observation.bearing);
  if (observation.range > kLargestRange) return name + " has a range that no sensor reaches";
  if (!isCovariance(observation.covariance))
    return name + " has a covariance that is not positive definite";
  if (const auto fault = faultOfKind(observation); !fault.empty()) return name + fault;
  const auto fault = faultOfSigmas(observation.covariance.diagonal().cwiseSqrt());
  return fault.empty() ? fault : name + fault;
}

}  // namespace slam
