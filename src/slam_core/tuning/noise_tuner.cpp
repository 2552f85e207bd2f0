// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/tuning/noise_tuner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>

#include "slam_core/common/config_error.hpp"
#include "slam_core/tuning/maximum_likelihood.hpp"
#include "slam_core/wheel_odometry/wheel_odometry.hpp"

namespace slam::tuning {
namespace {

/// A parameter whose logarithm is less certain than this cannot be seen: all others known, the data
/// hardly depend on it; with the others, they do not tell it from them, or are too few.
constexpr double kUnseen = 1.0;
/// A loss of log-likelihood that says something: one less may be chance.
constexpr double kTelling = 1.0;
/// A bound is found to within this factor.
constexpr double kBoundAccuracy = 1.5;
/// Of a value: as good as zero.
constexpr double kNothing = 1e-6;
/// Where the robot file has 0, the search begins here.
constexpr double kSmallStart = 1e-4;

const std::vector<std::string> kAlphas = {"alpha1", "alpha2", "alpha3", "alpha4"};

/// The value of a numeric field of a robot file's section.
template <class Config>
const double* numberOf(Config& config, Fields& fields, const std::string& section,
                       const std::string& key) {
  if (section != Config::kSection) return nullptr;
  config.describe(fields);
  const auto* field = fields.find(key);
  if (field == nullptr || field->scope != Scope::kRobot) return nullptr;
  const auto* const* target = std::get_if<double*>(&field->target);
  return target == nullptr ? nullptr : *target;
}

TunedParameter parameterOf(const std::string& name, Settings settings) {
  const auto dot = name.find('.');
  TunedParameter parameter;
  parameter.section = name.substr(0, dot);
  parameter.key = dot == std::string::npos ? "" : name.substr(dot + 1);
  auto wheels = settings.read<wheel_odometry::WheelOdometryConfig>();
  auto sensor = settings.read<LandmarkSensorConfig>();
  Fields of_wheels, of_sensor;
  const double* value = numberOf(wheels, of_wheels, parameter.section, parameter.key);
  if (value == nullptr) value = numberOf(sensor, of_sensor, parameter.section, parameter.key);
  if (value == nullptr)
    throw ConfigError("'" + name +
                      "' is no number of the sections wheel_odometry and landmark_sensor of a "
                      "robot file");
  parameter.before = *value;
  parameter.value = *value > 0.0 ? *value : kSmallStart;
  return parameter;
}

/// What the recorded data can tell of at all.
struct Contents {
  double way = 0.0, turned = 0.0;  ///< [m], [rad]
  bool has_odometry = false, has_motion = false;
  bool lacks_covariance = false;  ///< some observations are left to the robot file
  int observations = 0;
  bool sees_again = false;
};

Contents contentsOf(const RecordedLog& log) {
  Contents contents;
  std::set<LandmarkId> seen;
  std::optional<OdometrySample> last;
  for (const auto& input : log.inputs) {
    if (const auto* sample = std::get_if<OdometrySample>(&input)) {
      contents.has_odometry = true;
      Pose2 step;
      if (last && last->pose && sample->pose)
        step = last->pose->between(*sample->pose);
      else if (last)
        step = Pose2::exp(seconds(sample->stamp - last->stamp) * last->twist);
      contents.way += step.position().norm();
      contents.turned += std::abs(step.theta());
      last = *sample;
    } else if (std::holds_alternative<Motion>(input)) {
      contents.has_motion = true;
    } else {
      for (const auto& z : std::get<LandmarkObservationArray>(input).observations) {
        if (z.id == kUnknownId) continue;
        ++contents.observations;
        contents.lacks_covariance = contents.lacks_covariance || !z.hasCovariance();
        contents.sees_again = !seen.insert(z.id).second || contents.sees_again;
      }
    }
  }
  return contents;
}

}  // namespace

/// Rather few resightings than many readings whose errors are alike; but too few tell nothing.
NoiseTuner::NoiseTuner(MakeSettings make_settings, std::vector<RecordedLog> logs)
    : make_settings_(std::move(make_settings)), logs_(std::move(logs)) {
  constexpr std::size_t kEnough = 100;
  std::size_t count = 0;
  for (const auto& log : logs_) {
    auto& resightings = resightings_.emplace_back();
    for (const auto& input : log.inputs)
      if (const auto* array = std::get_if<LandmarkObservationArray>(&input))
        resightings.add(*array);
    count += resightings.size();
  }
  if (count < kEnough) resightings_.clear();
}

std::vector<std::string> NoiseTuner::defaultParameters() const {
  std::vector<std::string> names;
  for (const auto& alpha : kAlphas) names.push_back("wheel_odometry." + alpha);
  names.push_back("landmark_sensor.sigma_range");
  const auto relative = parameterOf("landmark_sensor.sigma_range_relative", make_settings_({}));
  if (relative.before > 0.0) names.push_back(relative.name());
  names.push_back("landmark_sensor.sigma_bearing");
  return names;
}

void NoiseTuner::requireEvidence() const {
  if (logs_.empty()) throw std::runtime_error("there is nothing to tune on");
  for (const auto& log : logs_) {
    const auto contents = contentsOf(log);
    if (contents.observations == 0)
      throw std::runtime_error(log.name +
                               " holds no observations of landmarks with an id; nothing can be "
                               "learnt from it");
    if (!contents.has_odometry && !contents.has_motion)
      throw std::runtime_error(log.name + " holds no odometry; nothing can be learnt from it");
    if (!contents.sees_again)
      throw std::runtime_error(log.name +
                               " shows no landmark twice; nothing can be learnt from it");
  }
}

/// What is known before any likelihood is computed.
std::string NoiseTuner::whyUnseen(const TunedParameter& parameter) const {
  Contents all;
  for (const auto& log : logs_) {
    const auto contents = contentsOf(log);
    all.way += contents.way;
    all.turned += contents.turned;
    all.has_odometry = all.has_odometry || contents.has_odometry;
    all.lacks_covariance = all.lacks_covariance || contents.lacks_covariance;
  }
  constexpr double kLeastWay = 0.5, kLeastTurn = 0.3;  // [m], [rad]
  if (parameter.section == "landmark_sensor")
    return all.lacks_covariance ? "" : "every observation brings its own covariance";
  if (!all.has_odometry) return "the motion comes with its own covariance";
  const bool by_way = parameter.key == "alpha1" || parameter.key == "alpha3";
  const bool by_turn = parameter.key == "alpha2" || parameter.key == "alpha4";
  if (by_way && all.way < kLeastWay)
    return fmt::format("the robot drives no more than {:.2g} m", all.way);
  if (by_turn && all.turned < kLeastTurn)
    return fmt::format("the robot turns no more than {:.2g} rad", all.turned);
  return "";
}

double NoiseTuner::Evidence::sum() const {
  return std::accumulate(log_likelihoods.begin(), log_likelihoods.end(), 0.0);
}

void NoiseTuner::evaluate(std::size_t log, const std::vector<std::string>& overrides,
                          Evidence& evidence) const {
  auto fixed = overrides;
  fixed.emplace_back("consistency.adapt=false");  // the noise is what is sought
  auto settings = make_settings_(fixed);
  MetaCoordinator coordinator;
  coordinator.configure(settings);
  InnovationScore score(resightings_.empty() ? nullptr : &resightings_[log]);
  for (const auto& input : logs_[log].inputs) {
    std::visit([&](const auto& value) { coordinator.set(value); }, input);
    do {
      coordinator.execute();
      const auto& report = coordinator.estimator().report();
      if (!report) break;
      evidence.log_likelihoods.push_back(score.of(*report));
    } while (true);
  }
  evidence.innovations += score.innovations();
}

NoiseTuner::Evidence NoiseTuner::evaluate(const std::vector<TunedParameter>& parameters) const {
  std::vector<std::string> overrides;
  for (const auto& parameter : parameters)
    if (parameter.why_unseen.empty())
      overrides.push_back(fmt::format("{}={:.17g}", parameter.name(), parameter.value));
  Evidence evidence;
  for (std::size_t log = 0; log < logs_.size(); ++log) evaluate(log, overrides, evidence);
  return evidence;
}

std::vector<TunedParameter*> NoiseTuner::openOnes(TuningResult& result) {
  std::vector<TunedParameter*> open;
  for (auto& parameter : result.parameters)
    if (parameter.why_unseen.empty() && !parameter.is_bound) open.push_back(&parameter);
  return open;
}

NoiseTuner::Evidence NoiseTuner::look(TuningResult& result, const Progress& progress) const {
  auto evidence = evaluate(result.parameters);
  ++result.evaluations;
  if (progress) progress(result.evaluations, evidence.sum());
  return evidence;
}

/// One maximum over the parameters that are open; settles the one that turns out to be
/// hidden.
bool NoiseTuner::refine(TuningResult& result, const Progress& progress) const {
  const auto seen = openOnes(result);
  if (seen.empty()) return true;
  Eigen::VectorXd start(static_cast<Eigen::Index>(seen.size()));
  for (Eigen::Index i = 0; i < start.size(); ++i)
    start(i) = std::log(seen[static_cast<std::size_t>(i)]->value);
  const auto set = [&](const Eigen::VectorXd& x) {
    for (Eigen::Index i = 0; i < x.size(); ++i)
      seen[static_cast<std::size_t>(i)]->value = std::exp(x(i));
  };
  const auto maximum = maximize(
      [&](const Eigen::VectorXd& x) {
        set(x);
        const auto evidence = look(result, progress);
        return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(
            evidence.log_likelihoods.data(),
            static_cast<Eigen::Index>(evidence.log_likelihoods.size())));
      },
      start);
  result.has_converged = maximum.has_converged;
  set(maximum.log_parameters);
  for (std::size_t i = 0; i < seen.size(); ++i)
    seen[i]->sigma = seen[i]->value * maximum.sigmas(static_cast<Eigen::Index>(i));
  Eigen::Index worst = 0;
  if (conditionalSigmas(maximum.information).maxCoeff(&worst) >= kUnseen) {
    settle(*seen[static_cast<std::size_t>(worst)], maximum.log_likelihood, result, progress);
    return false;
  }
  if (maximum.sigmas.maxCoeff(&worst) < kUnseen) return true;
  auto& vague = *seen[static_cast<std::size_t>(worst)];
  vague.why_unseen =
      fmt::format("the data tell no more than {:.2g} +- {:.2g}", vague.value, vague.sigma);
  return false;
}

