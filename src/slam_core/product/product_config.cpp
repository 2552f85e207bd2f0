// SPDX-FileCopyrightText: 2026 the SLAM product line authors
// SPDX-License-Identifier: BSD-3-Clause

#include "slam_core/product/product_config.hpp"

#include <dlfcn.h>

#include "slam_core/common/config_error.hpp"
#include "slam_core/contract/map_module.hpp"
#include "slam_core/contract/registry.hpp"

namespace slam {

namespace {

struct NamedLibraries {
  static constexpr const char* kSection = ProductConfig::kSection;

  std::vector<std::string> names;

  void describe(Fields& fields) { fields.add("libraries", &names, "of the product"); }
};

/// What is wrong with other keys is not to be said twice.
std::vector<std::string> librariesOf(Settings settings) {
  NamedLibraries libraries;
  try {
    settings.read(libraries);
  } catch (const ConfigError&) {
  }
  return libraries.names;
}

}  // namespace

void readProduct(Settings& settings, ProductConfig& product) {
  FaultCollector faults;
  faults.attempt([&] { loadLibraries(librariesOf(settings)); });
  faults.attempt([&] { settings.read(product); });
  faults.raise();
}

void ProductConfig::describe(Fields& fields) {
  fields.add("product", &product, "name of the product");
  fields.add("sentence", &sentence, "what it is, in one line");
  fields.add("libraries", &libraries, "shared libraries with components beyond the built-in ones");
  fields.add("backend", &backend, "name of the back-end component");
  fields.add(
      "odometry", &odometry,
      "name of the odometry source: wheel, wheel_imu (the wheels' way, a gyro's heading), command "
      "(commands that the base follows), visual (a camera that looks at the ceiling), visual_wheel "
      "(the wheels where the images tell "
      "nothing), visual_imu (a gyro's turns as a hint and where the images tell nothing), laser "
      "(scans matched with what was seen before), laser_wheel (the wheels as a hint and where "
      "scans tell nothing), laser_imu (a gyro's turns as a hint and where scans tell nothing); "
      "none: motion comes as messages, or the back-end needs none");
  fields.add("detector", &detector,
             "name of the detector that finds landmarks in the camera's images; none: they come as "
             "observations");
  fields.add("second_detector", &second_detector,
             "name of a detector beside the first one, which finds other landmarks with the same "
             "sensor; none: there is one detector");
  fields.add("second_camera", &second_camera,
             "the detectors look through a second camera as well, which the robot file calls "
             "rear_camera");
  fields.add("rear_laser", &rear_laser,
             "the scans of a second laser go into the map as well, joined with those of the first "
             "one; the robot file calls it rear_scan");
  fields.add("association", &association,
             "how it is decided of which landmark an observation is: known_ids (it says so), "
             "nearest (by its place, each on its own), jcbb (by their places, all of a stamp "
             "together), descriptor (as jcbb, among landmarks whose descriptor fits)");
  fields.add("map", &map, mapKindNames(),
             "representation of the map: landmarks, or a grid that a laser's scans are drawn into");
  for (const auto& name : Registry<MapModule>::instance().names())
    fields.add(name, &modules[name], Registry<MapModule>::instance().create(name)->sentence());
  fields.add("seed", &seed, "of every random stream");
  fields
      .add("source_timeout", &source_timeout,
           "after this time of stamps a silent source stops holding the others back")
      .unit("s")
      .in(Range::above(0));
  fields.add("robot", &robot, "name of the robot").ofRobot();
}

void FramesConfig::describe(Fields& fields) {
  fields.add("map", &map, "the map's frame").ofRobot();
  fields.add("odom", &odom, "the odometry's frame, where the data do not name one").ofRobot();
  fields.add("base", &base, "the robot's frame: odometry moves it, sensors are mounted in it")
      .ofRobot();
  fields
      .add("jump_limit", &jump_limit,
           "the transform map -> odom moves the robot in the map by at most so much; 0: it jumps "
           "with the estimate, as REP-105 allows")
      .unit("m/s of stamps")
      .in(Range::atLeast(0))
      .ofRobot();
  fields
      .add("jump_limit_heading", &jump_limit_heading,
           "and turns it by at most so much; counts only with a jump_limit")
      .unit("rad/s of stamps")
      .in(Range::above(0))
      .ofRobot();
}

void FramesConfig::requireDistinctNames() const {
  FaultCollector faults;
  for (const auto& [key, name] : {std::pair("map", map), {"odom", odom}, {"base", base}})
    if (name.empty() || name[0] == '/' || name.find(' ') != std::string::npos)
      faults.add(std::string("frames.") + key + ": '" + name +
                 "' is no frame's name; it must not be empty, begin with a slash or hold a space");
  if (map == odom || odom == base || base == map)
    faults.add("frames: map, odom and base are " + map + ", " + odom + " and " + base +
               "; they must differ");
  faults.raise();
}

void FramesConfig::complete(std::string& odometry_frame, std::string& base_frame) const {
  if (odometry_frame.empty()) odometry_frame = odom;
  if (base_frame.empty()) base_frame = base;
}

void loadLibraries(const std::vector<std::string>& libraries) {
  FaultCollector faults;
  for (const auto& library : libraries)
    if (dlopen(library.c_str(), RTLD_NOW | RTLD_GLOBAL) == nullptr)
      faults.add("cannot load the product's library " + library + ": " + dlerror());
  faults.raise();
}

}  // namespace slam
