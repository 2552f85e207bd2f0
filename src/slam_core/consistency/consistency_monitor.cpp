// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/consistency/consistency_monitor.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace slam {
namespace {

/// A single observation with a larger NIS is an outlier and is not used to judge the noise.
constexpr double kOutlierNis = 100.0;
/// Updates before any sigma is named.
constexpr int kFewest = 10;
/// With right sigmas, a window exceeds this about once in a hundred thousand [standard deviations].
constexpr double kSignificant = 4.5;
/// Any fault looks like noise at first, and the fault of a sensor makes the predictions wrong at
/// once. So nothing is named before this number of updates agree, and the odometry is named only
/// where no sensor is off by half as much (in the logarithm) with kSuspicious evidence. An update
/// carries less information about the odometry, so that less evidence against it suffices.
constexpr int kAgreeing = 8;
constexpr double kSuspicious = 3.0, kSignificantMotion = 3.0;
/// A smaller bias is hidden in the noise of any sensor [standard deviations of a step].
constexpr double kSmallestBias = 0.3;
/// No sigma is named where the successive innovations of a landmark are correlated by more than
/// this coefficient.
constexpr double kAlike = 0.4;

/// The cube root of chi-square over its degrees of freedom is nearly normal, with the mean 1 - a
/// and the variance a (Wilson and Hilferty 1931). z: the quantile of the normal distribution.
double chiSquareOverDof(double dof, double z) {
  const double a = 2.0 / (9.0 * dof), root = 1.0 - a + z * std::sqrt(a);
  return root * root * root;
}

double normalQuantile(double chi_square_over_dof, double dof) {
  // An estimate below 1 may be negative, which no chi-square is, so that it is taken for normal.
  if (chi_square_over_dof < 1.0) return (chi_square_over_dof - 1.0) * std::sqrt(0.5 * dof);
  const double a = 2.0 / (9.0 * dof);
  return (std::cbrt(chi_square_over_dof) - 1.0 + a) / std::sqrt(a);
}

JointInnovation alone(const ObservationInnovation& observation) {
  return {observation.nu, observation.S, observation.R, {}};
}

/// The part of S that is due to a source: C = dS/dtheta, where theta is the relative excess of the
/// source's true variance; u = S^-1 nu.
struct Share {
  Eigen::MatrixXd of_S;  ///< S^-1 C
  double square = 0.0;   ///< u^T C u
};

Share sensorShare(const JointInnovation& group, const Eigen::MatrixXd& S_inverse,
                  const Eigen::VectorXd& u, std::size_t component) {
  Eigen::VectorXd variances = Eigen::VectorXd::Zero(u.size());
  for (auto i = static_cast<Eigen::Index>(component); i < u.size(); i += 2)
    variances(i) = group.R(i, i);
  return {S_inverse * variances.asDiagonal(), u.cwiseAbs2().dot(variances)};
}

Share odometryShare(const JointInnovation& group, const Eigen::MatrixXd& S_inverse,
                    const Eigen::VectorXd& u, const OdometrySensitivity& odometry) {
  const Eigen::MatrixXd C = group.H * odometry.covariance() * group.H.transpose();
  return {S_inverse * C, u.dot(C * u)};
}

/// The part of S that is due to neither sensor noise.
Share remainder(double nis, const Share& range, const Share& bearing) {
  const auto size = range.of_S.rows();
  return {Eigen::MatrixXd::Identity(size, size) - range.of_S - bearing.of_S,
          nis - range.square - bearing.square};
}

}  // namespace

void ConsistencyConfig::describe(Fields& fields) {
  fields.add("window", &window, "updates that are judged together")
      .unit("1")
      .in(Range::closed(kFewest, 100000));
  fields
      .add("warning_factor", &warning_factor,
           "a sigma that looks too small or too large by this factor is told")
      .unit("1")
      .in(Range::above(1));
  fields.add("adapt", &adapt,
             "noise of odometry, ranges or bearings that looks too small is enlarged until it does "
             "not, and the reported covariance is widened where the scale of the map is in doubt");
}

ConsistencyMonitor::ConsistencyMonitor(const ConsistencyConfig& config)
    : config_(config), gating_(config.window), bias_(config.window), serial_(config.window) {}

const char* ConsistencyMonitor::name(Source source) {
  static constexpr const char* kNames[] = {"range", "bearing", "odometry"};
  return kNames[source];
}