/// Where the likelihood hardly depends on a parameter, either the file's value is as good as any or
/// the data only say on which side of it the truth is: then as near to it as they allow.
void NoiseTuner::settle(TunedParameter& parameter, double log_likelihood, TuningResult& result,
                        const Progress& progress) const {
  const auto loses = [&](double value) {
    parameter.value = value;
    return !(look(result, progress).sum() >= log_likelihood - kTelling);  // none is a loss, too
  };
  double good = parameter.value;
  if (!loses(parameter.before)) {
    parameter.why_unseen = "the likelihood hardly depends on it";
    return;
  }
  double bad = std::max(parameter.before, kNothing * good);
  while (std::max(good / bad, bad / good) > kBoundAccuracy) {
    const double middle = std::sqrt(good * bad);
    (loses(middle) ? bad : good) = middle;
  }
  parameter.value = good;
  parameter.is_bound = true;
}

std::vector<TunedParameter> NoiseTuner::start(const std::vector<std::string>& names) const {
  std::vector<TunedParameter> parameters;
  std::set<std::string> known;
  for (const auto& name : names) {
    if (!known.insert(name).second) throw ConfigError("'" + name + "' is to be tuned twice");
    parameters.push_back(parameterOf(name, make_settings_({})));
  }
  return parameters;
}

TuningResult NoiseTuner::run(const std::vector<std::string>& names,
                             const Progress& progress) const {
  requireEvidence();
  TuningResult result;
  result.parameters = start(names);
  for (auto& parameter : result.parameters) parameter.why_unseen = whyUnseen(parameter);
  result.log_likelihood_before = evaluate({}).sum();
  while (!refine(result, progress)) continue;
  for (auto& parameter : result.parameters) {
    if (parameter.why_unseen.empty()) continue;
    parameter.value = parameter.before;
    parameter.sigma = 0.0;
  }
  const auto evidence = evaluate(result.parameters);
  result.log_likelihood = evidence.sum();
  result.innovations = evidence.innovations;
  result.of_resightings = !resightings_.empty();
  return result;
}

}  // namespace slam::tuning
