// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "slam_core/models/odometry_sample.hpp"
#include "slam_core/product/meta_coordinator.hpp"
#include "slam_core/tuning/innovation_score.hpp"

namespace slam::tuning {

/// What a product was given in one run, in order.
using RecordedInput = std::variant<OdometrySample, Motion, LandmarkObservationArray>;
struct RecordedLog {
  std::string name;  ///< for messages
  std::vector<RecordedInput> inputs;
};

/// A parameter of the robot file and what the data say of it.
struct TunedParameter {
  std::string section, key;
  double before = 0.0;
  double value = 0.0;
  double sigma = 0.0;      ///< standard deviation of value
  std::string why_unseen;  ///< not empty: it keeps its value, and why
  bool is_bound = false;   ///< the data only say that `before` is too far beyond value
  int digits = 3;          ///< of the value, in the robot file
  std::string name() const { return section + "." + key; }
};

struct TuningResult {
  std::vector<TunedParameter> parameters;
  double log_likelihood_before = 0.0, log_likelihood = 0.0;
  int innovations = 0;          ///< that the likelihood is of
  bool of_resightings = false;  ///< those of landmarks that came into view again; else all
  int evaluations = 0;          ///< of the likelihood
  bool has_converged = false;
};

/// Finds the noise of a robot's odometry and landmark sensor from what it recorded, by maximum
/// likelihood over the innovations of a filter that runs with each candidate (Mehra 1970; the
/// prediction likelihood of Abbeel et al. 2005). No truth is needed. Where the logs show landmarks
/// again after a while out of view, often enough, the likelihood is that of these sightings.
class NoiseTuner {
 public:
  /// @param settings for the product, made anew for each candidate's overrides
  using MakeSettings = std::function<Settings(const std::vector<std::string>& overrides)>;
  using Progress = std::function<void(int evaluations, double log_likelihood)>;

  NoiseTuner(MakeSettings make_settings, std::vector<RecordedLog> logs);

  /// alpha1..4 of the wheels, the sigmas of range and bearing, and the relative one where the robot
  /// file has it.
  std::vector<std::string> defaultParameters() const;

  /// The parameters as the robot file has them, before a search over them.
  /// @param names "section.key"
  /// @throw ConfigError where a name is none, or stands there twice
  std::vector<TunedParameter> start(const std::vector<std::string>& names) const;

  /// @param parameters "section.key"
  /// @throw std::runtime_error naming the log: there are no observations, no odometry, or no
  /// landmark that is seen twice; ConfigError as start()
  TuningResult run(const std::vector<std::string>& parameters, const Progress& progress = {}) const;

 private:
  struct Evidence {
    std::vector<double> log_likelihoods;  ///< of each step
    int innovations = 0;
    double sum() const;
  };
  Evidence evaluate(const std::vector<TunedParameter>& parameters) const;
  void evaluate(std::size_t log, const std::vector<std::string>& overrides,
                Evidence& evidence) const;
  Evidence look(TuningResult& result, const Progress& progress) const;
  static std::vector<TunedParameter*> openOnes(TuningResult& result);
  bool refine(TuningResult& result, const Progress& progress) const;
  void settle(TunedParameter& parameter, double log_likelihood, TuningResult& result,
              const Progress& progress) const;
  void requireEvidence() const;
  std::string whyUnseen(const TunedParameter& parameter) const;

  MakeSettings make_settings_;
  std::vector<RecordedLog> logs_;
  std::vector<Resightings> resightings_;  ///< of each log; none where all innovations count
};

}  // namespace slam::tuning
