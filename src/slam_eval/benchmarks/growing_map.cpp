// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "cpu_time.hpp"
#include "field_world.hpp"
#include "slam_core/contract/backend.hpp"
#include "slam_core/contract/landmark_mapper.hpp"
#include "slam_core/contract/registry.hpp"
#include "slam_core/geometry/angle.hpp"
#include "slam_core/product/product_config.hpp"
#include "slam_ros/command_line.hpp"

// Drives a back-end lane by lane over a field of landmarks and prints, for each size of the map on
// the way, how long a step takes and how well the robot knows where it is.

namespace slam::eval {
namespace {

double neesOf(const PoseEstimate& estimate, const Pose2& truth) {
  Eigen::Vector3d error = estimate.pose.vector() - truth.vector();
  error.z() = wrapAngle(error.z());
  return error.dot(estimate.covariance.inverse() * error);
}

/// The steps while the map had about so many landmarks.
struct Part {
  std::vector<double> ms;
  double squared_error = 0.0, nees = 0.0;

  double percentile(double share) {
    const auto at = static_cast<std::size_t>(share * static_cast<double>(ms.size() - 1));
    std::nth_element(ms.begin(), ms.begin() + static_cast<std::ptrdiff_t>(at), ms.end());
    return ms[at];
  }
  void print(int landmarks) {
    const auto count = static_cast<double>(ms.size());
    double sum = 0.0;
    for (const double each : ms) sum += each;
    std::printf("| %d | %zu | %.3f | %.3f | %.3f | %.2f | %.3f | %.2f |\n", landmarks, ms.size(),
                sum / count, percentile(0.5), percentile(0.99), percentile(1.0),
                std::sqrt(squared_error / count), nees / count);
    std::fflush(stdout);
  }
};

/// A back-end that is driven by motion and observations.
class Driven {
 public:
  Driven(const std::string& name, const std::vector<std::string>& overrides)
      : backend_(Registry<Backend>::instance().create(name)) {
    Settings settings({}, {}, overrides);
    backend_->configure(settings);
    mapper_ = capabilitiesOf(*backend_).find<LandmarkMapper>();
    if (mapper_ == nullptr) throw std::runtime_error("the back-end maps no landmarks");
    backend_->describe(ports_);
  }
  /// @return the number of landmarks in the map
  int take(const LoopStep& step, Part& part) {
    for (const auto& input : ports_.inputs()) {
      if (input.kind == kindOf<Motion>()) input.set(&step.motion);
      if (input.kind == kindOf<LandmarkObservationArray>()) input.set(&step.observations);
    }
    const double begin = cpuMilliseconds();
    const auto status = backend_->execute();
    const auto estimate = backend_->pose();  // as it is published at every step
    part.ms.push_back(cpuMilliseconds() - begin);
    if (status.level == Status::Level::kError) throw std::runtime_error(status.message);
    part.squared_error += (estimate.pose.position() - step.truth.position()).squaredNorm();
    part.nees += neesOf(estimate, step.truth);
    return mapper_->statistics().landmarks;
  }

 private:
  std::unique_ptr<Backend> backend_;
  LandmarkMapper* mapper_ = nullptr;
  Ports ports_;
};

void run(const std::string& name, const std::vector<std::string>& overrides,
         const FieldWorldConfig& config, std::uint64_t seed) {
  loadLibraries({});
  Driven backend(name, overrides);
  FieldWorld world(config, seed);
  std::puts(
      "| landmarks | steps | step, mean [ms] | median [ms] | 99 % [ms] | worst [ms] | error [m] | "
      "NEES |\n|---|---|---|---|---|---|---|---|");
  Part part;
  int next = config.landmarks / 10;
  while (const auto step = world.next()) {
    const int landmarks = backend.take(*step, part);
    if (landmarks < next) continue;
    part.print(landmarks);
    part = {};
    next += config.landmarks / 10;
  }
  if (!part.ms.empty()) part.print(next);
}

}  // namespace
}  // namespace slam::eval

int main(int argc, char** argv) {
  slam_ros::CommandLine line("slam_eval_growing_map",
                             "step time of a back-end while its map grows");
  std::string backend = "seif";
  std::vector<std::string> overrides;
  slam::eval::FieldWorldConfig world;
  std::uint64_t seed = 1;
  line.add("--backend", backend, "name of the back-end").withDefault();
  line.add("--set", overrides, "section.key=value of the back-end");
  line.add("--landmarks", world.landmarks, "in the field").between(10, 1000000).withDefault();
  line.add("--lane", world.lane, "length of a lane [m]; 0: the field is a square")
      .nonNegative()
      .withDefault();
  line.add("--seed", seed, "seed of the world").nonNegative().withDefault();
  return line.run(argc, argv, [&] { slam::eval::run(backend, overrides, world, seed); });
}
