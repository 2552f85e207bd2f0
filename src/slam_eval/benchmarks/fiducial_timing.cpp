// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fiducial_timing.hpp"

#include <algorithm>
#include <vector>

#include "cpu_time.hpp"
#include "fiducial_setup.hpp"
#include "slam_core/camera/camera_gate.hpp"
#include "slam_sim/studio.hpp"

namespace slam::eval {
namespace {

template <class Call>
double timeOf(const Call& call) {
  const double begin = cpuMilliseconds();
  call();
  return cpuMilliseconds() - begin;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The studio's camera, stretched to images of that size.
CameraCalibration calibrationFor(const cv::Mat& gray) {
  CameraCalibration camera = sim::studioCalibration();
  const double scale = static_cast<double>(gray.cols) / camera.width;
  camera.fx *= scale;
  camera.fy *= scale;
  camera.width = gray.cols;
  camera.height = gray.rows;
  camera.cx = (gray.cols - 1) / 2.0;
  camera.cy = (gray.rows - 1) / 2.0;
  return camera;
}

struct Contest {
  std::string detector, setting;
  std::vector<std::string> overrides;
  std::unique_ptr<BareDetector> bare;
};

nlohmann::json hold(const Contest& contest, const cv::Mat& gray, int repeats) {
  auto ours = makeDetector(contest.detector, contest.overrides);
  const auto ports = portsOf(*ours);
  CameraGate gate;
  gate.configure(CameraConfig());
  gate.set(calibrationFor(gray));
  gate.set(CameraMount{"camera", Eigen::Isometry3d::Identity()});
  std::vector<double> ours_ms, bare_ms;
  int markers = 0;
  for (int i = 0; i <= repeats; ++i) {
    const double ours_time = timeOf([&] {
      gate.set({stampFromNanoseconds(i + 1), "camera", gray, ""});
      gate.execute();
      ports.input("camera", kindOf<CameraView>())->set(&gate.view().value());
      ours->execute();
    });
    const double bare_time = timeOf([&] { markers = contest.bare->detect(gray); });
    if (i == 0) continue;  // the first one allocates
    ours_ms.push_back(ours_time);
    bare_ms.push_back(bare_time);
  }
  return {{"detector", contest.detector},
          {"setting", contest.setting},
          {"markers", markers},
          {"ours_ms", median(ours_ms)},
          {"bare_ms", median(bare_ms)}};
}

}  // namespace

cv::Mat tenMarkers() {
  sim::World world = sim::studioWorld("36h11", 0);
  world.markers.clear();
  for (int i = 0; i < 10; ++i) {
    const double y = 0.34 * (i % 5 - 2), z = i < 5 ? 1.2 : 0.82;
    world.markers.push_back({"36h11", i, 0.16, sim::uprightMarker({0.0, y, z}, 0.0)});
  }
  const auto camera = sim::studioCamera(world);
  return camera.render(sim::standing(sim::cameraBefore(1.7, 0.2)), RandomStream(1, 0));
}

nlohmann::json timeDetectors(const cv::Mat& gray, const std::string& image_name, int repeats) {
  std::vector<Contest> contests;
  contests.push_back(
      {"apriltag", "quad_decimate 1", {"apriltag.quad_decimate=1"}, makeBareAprilTag(1.0)});
  contests.push_back(
      {"apriltag", "quad_decimate 2", {"apriltag.quad_decimate=2"}, makeBareAprilTag(2.0)});
  contests.push_back({"aruco", "default", {}, makeBareAruco()});
  auto result = nlohmann::json::array();
  for (const Contest& contest : contests) {
    auto entry = hold(contest, gray, repeats);
    entry["image"] = image_name;
    result.push_back(entry);
  }
  return result;
}

}  // namespace slam::eval
