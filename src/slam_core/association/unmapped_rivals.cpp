// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/association/unmapped_rivals.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "slam_core/association/descriptor_map.hpp"

namespace slam::association {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
/// The landmarks that a sensor sees at once fill a sector of at least this width [rad].
constexpr double kLeastSector = 0.5;
/// Fewer observations cannot confirm one another.
constexpr std::size_t kFewestObservations = 6;
/// If ln(|S| / |R|) exceeds this, the prediction is far less certain than the observation, and the
/// pose leaves room for rivals.
constexpr double kVaguePrediction = 3.0;
/// Twice the log-likelihood ratio of a hundred thousand to one. With a stricter bound, landmarks
/// are mapped a second time before enough of them are seen at once.
constexpr double kBeyondChance = 23.0;

double costOf(const Eigen::Vector2d& nu, const Eigen::Matrix2d& S) {
  return nu.dot(S.inverse() * nu) + std::log(S.determinant());
}

/// @return the width of the smallest sector that holds all bearings, of which there are some [rad]
double sectorOf(std::vector<double> bearings) {
  std::sort(bearings.begin(), bearings.end());
  double widest = bearings.front() + 2.0 * M_PI - bearings.back();
  for (std::size_t i = 1; i < bearings.size(); ++i)
    widest = std::max(widest, bearings[i] - bearings[i - 1]);
  return 2.0 * M_PI - widest;
}

/// The area of the sector that holds all points [m^2].
double areaOf(const std::vector<LandmarkObservation>& points) {
  double range = 0.0;
  std::vector<double> bearings;
  for (const auto& z : points) {
    range = std::max(range, z.range);
    bearings.push_back(z.bearing);
  }
  return 0.5 * range * range * std::max(kLeastSector, sectorOf(bearings));
}

}  // namespace

void UnmappedRivals::configure(double probability, double margin) {
  probability_ = probability;
  margin_ = margin;
}

void UnmappedRivals::judge(const LandmarkObservationArray& array, const Options& options,
                           const CandidateSource& source,
                           std::vector<JointSearch::Choice>& choices) {
  points_.clear();
  for (const auto& z : array.observations)
    if (!z.isLine()) points_.push_back(z);
  if (points_.size() < kFewestObservations) return;
  gather(array, options, choices);
  const auto is_certain = [](const Paired& paired) { return paired.is_certain; };
  if (std::all_of(paired_.begin(), paired_.end(), is_certain)) return;
  leaveOutUnconfirmed(source, choices);
  if (std::all_of(paired_.begin(), paired_.end(), is_certain)) return;
  if (gainOfUncertain() >= kBeyondChance) return;
  for (const auto& paired : paired_)
    if (!paired.is_certain) choices[paired.choice].is_ambiguous = true;
}

void UnmappedRivals::leaveOutUnconfirmed(const CandidateSource& source,
                                         std::vector<JointSearch::Choice>& choices) {
  while (!paired_.empty()) {
    fillInformation(source, choices);
    std::vector<double> gains;
    for (std::size_t i = 0; i < paired_.size(); ++i)
      gains.push_back(paired_[i].is_certain ? kNever : gainOf(i));
    const auto worst = std::min_element(gains.begin(), gains.end());
    if (*worst >= margin_) return;
    const auto place = worst - gains.begin();
    choices[paired_[static_cast<std::size_t>(place)].choice].is_ambiguous = true;
    paired_.erase(paired_.begin() + place);
  }
}

void UnmappedRivals::gather(const LandmarkObservationArray& array, const Options& options,
                            const std::vector<JointSearch::Choice>& choices) {
  paired_.clear();
  const double area = areaOf(points_);
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const auto& [observation, option, is_ambiguous] = choices[i];
    if (option < 0 || is_ambiguous || array.observations[observation].isLine()) continue;
    const double rival =
        -2.0 * std::log(2.0 * M_PI * densityOf(array.observations[observation], area));
    const auto& taken = options.of(observation)[static_cast<std::size_t>(option)];
    const bool is_certain = std::log(taken.S.determinant()) - taken.log_noise < kVaguePrediction ||
                            rival - costOf(taken.nu, taken.S) >= margin_;
    paired_.push_back({i, &taken, rival, is_certain});
  }
}

/// @return landmarks that look like the observation's, in a unit of range and bearing [1/(m rad)]
double UnmappedRivals::densityOf(const LandmarkObservation& z, double area) const {
  const auto is_alike = [&](const LandmarkObservation& other) {
    return fitOf(z.descriptor, other.descriptor, probability_).passes;
  };
  const auto alike = std::count_if(points_.begin(), points_.end(), is_alike);
  return static_cast<double>(alike) * z.range / area;
}

void UnmappedRivals::fillInformation(const CandidateSource& source,
                                     const std::vector<JointSearch::Choice>& choices) {
  const auto rows = 2 * static_cast<Eigen::Index>(paired_.size());
  Eigen::MatrixXd S(rows, rows);
  Eigen::VectorXd nu(rows);
  const auto pairing = [&](const Paired& paired) {
    return Pairing{choices[paired.choice].observation, paired.option->landmark};
  };
  for (Eigen::Index i = 0; i < rows; i += 2) {
    const auto& first = paired_[static_cast<std::size_t>(i / 2)];
    S.block<2, 2>(i, i) = first.option->S;
    nu.segment<2>(i) = first.option->nu;
    for (Eigen::Index j = 0; j < i; j += 2) {
      const auto& second = paired_[static_cast<std::size_t>(j / 2)];
      S.block<2, 2>(i, j) = source.crossCovariance(pairing(first), pairing(second));
      S.block<2, 2>(j, i) = S.block<2, 2>(i, j).transpose();
    }
  }
  information_ = S.llt().solve(Eigen::MatrixXd::Identity(rows, rows));
  weighted_ = information_ * nu;
}

/// Given the others the innovation has the covariance (Lambda_ii)^-1 and differs by
/// (Lambda_ii)^-1 (Lambda nu)_i from what they predict, where Lambda is the information of all.
double UnmappedRivals::gainOf(std::size_t pairing) const {
  const auto row = 2 * static_cast<Eigen::Index>(pairing);
  const Eigen::Matrix2d S = information_.block<2, 2>(row, row).inverse();
  return paired_[pairing].rival - costOf(S * weighted_.segment<2>(row), S);
}

double UnmappedRivals::gainOfUncertain() const {
  std::vector<Eigen::Index> rows;
  double rivals = 0.0;
  for (std::size_t i = 0; i < paired_.size(); ++i) {
    if (paired_[i].is_certain) continue;
    rivals += paired_[i].rival;
    for (const Eigen::Index row : {0, 1}) rows.push_back(2 * static_cast<Eigen::Index>(i) + row);
  }
  const Eigen::MatrixXd information = information_(rows, rows);
  const Eigen::VectorXd weighted = weighted_(rows);
  const auto ldlt = information.ldlt();
  return rivals - weighted.dot(ldlt.solve(weighted)) + ldlt.vectorD().array().log().sum();
}

}  // namespace slam::association
