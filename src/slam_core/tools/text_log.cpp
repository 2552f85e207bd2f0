// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>

#include "slam_core/product/meta_coordinator.hpp"
#include "slam_core/product/run_writer.hpp"

// A product without ROS: reads a text log, writes a run's folder. Lines of the log, in any order
// of stamps that the sensors would have sent; '#' begins a comment:
//   odometry STAMP_NS X Y THETA                     pose in the odometry frame [m, m, rad]
//   observations STAMP_NS [ID RANGE BEARING]...     [m, rad]; noise from the robot file

namespace slam {
namespace {

class TextLog {
 public:
  TextLog(MetaCoordinator& coordinator, RunWriter& writer)
      : coordinator_(coordinator), writer_(writer) {}

  void read(std::istream& log) {
    std::string line;
    for (number_ = 1; std::getline(log, line); ++number_) {
      std::istringstream words(line.substr(0, line.find('#')));
      std::string kind;
      if (!(words >> kind)) continue;
      if (kind == "odometry")
        coordinator_.set(odometry(words));
      else if (kind == "observations")
        coordinator_.set(observations(words));
      else
        throw std::runtime_error(
            fmt::format("line {}: '{}' is neither odometry nor observations", number_, kind));
      drain();
    }
  }

 private:
  template <class T>
  T next(std::istream& words) const {
    T value;
    if (words >> value) return value;
    throw std::runtime_error(fmt::format("line {}: a number is missing or malformed", number_));
  }

  OdometrySample odometry(std::istream& words) const {
    OdometrySample sample;
    sample.stamp = stampFromNanoseconds(next<std::int64_t>(words));
    const double x = next<double>(words), y = next<double>(words);
    sample.pose = Pose2(x, y, next<double>(words));
    return sample;
  }

  LandmarkObservationArray observations(std::istream& words) {
    LandmarkObservationArray array;
    array.stamp = stampFromNanoseconds(next<std::int64_t>(words));
    array.sequence = sequence_++;
    while (words >> std::ws && !words.eof()) {
      LandmarkObservation z;
      z.id = next<LandmarkId>(words);
      z.range = next<double>(words);
      z.bearing = next<double>(words);
      z.covariance(0, 0) = -1.0;  // the robot file's
      array.observations.push_back(z);
    }
    return array;
  }

  void drain() {
    do {
      const auto status = coordinator_.execute();
      if (!status.isOk()) fmt::print(stderr, "line {}: {}\n", number_, status.message);
      if (coordinator_.estimator().report()) writer_.write(*coordinator_.estimator().report());
    } while (coordinator_.estimator().report());
  }

  MetaCoordinator& coordinator_;
  RunWriter& writer_;
  std::uint64_t sequence_ = 0;
  int number_ = 0;
};

void run(const std::string& product, const std::string& robot, const std::string& log_path,
         const std::string& folder) {
  Settings settings(loadConfigFile(product), loadConfigFile(robot), {});
  MetaCoordinator coordinator;
  coordinator.configure(settings);
  std::ifstream log(log_path);
  if (!log) throw std::runtime_error("cannot read the log " + log_path + "; does it exist?");
  RunWriter writer(folder);
  TextLog(coordinator, writer).read(log);
  writer.finish(coordinator.estimator().backend(), coordinator.frames().map, settings.inForce());
  fmt::print("{}: {} poses, {} landmarks\n", folder, writer.lines(),
             coordinator.estimator().backend().landmarks().size());
}

}  // namespace
}  // namespace slam

int main(int argc, char** argv) {
  if (argc != 5) {
    fmt::print(stderr, "usage: {} PRODUCT.yaml ROBOT.yaml LOG.txt OUTPUT_FOLDER\n", argv[0]);
    return 2;
  }
  try {
    slam::run(argv[1], argv[2], argv[3], argv[4]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
