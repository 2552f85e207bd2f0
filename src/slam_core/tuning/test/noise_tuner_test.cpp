// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/tuning/noise_tuner.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <map>

#include "slam_core/common/random.hpp"
#include "slam_core/common/test/faults.hpp"
#include "slam_core/models/motion_model.hpp"

namespace slam::tuning {
namespace {

constexpr double kAlpha1 = 0.004, kAlpha3 = 0.003, kAlpha4 = 0.02;
constexpr double kSigmaRange = 0.08, kSigmaBearing = 0.03;

/// What a robot's sensor sees, and how it errs.
struct Sensor {
  std::int64_t interval = 100000000;  ///< [ns]
  double half_view = M_PI;            ///< [rad] to both sides
  bool errs_alike = false;            ///< all the time that a landmark stays in view
};

/// A robot in a hall of landmarks: what its wheels and its sensor said.
RecordedLog drive(std::uint64_t seed, int steps, double way, double turn, Sensor sensor = {}) {
  RandomStream random(seed, 0);
  const LinearMotionModel model({kAlpha1, 0.0005, kAlpha3, kAlpha4, false});
  std::vector<Eigen::Vector2d> landmarks;
  for (int i = 0; i < 25; ++i)
    landmarks.emplace_back(12 * random.uniform() - 6, 12 * random.uniform() - 2);
  RecordedLog log{"the simulated log", {}};
  std::map<std::size_t, Eigen::Vector2d> errors;  // of what is in view
  Pose2 truth, odometry;
  for (int i = 0; i <= steps; ++i) {
    OdometrySample sample;
    sample.stamp = stampFromNanoseconds(1000000000LL + i * sensor.interval);
    sample.pose = odometry;
    log.inputs.push_back(sample);
    LandmarkObservationArray array;
    array.stamp = sample.stamp;
    array.sequence = std::uint64_t(i);
    for (std::size_t k = 0; k < landmarks.size(); ++k) {
      const auto seen = truth.inverse().transform(landmarks[k]);
      const double bearing = std::atan2(seen.y(), seen.x());
      if (seen.norm() > 4 || seen.norm() < 0.5 || std::abs(bearing) > sensor.half_view) {
        errors.erase(k);
        continue;
      }
      if (!sensor.errs_alike || errors.count(k) == 0) {
        const double of_range = kSigmaRange * random.gaussian();
        errors[k] = {of_range, kSigmaBearing * random.gaussian()};
      }
      LandmarkObservation z;
      z.id = LandmarkId(k);
      z.range = seen.norm() + errors[k].x();
      z.bearing = bearing + errors[k].y();
      z.covariance(0, 0) = -1;
      array.observations.push_back(z);
    }
    log.inputs.push_back(array);
    const Pose2 step = i % 40 < 20 ? Pose2(way, 0, 0) : Pose2(0, 0, turn);
    odometry = odometry * step;
    if (way == 0.0 && turn == 0.0) continue;
    const Eigen::Vector3d white(random.gaussian(), random.gaussian(), random.gaussian());
    const Eigen::Matrix3d L =
        (model.covariance(step) + 1e-7 * Eigen::Matrix3d::Identity()).llt().matrixL();
    truth = truth * Pose2::fromVector(step.vector() + L * white);
  }
  return log;
}

/// A robot file that is wrong by factors of two to three.
Settings wrongSettings(const std::vector<std::string>& overrides) {
  std::vector<std::string> all = {"wheel_odometry.alpha1=0.0015", "wheel_odometry.alpha3=0.008",
                                  "wheel_odometry.alpha4=0.006", "landmark_sensor.sigma_range=0.2",
                                  "landmark_sensor.sigma_bearing=0.012"};
  all.insert(all.end(), overrides.begin(), overrides.end());
  return Settings({}, {}, all);
}

std::vector<std::string> rightMotion(std::vector<std::string> overrides) {
  for (const auto& [key, value] :
       {std::pair("alpha1", kAlpha1), {"alpha3", kAlpha3}, {"alpha4", kAlpha4}})
    overrides.push_back(std::string("wheel_odometry.") + key + "=" + std::to_string(value));
  return overrides;
}

const TunedParameter& find(const TuningResult& result, const std::string& key) {
  for (const auto& parameter : result.parameters)
    if (parameter.key == key) return parameter;
  throw std::out_of_range(key);
}

TEST(NoiseTunerTest, FindsTheNoiseOfASimulatedLogWithinItsUncertainty) {
  const NoiseTuner tuner(wrongSettings, {drive(1, 400, 0.1, M_PI / 40)});
  const auto result = tuner.run(tuner.defaultParameters());
  EXPECT_TRUE(result.has_converged);
  EXPECT_GT(result.log_likelihood, result.log_likelihood_before + 100);
  const std::pair<const char*, double> kTruth[] = {{"alpha1", kAlpha1},
                                                   {"alpha3", kAlpha3},
                                                   {"alpha4", kAlpha4},
                                                   {"sigma_range", kSigmaRange},
                                                   {"sigma_bearing", kSigmaBearing}};
  for (const auto& [key, truth] : kTruth) {
    const auto& found = find(result, key);
    EXPECT_TRUE(found.why_unseen.empty()) << key << ": " << found.why_unseen;
    EXPECT_NEAR(found.value, truth, 3 * found.sigma) << key;
  }
  const double best = 1.0 / std::sqrt(2.0 * result.innovations);  // of a known mean
  EXPECT_GT(find(result, "sigma_range").sigma, 0.95 * best * kSigmaRange);
  EXPECT_GT(find(result, "sigma_bearing").sigma, 0.95 * best * kSigmaBearing);
  EXPECT_NEAR(find(result, "sigma_range").value, kSigmaRange, 0.05 * kSigmaRange);
  EXPECT_NEAR(find(result, "sigma_bearing").value, kSigmaBearing, 0.05 * kSigmaBearing);
}

TEST(NoiseTunerTest, SaysWhatCannotBeSeenOfARobotThatStands) {
  const NoiseTuner tuner(wrongSettings, {drive(2, 150, 0.0, 0.0)});
  const auto result = tuner.run(tuner.defaultParameters());
  for (const char* key : {"alpha1", "alpha2", "alpha3", "alpha4"}) {
    EXPECT_FALSE(find(result, key).why_unseen.empty()) << key;
    EXPECT_EQ(find(result, key).value, find(result, key).before);
  }
  EXPECT_NE(find(result, "alpha1").why_unseen.find("drives no more than"), std::string::npos);
  EXPECT_NE(find(result, "alpha4").why_unseen.find("turns no more than"), std::string::npos);
  EXPECT_NEAR(find(result, "sigma_range").value, kSigmaRange, 0.1 * kSigmaRange);
}

TEST(NoiseTunerTest, OfAValueThatIsFarTooLargeSaysHowLargeItIsAtMost) {
  const NoiseTuner tuner(
      [](const auto& overrides) {
        auto all = rightMotion({"wheel_odometry.floor_position=0.5"});
        all.insert(all.end(), overrides.begin(), overrides.end());
        for (const auto* right :
             {"landmark_sensor.sigma_range=0.08", "landmark_sensor.sigma_bearing=0.03",
              "wheel_odometry.alpha2=0.005", "wheel_odometry.alpha1=0.01"})
          all.emplace_back(right);
        return wrongSettings(all);
      },
      {drive(7, 100, 0.1, M_PI / 40)});
  const auto result = tuner.run({"wheel_odometry.floor_position"});
  const auto& found = find(result, "floor_position");
  EXPECT_TRUE(found.is_bound) << found.value << " +- " << found.sigma;
  EXPECT_TRUE(found.why_unseen.empty()) << found.why_unseen;
  EXPECT_LT(found.value, 0.1);  // [m/sqrt(s)]
  EXPECT_GT(result.log_likelihood, result.log_likelihood_before + 20);
}

TEST(NoiseTunerTest, KeepsWhatAShortLogTellsNoBetterThanToItsOwnSize) {
  int kept = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const NoiseTuner tuner(
        [](const auto& more) {
          auto all = rightMotion({"landmark_sensor.sigma_range_relative=0.05"});
          all.insert(all.end(), more.begin(), more.end());
          return wrongSettings(all);
        },
        {drive(seed, 2, 0.0, 0.0)});
    for (const auto& parameter : tuner.run(tuner.defaultParameters()).parameters) {
      const auto& why = parameter.why_unseen;
      kept += why.find("the data tell no more than") == 0;
      if (why.empty())
        EXPECT_TRUE(parameter.is_bound || parameter.sigma < parameter.value) << parameter.name();
      else
        EXPECT_EQ(parameter.value, parameter.before) << parameter.name();
    }
  }
  EXPECT_GT(kept, 0);
}

TEST(NoiseTunerTest, LeavesSensorSigmasAloneWhereObservationsBringTheirs) {
  auto log = drive(3, 100, 0.1, 0.05);
  for (auto& input : log.inputs)
    if (auto* array = std::get_if<LandmarkObservationArray>(&input))
      for (auto& z : array->observations)
        z.covariance << kSigmaRange * kSigmaRange, 0, 0, kSigmaBearing * kSigmaBearing;
  const NoiseTuner tuner(wrongSettings, {log});
  const auto result = tuner.run({"landmark_sensor.sigma_range"});
  EXPECT_NE(find(result, "sigma_range").why_unseen.find("own covariance"), std::string::npos);
}

TEST(NoiseTunerTest, RefusesLogsThatTellNothing) {
  auto blind = drive(4, 20, 0.1, 0.0);
  for (auto& input : blind.inputs)
    if (auto* array = std::get_if<LandmarkObservationArray>(&input)) array->observations.clear();
  const auto faultOf = [](const RecordedLog& log, const std::string& parameter) -> std::string {
    try {
      NoiseTuner(wrongSettings, {log}).run({parameter});
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(faultOf(blind, "wheel_odometry.alpha1").find("no observations of landmarks"),
            std::string::npos);
  auto once = drive(4, 20, 0.1, 0.0);
  once.inputs.resize(2);
  EXPECT_NE(faultOf(once, "wheel_odometry.alpha1").find("no landmark twice"), std::string::npos);
  EXPECT_NE(faultOf(drive(4, 20, 0.1, 0.0), "wheel_odometry.drive").find("is no number"),
            std::string::npos);
  const auto twice = test::sentenceOf([] {
    NoiseTuner(wrongSettings, {}).start({"wheel_odometry.alpha1", "wheel_odometry.alpha1"});
  });
  EXPECT_EQ(twice, "'wheel_odometry.alpha1' is to be tuned twice");
}

TEST(NoiseTunerTest, BeginsWhereTheRobotFileStandsHoweverSmallThatIs) {
  const NoiseTuner tuner(wrongSettings, {});
  EXPECT_EQ(tuner.start({"wheel_odometry.alpha1"})[0].value, 0.0015);
  const NoiseTuner tiny([](auto) { return Settings({}, {}, {"wheel_odometry.alpha1=2e-6"}); }, {});
  EXPECT_EQ(tiny.start({"wheel_odometry.alpha1"})[0].value, 2e-6);
  const NoiseTuner zero([](auto) { return Settings({}, {}, {"wheel_odometry.alpha1=0"}); }, {});
  EXPECT_GT(zero.start({"wheel_odometry.alpha1"})[0].value, 0.0);
}

/// Both sigmas of the sensor, and how far off they are in the uncertainties told.
struct SigmasFound {
  double range = 0.0, bearing = 0.0;  ///< over the true ones
  double range_off = 0.0, bearing_off = 0.0;
  bool of_resightings = false;
};

SigmasFound tunedSigmas(const RecordedLog& log) {
  const NoiseTuner tuner([](const auto& more) { return wrongSettings(rightMotion(more)); }, {log});
  const auto result = tuner.run({"landmark_sensor.sigma_range", "landmark_sensor.sigma_bearing"});
  const auto &range = find(result, "sigma_range"), &bearing = find(result, "sigma_bearing");
  return {range.value / kSigmaRange, bearing.value / kSigmaBearing,
          (range.value - kSigmaRange) / range.sigma,
          (bearing.value - kSigmaBearing) / bearing.sigma, result.of_resightings};
}

TEST(NoiseTunerTest, TellsUncertaintiesThatHoldTheTruth) {
  constexpr int kLogs = 25;
  int inside = 0;
  double sum = 0.0;
  for (int i = 0; i < kLogs; ++i) {
    const auto found = tunedSigmas(drive(100 + std::uint64_t(i), 80, 0.1, M_PI / 40));
    for (const double off : {found.range_off, found.bearing_off}) {
      inside += std::abs(off) < 2.0 ? 1 : 0;
      sum += off * off;
    }
  }
  EXPECT_GE(inside, 0.86 * 2 * kLogs);  // 95 % but for three sigmas of chance
  EXPECT_NEAR(std::sqrt(sum / (2 * kLogs)), 1.0, 0.35);
}

/// To such a sensor each reading foretells the next nearly exactly; that is not how well it sees.
TEST(NoiseTunerTest, IsNotMisledByErrorsThatAreAlikeWhileALandmarkIsInView) {
  const Sensor white{500000000, 0.6, false}, alike{500000000, 0.6, true};
  const auto of_white = tunedSigmas(drive(6, 500, 0.1, 0.4, white));
  EXPECT_TRUE(of_white.of_resightings);
  EXPECT_LT(std::abs(of_white.range_off), 3.0);
  EXPECT_LT(std::abs(of_white.bearing_off), 3.0);
  const auto found = tunedSigmas(drive(6, 500, 0.1, 0.4, alike));
  EXPECT_TRUE(found.of_resightings);
  for (const double share : {found.range, found.bearing}) {
    EXPECT_GT(share, 0.8);
    EXPECT_LT(share, 2.0);
  }
}

/// Where the rest of the model is right, it does not matter how much the filter leaves out.
TEST(NoiseTunerTest, FindsTheSameWithAnyGate) {
  const auto log = drive(5, 300, 0.1, M_PI / 40);
  for (const char* gate : {"0.97", "0.9999", "0.999999999"}) {
    const NoiseTuner tuner(
        [&](const auto& overrides) {
          auto all = rightMotion(overrides);
          all.push_back(std::string("ekf.gate_probability=") + gate);
          return wrongSettings(all);
        },
        {log});
    const auto result = tuner.run({"landmark_sensor.sigma_range", "landmark_sensor.sigma_bearing"});
    for (const auto& [key, truth] :
         {std::pair("sigma_range", kSigmaRange), std::pair("sigma_bearing", kSigmaBearing)})
      EXPECT_NEAR(find(result, key).value, truth, 0.1 * truth) << gate << " " << key;
  }
}

}  // namespace
}  // namespace slam::tuning
