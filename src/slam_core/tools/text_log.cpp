// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include <fmt/format.h>

#include <string>

#include "exit_code.hpp"
#include "log_rows.hpp"
#include "motion_row.hpp"
#include "observations_row.hpp"
#include "odometry_row.hpp"
#include "scan_row.hpp"
#include "slam_core/product/meta_coordinator.hpp"
#include "slam_core/product/run_writer.hpp"

// A product without ROS: reads a text log, writes a run's folder. Rows of the log, in any order
// of stamps that the sensors would have sent; '#' begins a comment:
//   odometry STAMP_NS X Y THETA                     pose in the odometry frame [m, m, rad]
//   motion ...                                      instead, as slam_core_wheel_log prints it
//   observations STAMP_NS [ID RANGE BEARING]...     [m, rad]; noise from the robot file
//   scan STAMP_NS ANGLE_MIN ANGLE_INCREMENT RANGE_MIN RANGE_MAX RANGE...    [rad, rad, m, m, m];
//                                                   laser.sensor_pose from the robot file

namespace slam {
namespace {

class TextLog {
 public:
  TextLog(MetaCoordinator& coordinator, RunWriter& writer)
      : coordinator_(coordinator), writer_(writer) {}

  void take(LogRows& row) {
    if (row.kind() == "odometry")
      coordinator_.set(odometryIn(row));
    else if (row.kind() == "motion")
      takeMotion(motionIn(row));
    else if (row.kind() == "observations")
      takeObservations(observationsIn(row));
    else if (row.kind() == "scan")
      coordinator_.put("scan", sweepIn(row));
    drain(row);
  }

 private:
  void takeMotion(Motion motion) {
    motion.sequence = motions_++;
    coordinator_.set(motion);
  }

  void takeObservations(LandmarkObservationArray array) {
    array.sequence = arrays_++;
    coordinator_.set(array);
  }

  void drain(LogRows& row) {
    do {
      const auto status = coordinator_.execute();
      if (!status.isOk()) row.tell(status.message);
      if (coordinator_.estimator().report()) writer_.write(*coordinator_.estimator().report());
    } while (coordinator_.estimator().report());
  }

  MetaCoordinator& coordinator_;
  RunWriter& writer_;
  std::uint64_t arrays_ = 0, motions_ = 0;
};

void run(const std::string& product, const std::string& robot, const std::string& log_path,
         const std::string& folder) {
  Settings settings(loadConfigFile(product), loadConfigFile(robot), {});
  MetaCoordinator coordinator;
  coordinator.configure(settings);
  LogRows row(log_path);
  RunWriter writer(folder);
  TextLog log(coordinator, writer);
  while (row.next()) log.take(row);
  const auto& backend = coordinator.estimator().capabilities();
  for (const auto& [name, module] : coordinator.components().modules)
    module->save(writer.unfinished());
  writer.finish(backend, coordinator.components().frames.map, settings.inForce());
  const auto* mapper = backend.find<LandmarkMapper>();
  fmt::print("{}: {} poses, {} landmarks\n", folder, writer.lines(),
             mapper ? mapper->landmarks().size() : 0);
}

}  // namespace
}  // namespace slam

int main(int argc, char** argv) {
  if (argc != 5) {
    fmt::print(stderr, "usage: {} PRODUCT.yaml ROBOT.yaml LOG.txt OUTPUT_FOLDER\n", argv[0]);
    return 2;
  }
  return slam::exitCodeOf([&] { slam::run(argv[1], argv[2], argv[3], argv[4]); });
}
