# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What slam_core includes: no ROS, and components know nothing of one another."""

import pathlib
import re
import unittest

CORE = pathlib.Path(__file__).resolve().parents[2] / "src" / "slam_core"
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)

# Libraries beside C++'s own and the system's; whoever adds one here has seen that it is not ROS.
LIBRARIES = {"Eigen", "opencv2", "yaml-cpp", "fmt", "apriltag", "Random123", "suitesparse", "gtest"}
STANDARD = re.compile(r"[a-z_0-9]+$|cxxabi\.h$|(sys/)?"
                      r"(dlfcn|fcntl|file|mman|prctl|resource|stat|types|unistd|wait)\.h$")

# each may include those before it
BELOW = ["common", "geometry", "models", "graph", "contract", "grid_map", "camera", "imu", "gyro",
         "laser", "association", "landmark_graph", "scan_matching", "consistency"]
ABOVE = {"product", "tuning", "tools"}  # what lies between is a component


def sources():
    return [path for path in CORE.rglob("*") if path.suffix in (".cpp", ".hpp", ".h")]


def level(name):
    return BELOW.index(name) if name in BELOW else len(BELOW) + (name in ABOVE)


def includes(path):
    return INCLUDE.findall(path.read_text(encoding="utf-8"))


def folder(path):
    return path.relative_to(CORE).parts[0]


def is_plain(name):
    return bool(STANDARD.match(name)) or name.split("/")[0] in LIBRARIES


class NoRos(unittest.TestCase):
    def test_the_rule_knows_ros_when_it_sees_it(self):
        for name in ("ros/ros.h", "sensor_msgs/Image.h", "tf2/convert.h", "nodelet/nodelet.h",
                     "pluginlib/class_list_macros.hpp", "cv_bridge/cv_bridge.h", "boost/bind.hpp"):
            self.assertFalse(is_plain(name), name)
        for name in ("vector", "cstdint", "Eigen/Core", "opencv2/core.hpp", "sys/wait.h"):
            self.assertTrue(is_plain(name), name)

    def test_nothing_under_slam_core_includes_ros(self):
        self.assertGreater(len(sources()), 100)
        found = [f"{path.relative_to(CORE)}: {name}" for path in sources()
                 for bracket, name in includes(path) if bracket == "<" and not is_plain(name)]
        self.assertEqual(found, [], "neither C++, POSIX nor a library that is listed")

    def test_what_it_includes_in_quotes_is_its_own(self):
        found = [f"{path.relative_to(CORE)}: {name}" for path in sources()
                 for bracket, name in includes(path)
                 if bracket == '"' and not (name.startswith("slam_core/") and
                                            (CORE.parent / name).exists())
                 and not (path.parent / name).exists()]
        self.assertEqual(found, [])

    def test_it_looks_for_no_ros_package_but_catkin(self):
        packages = re.findall(r"find_package\((\w+)", (CORE / "CMakeLists.txt").read_text())
        self.assertLessEqual({"catkin", "Eigen3"}, set(packages))
        self.assertFalse({name for name in packages
                          if re.match("ros|tf|nodelet|pluginlib|.*_msgs|cv_bridge|image_t", name)})


class OneWay(unittest.TestCase):
    """common <- geometry <- models <- graph, contract <- grid_map, camera, imu, gyro, laser,
    association, landmark_graph, scan_matching, consistency <- components <- product; tests may look
    at more."""

    def uses(self):
        for path in sources():
            if "test" in path.parts:
                continue
            for bracket, name in includes(path):
                if bracket == '"' and name.startswith("slam_core/"):
                    yield path.relative_to(CORE), folder(path), name.split("/")[1]

    def test_components_never_include_one_another(self):
        found = [str(path) for path, user, used in self.uses()
                 if level(user) == level(used) == len(BELOW) and user != used]
        self.assertEqual(found, [])

    def test_nothing_includes_what_is_above_it(self):
        found = [f"{path} includes {used}" for path, user, used in self.uses()
                 if level(used) > level(user)]
        self.assertEqual(found, [])


if __name__ == "__main__":
    unittest.main()