void ConsistencyMonitor::add(const UpdateStatistics& statistics) {
  gating_.add(statistics);
  is_lost_ = gating_.isExcessive();
  serial_.add(statistics.innovations);
  const auto score = scoreOf(statistics);
  if (score.dof == 0) return;
  if (statistics.joint.nu.size() > 0) bias_.add(statistics.joint, statistics.prediction);
  last_nis_ = statistics.nis;
  window_.push_back(score);
  if (window_.size() > static_cast<std::size_t>(config_.window)) window_.pop_front();
  judge();
}

ConsistencyMonitor::Score ConsistencyMonitor::scoreOf(const UpdateStatistics& statistics) {
  Score score;
  odometry_.predict(statistics.prediction);
  const bool is_joint = statistics.joint.nu.size() > 0;
  if (is_joint) addGroup(statistics.joint, score);
  if (statistics.joint.H.rows() > 0) odometry_.update(statistics.joint);
  for (const auto& observation : statistics.innovations) {
    const auto group = alone(observation);
    const double nis = group.nu.dot(group.S.llt().solve(group.nu));
    if (!(is_joint && observation.used) && nis < kOutlierNis) addGroup(group, score);
  }
  return score;
}

/// The slope with respect to the variance of a source is (u^T C u - tr S^-1 C) / 2, and the
/// information of two sources tr(S^-1 C_1 S^-1 C_2) / 2: score and Fisher information of a Gaussian
/// by its covariance (Kay 1993, sec. 3.9). The odometry moves the prediction as well, by H e, where
/// e is OdometrySensitivity::mean(): its slope gains u^T H e, its information e^T H^T S^-1 H e.
void ConsistencyMonitor::addGroup(const JointInnovation& group, Score& score) const {
  const Eigen::Index size = group.nu.size();
  const Eigen::MatrixXd S_inverse = group.S.llt().solve(Eigen::MatrixXd::Identity(size, size));
  const Eigen::VectorXd u = S_inverse * group.nu;
  std::array<Share, kSources> shares;
  for (const auto sensor : {kRange, kBearing})
    shares[sensor] = sensorShare(group, S_inverse, u, sensor);
  if (group.H.rows() > 0) {
    shares[kMotion] = odometryShare(group, S_inverse, u, odometry_);
    const Eigen::VectorXd lag = group.H * odometry_.mean();
    score.slope(kMotion) += u.dot(lag);
    score.information(kMotion, kMotion) += lag.dot(S_inverse * lag);
  } else {
    shares[kMotion] = remainder(u.dot(group.nu), shares[kRange], shares[kBearing]);
  }
  for (std::size_t c = 0; c < kSources; ++c) {
    const auto row = static_cast<Eigen::Index>(c);
    score.slope(row) += 0.5 * (shares[c].square - shares[c].of_S.trace());
    for (std::size_t d = 0; d < kSources; ++d)
      score.information(row, static_cast<Eigen::Index>(d)) +=
          0.5 * shares[c].of_S.cwiseProduct(shares[d].of_S.transpose()).sum();
  }
  score.nis += u.dot(group.nu);
  score.dof += static_cast<int>(size);
}

double ConsistencyMonitor::nisMean() const {
  double nis = 0.0;
  int dof = 0;
  for (const auto& score : window_) {
    nis += score.nis;
    dof += score.dof;
  }
  return dof > 0 ? nis / dof : 0.0;
}

std::array<double, 2> ConsistencyMonitor::nisBounds() const {
  double dof = 0.0;
  for (const auto& score : window_) dof += score.dof;
  constexpr double kNormal95 = 1.96;
  if (dof == 0.0) return {0.0, 0.0};
  return {chiSquareOverDof(dof, -kNormal95), chiSquareOverDof(dof, kNormal95)};
}

void ConsistencyMonitor::judge() {
  Score sum;
  for (const auto& score : window_) {
    sum.slope += score.slope;
    sum.information += score.information;
  }
  // The prior keeps a factor that the innovations hardly determine near 1.
  constexpr double kPrior = 1.0;
  const Eigen::Matrix3d covariance = (sum.information + kPrior * Eigen::Matrix3d::Identity())
                                         .llt()
                                         .solve(Eigen::Matrix3d::Identity());
  const Eigen::Vector3d excess = covariance * sum.slope;  // of the variance, as a share of it
  for (Eigen::Index c = 0; c < static_cast<Eigen::Index>(kSources); ++c) {
    constexpr double kSmallestShare = 1e-4;
    const double variance = covariance(c, c);
    auto& factor = factors_[static_cast<std::size_t>(c)];
    factor.sigma = std::sqrt(std::max(kSmallestShare, 1.0 + excess(c)));
    factor.uncertainty = 0.5 * std::sqrt(variance) * factor.sigma;
    factor.evidence = normalQuantile(1.0 + excess(c), 2.0 / variance);
  }
  blame();
}

