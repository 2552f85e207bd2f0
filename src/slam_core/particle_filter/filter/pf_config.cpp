// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/particle_filter/filter/pf_config.hpp"

#include <cmath>

#include "slam_core/common/config_error.hpp"
#include "slam_core/particle_filter/landmarks/proposal.hpp"
#include "slam_core/particle_filter/landmarks/weighting.hpp"
#include "slam_core/particle_filter/particles/resampling.hpp"

namespace slam::particle_filter {
namespace {

constexpr double kMostParticles = 100000, kMostThreads = 64;

}  // namespace

void PfConfig::describe(Fields& fields) {
  fields.add("mode", &mode, backendModeNames(),
             "build the map, or keep a loaded one fixed and only localise in it");
  describePolicies(fields);
  describeSize(fields);
  describeOutput(fields);
  describeStart(fields);
  fields.add("threads", &threads, "that move particles; the result does not depend on it")
      .unit("1")
      .in(Range::closed(1, kMostThreads));
}

void PfConfig::describePolicies(Fields& fields) {
  places.describe(fields);
  fields
      .add("proposal", &proposal,
           "where a particle's new pose is drawn from: motion alone (fastslam1), or motion and the "
           "latest observations (fastslam2)")
      .oneOf(proposalNames());
  fields
      .add("weighting", &weighting,
           "a particle's weight: how likely it foresaw the observations, or target over proposal "
           "at the pose drawn")
      .oneOf(weightingNames());
  fields.add("resampling", &resampling, "how particles are drawn by weight")
      .oneOf(resamplingNames());
  fields
      .add("resampling_threshold", &resampling_threshold,
           "particles are resampled when the effective sample size falls below this share of them")
      .unit("1")
      .in(Range::closed(0, 1));
  fields
      .add("gate_probability", &gate_probability,
           "a particle leaves an observation out when a right one would lie nearer with this "
           "probability")
      .unit("1")
      .in(Range::open(0, 1));
}

void PfConfig::describeSize(Fields& fields) {
  const auto count = Range::closed(1, kMostParticles);
  fields.add("particles", &particles, "number of particles, at the start or all the time")
      .unit("1")
      .in(count);
  fields.add(
      "size", &size, {{"fixed", SetSize::kFixed}, {"kld", SetSize::kKld}},
      "whether the number stays, or follows the spread of the poses at each resampling (KLD)");
  fields.add("min_particles", &min_particles, "fewest, where the number is adapted")
      .unit("1")
      .in(count);
  fields.add("max_particles", &max_particles, "most, where the number is adapted")
      .unit("1")
      .in(count);
  fields.add("kld_error", &kld_error, "largest Kullback-Leibler distance to the true density")
      .unit("nat")
      .in(Range::above(0));
  fields
      .add("kld_quantile", &kld_quantile,
           "normal quantile of the probability with which that distance is kept")
      .unit("1")
      .in(Range::atLeast(0));
  fields.add("kld_bin_position", &kld_bin_position, "width of the histogram's bins")
      .unit("m")
      .in(Range::above(0));
  fields.add("kld_bin_heading", &kld_bin_heading, "width of the histogram's bins")
      .unit("rad")
      .in(Range::above(0));
}

void PfConfig::describeOutput(Fields& fields) {
  fields.add(
      "pose", &pose,
      {{"auto", ToldPose::kAuto}, {"mean", ToldPose::kMean}, {"best", ToldPose::kBest}},
      "the pose told: the weighted mean, that of the most likely particle, or (auto) the mean "
      "beside landmarks and the most likely one beside a grid, whose map is shown");
  fields.add("map", &map, {{"best", ToldMap::kBest}, {"mixture", ToldMap::kMixture}},
             "the map told: that of the most likely particle, or the weighted mixture");
  fields
      .add("lost_nis", &lost_nis,
           "the robot is told lost when the latest observations' normalised innovation squared "
           "per degree of freedom, 1 when all is well, is on average larger")
      .unit("1")
      .in(Range::above(1));
}

void PfConfig::describeStart(Fields& fields) {
  fields
      .add("initial_sigma_position", &initial_sigma_position,
           "standard deviation of the first position; the first pose defines the map frame")
      .unit("m")
      .in(Range::above(0));
  fields
      .add("initial_sigma_heading", &initial_sigma_heading,
           "standard deviation of the first heading")
      .unit("rad")
      .in(Range::open(0, M_PI));
  fields
      .add("load_inflation", &load_inflation,
           "factor on the standard deviations of a loaded map that has no joint covariance")
      .unit("1")
      .in(Range::atLeast(1));
}

void validatePf(const PfConfig& config) {
  FaultCollector faults;
  faults.attempt([&] { validate(config); });
  if (config.min_particles > config.max_particles)
    faults.add("pf.min_particles: " + std::to_string(config.min_particles) +
               " is more than pf.max_particles, " + std::to_string(config.max_particles));
  if (config.size == SetSize::kKld &&
      (config.particles < config.min_particles || config.particles > config.max_particles))
    faults.add("pf.particles: with pf.size: kld the number starts between pf.min_particles, " +
               std::to_string(config.min_particles) + ", and pf.max_particles, " +
               std::to_string(config.max_particles) + ", not at " +
               std::to_string(config.particles));
  // an observation outside the gate counts as one on its edge, two degrees of freedom each
  const double most_nis = -std::log(1.0 - config.gate_probability);
  if (config.gate_probability > 0.0 && !(config.lost_nis < most_nis))
    faults.add("pf.lost_nis: " + std::to_string(config.lost_nis) +
               " is never reached, as pf.gate_probability lets the observations count " +
               std::to_string(most_nis) + " at most; lower the one or raise the other");
  faults.raise();
}

LandmarkUpdate::Config landmarksOf(const PfConfig& config) {
  return {config.association,
          config.proposal,
          config.weighting,
          config.gate_probability,
          config.lost_nis,
          config.mapIsFixed(),
          static_cast<unsigned>(config.threads),
          config.places};
}

Resampler::Config resamplingOf(const PfConfig& config) {
  Resampler::Config resampling{config.resampling, config.resampling_threshold, std::nullopt};
  if (config.size != SetSize::kKld) return resampling;
  auto& limits = resampling.sizes.emplace();
  limits.min = static_cast<std::size_t>(config.min_particles);
  limits.max = static_cast<std::size_t>(config.max_particles);
  limits.error = config.kld_error;
  limits.quantile = config.kld_quantile;
  limits.bin_position = config.kld_bin_position;
  limits.bin_heading = config.kld_bin_heading;
  return resampling;
}

}  // namespace slam::particle_filter
