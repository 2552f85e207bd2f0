// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/landmark_graph/parameter_variables.hpp"

#include <array>
#include <cmath>
#include <memory>

namespace slam::landmark_graph {
namespace {

using Pair = std::array<CalibrationParameter, 2>;

/// Which parameters share a variable. The last two are there only where one of them is estimated.
constexpr std::array<Pair, 4> kPairs = {{{kWheelScale, kWheelBase},
                                         {kWheelDrift, kSensorYaw},
                                         {kSensorX, kSensorY},
                                         {kRangeScale, kTimeOffset}}};

}  // namespace

ParameterVariables::ParameterVariables(graph::Optimizer& graph, const CalibrationEstimate& prior) {
  constexpr double kUnused = 1.0;  // the variance of what no factor depends on
  const bool has_range_scale = prior.covariance(kRangeScale, kRangeScale) > 0.0;
  const std::size_t pairs = has_range_scale ? kPairs.size() : kPairs.size() - 1;
  Eigen::VectorXd known(2 * static_cast<Eigen::Index>(pairs));
  for (std::size_t i = 0; i < pairs; ++i) {
    const auto& [first, second] = kPairs[i];
    const Eigen::Vector2d values(prior.parameters(first), prior.parameters(second));
    keys_.push_back(graph.add(values));
    known.segment<2>(2 * static_cast<Eigen::Index>(i)) = values;
  }
  Eigen::MatrixXd P(known.size(), known.size());
  for (const auto& a : kPairs)
    for (const auto first : a)
      for (const auto& b : kPairs)
        for (const auto second : b)
          if (row(first) >= 0 && row(second) >= 0)
            P(row(first), row(second)) = prior.covariance(first, second);
  for (Eigen::Index i = 0; i < P.rows(); ++i)
    if (P(i, i) == 0.0) P(i, i) = kUnused;
  graph.add(std::make_shared<graph::ParameterPrior>(keys_, known, graph::weightOfCovariance(P)));
}

Eigen::Index ParameterVariables::row(CalibrationParameter parameter) const {
  for (std::size_t i = 0; i < keys_.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k)
      if (kPairs[i][k] == parameter) return static_cast<Eigen::Index>(2 * i + k);
  return -1;
}

CalibrationVector ParameterVariables::values(const graph::Optimizer& graph) const {
  CalibrationVector values = CalibrationVector::Zero();
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    const auto variable = graph.pose(keys_[i]);
    values(kPairs[i][0]) = variable.x();
    values(kPairs[i][1]) = variable.y();
  }
  return values;
}

CalibrationEstimate ParameterVariables::estimate(const graph::Optimizer& graph) const {
  CalibrationEstimate estimate;
  estimate.parameters = values(graph);
  const Eigen::MatrixXd P = graph.covariance(keys_);
  for (Eigen::Index i = 0; i < kCalibrationRows; ++i)
    for (Eigen::Index j = 0; j < kCalibrationRows; ++j) {
      const auto a = row(static_cast<CalibrationParameter>(i));
      const auto b = row(static_cast<CalibrationParameter>(j));
      const bool is_known = i == kTimeOffset || j == kTimeOffset;
      if (a >= 0 && b >= 0 && !is_known) estimate.covariance(i, j) = P(a, b);
    }
  return estimate;
}

graph::CalibratedSighting::At sensorPart(const CalibrationVector& parameters) {
  return {parameters(kSensorYaw),
          {parameters(kSensorX), parameters(kSensorY)},
          parameters(kRangeScale)};
}

}  // namespace slam::landmark_graph