void ConsistencyMonitor::blame() {
  const double wrong = config_.warning_factor, half_way = std::sqrt(wrong);
  const Source sensor = sensorInQuestion();
  const bool is_noise = !isSystematic(sensor), is_sensor = isOff(sensor, wrong, kSignificant);
  const auto count = [](int& agreeing, bool agrees) { agreeing = agrees ? agreeing + 1 : 0; };
  count(agreeing_.bias, std::abs(bias_.mean().evidence) > kSignificant &&
                            std::abs(bias_.mean().size) > kSmallestBias);
  count(agreeing_.sensor, is_sensor && is_noise);
  count(agreeing_.motion, isOff(kMotion, wrong, kSignificantMotion) &&
                              !isOff(sensor, half_way, kSuspicious) &&
                              !gating_.isLatestMostlyGated());
  is_biased_ = agreeing_.bias >= kAgreeing;
  blamed_.reset();
  if (updates() < std::min(kFewest, config_.window) || !is_noise) return;
  if (agreeing_.sensor >= kAgreeing)
    blamed_ = sensor;
  else if (!is_sensor && agreeing_.motion >= kAgreeing)
    blamed_ = kMotion;
}

/// The sensor with more evidence against it. While one sigma looks too small, the other one may
/// look too large only because both explain the same innovations; so the small one goes first.
ConsistencyMonitor::Source ConsistencyMonitor::sensorInQuestion() const {
  const double range = factors_[kRange].evidence, bearing = factors_[kBearing].evidence;
  if (std::max(range, bearing) > kSuspicious) return range > bearing ? kRange : kBearing;
  return std::abs(range) > std::abs(bearing) ? kRange : kBearing;
}

bool ConsistencyMonitor::isOff(Source source, double by, double significant) const {
  const auto& factor = factors_[source];
  return std::abs(factor.evidence) > significant && std::max(factor.sigma, 1.0 / factor.sigma) > by;
}

/// Whether the innovations may contain more than noise: a bias or serial correlation. The
/// odometry's noise correlates them, too, so that only the component of the sensor in question is
/// tested.
bool ConsistencyMonitor::isSystematic(Source sensor) const {
  if (std::abs(bias_.mean().evidence) > kSuspicious) return true;
  const auto component = sensor == kRange ? SerialCorrelation::kRange : SerialCorrelation::kBearing;
  return isOff(sensor, std::sqrt(config_.warning_factor), kSuspicious) &&
         serial_.coefficient(component) > kAlike;
}

std::optional<ConsistencyMonitor::Source> ConsistencyMonitor::overconfident() const {
  const bool is_sigma = !is_lost_ && !is_biased_ && blamed_ && factors_[*blamed_].sigma > 1.0;
  return is_sigma ? blamed_ : std::nullopt;
}

ConsistencyMonitor::Fault ConsistencyMonitor::fault() const {
  static constexpr Fault kOfSigmas[] = {Fault::kRangeSigma, Fault::kBearingSigma,
                                        Fault::kMotionSigma};
  if (is_lost_) return Fault::kLost;
  if (is_biased_) return Fault::kBias;
  const auto source = overconfident();
  return source ? kOfSigmas[*source] : Fault::kNone;
}

std::string ConsistencyMonitor::finding() const {
  if (is_lost_)
    return fmt::format("{} of the last {} observations failed the gate: the pose may be lost",
                       gating_.gated(), gating_.observations());
  if (is_biased_) return bias_.finding();
  if (!blamed_) return "";
  const double sigma = factors_[*blamed_].sigma;
  return fmt::format("{} sigma looks {:.1f} times too {} (NIS {:.2f} over {} updates, 1 expected)",
                     name(*blamed_), std::max(sigma, 1.0 / sigma), sigma > 1.0 ? "small" : "large",
                     nisMean(), updates());
}

}  // namespace slam
