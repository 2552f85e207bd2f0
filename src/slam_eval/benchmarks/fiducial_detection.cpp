// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fiducial_detection.hpp"

#include <cmath>

#include "fiducial_setup.hpp"
#include "slam_sim/marker_stand.hpp"
#include "slam_sim/studio.hpp"

namespace slam::eval {
namespace {

constexpr double kDistances[] = {0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0};  // [m]
constexpr int kObliqueness[] = {0, 20, 40, 60, 70, 80};                    // [deg]
constexpr int kWindow = 280;                                               // [px]
constexpr double kNearest = 1.0;  // from here on the marker may stand further aside [m]

nlohmann::json cell(sim::MarkerStand& stand, double distance, int obliqueness, int trials,
                    std::uint64_t& frame) {
  const double aside = distance < kNearest ? 0.08 : 0.15;
  int detected = 0;
  double sum = 0.0, squares = 0.0, bearing = 0.0;
  for (int i = 0; i < trials; ++i) {
    const auto T =
        sim::poseBefore(distance, obliqueness * M_PI / 180.0, aside, static_cast<std::uint64_t>(i));
    const auto z = stand.look(sim::standing(T), frame++);
    if (!z) continue;
    const auto truth = stand.truth(T);
    const double error = (z->range - truth.range) / truth.range;
    ++detected;
    sum += error;
    squares += error * error;
    bearing += z->bearing - truth.bearing;
  }
  nlohmann::json entry = {{"distance_m", distance},     {"obliqueness_deg", obliqueness},
                          {"trials", trials},           {"detected", detected},
                          {"range_bias", nullptr},      {"range_sigma", nullptr},
                          {"bearing_bias_rad", nullptr}};
  if (detected == 0) return entry;
  const double mean = sum / detected;
  entry["range_bias"] = mean;
  entry["range_sigma"] = std::sqrt(std::max(squares / detected - mean * mean, 0.0));
  entry["bearing_bias_rad"] = bearing / detected;
  return entry;
}

}  // namespace

nlohmann::json detectionTable(int trials,
                              const std::function<void(std::size_t, std::size_t)>& progress) {
  const std::size_t cells = 2 * std::size(kDistances) * std::size(kObliqueness);
  std::size_t done = 0;
  auto result = nlohmann::json::array();
  for (const std::string name : {"apriltag", "aruco"}) {
    sim::MarkerStand stand(makeDetector(name, {}), sim::studioWindow(kWindow, kWindow), {});
    std::uint64_t frame = 0;
    for (const double distance : kDistances) {
      for (const int obliqueness : kObliqueness) {
        auto entry = cell(stand, distance, obliqueness, trials, frame);
        entry["detector"] = name;
        result.push_back(entry);
        progress(++done, cells);
      }
    }
  }
  return result;
}

}  // namespace slam::eval
