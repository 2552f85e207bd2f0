# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Packages that new_component writes: what stands in them, and what is refused. test/run_tests builds
a back-end, with --all one of each role, and runs its contract."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

import rospkg
from slam_launch import new_component, packages, ports, products
from slam_launch.errors import ProductError
from slam_launch.feature_model import FeatureModel


class NewComponent(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.model = FeatureModel()

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name="my_own", role="backend", into=None):
        return new_component.write(name, role, into or self.folder, self.model)

    def refusal(self, *arguments, **options):
        before = sorted(self.folder.rglob("*"))
        with self.assertRaises(ProductError) as caught:
            self.write(*arguments, **options)
        self.assertEqual(sorted(self.folder.rglob("*")), before)  # nothing is left behind
        return str(caught.exception)

    def test_has_what_a_package_of_each_role_needs(self):
        for role in new_component.ROLES:
            package = self.write(role=role)
            self.assertEqual(package.name, f"slam_{role}_my_own")
            there = {str(path.relative_to(package)) for path in package.rglob("*")}
            self.assertLessEqual({"package.xml", "CMakeLists.txt", "README.md", "features/Kconfig",
                                  "test/contract_test.cpp"}, there)
            self.assertTrue(list((package / "products").glob("*my_own*.yaml")), role)
            named = ElementTree.parse(package / "package.xml").findtext("name")
            self.assertEqual(named, package.name)

    def test_has_its_name_everywhere(self):
        for role in new_component.ROLES:
            for path in self.write(role=role).rglob("*"):
                self.assertNotIn("toy", path.name)
                if path.is_file():
                    self.assertNotIn("toy", path.read_text(encoding="utf-8").lower(), path)
        text = (self.folder / "slam_backend_my_own/src/my_own_backend.cpp").read_text("utf-8")
        for piece in ("MyOwnBackend::execute()", 'kRegistrar("my_own")', "namespace slam_my_own"):
            self.assertIn(piece, text)

    def test_its_targets_have_no_other_package_s_name(self):
        """All packages that are built together share one list of targets."""
        for role in new_component.ROLES:
            package = self.write("active", role)
            text = (package / "CMakeLists.txt").read_text(encoding="utf-8")
            targets = set(re.findall(r"(?:add_library|add_executable|gtest)\((\w+)", text))
            self.assertTrue(targets)
            self.assertFalse(targets & set(rospkg.RosPack().list()), role)

    def test_is_a_feature(self):
        keys = {"backend": "backend", "odometry": "odometry", "detector": "detector"}
        files = [packages.share() / "features" / "Kconfig"]
        files += [self.write(role=role) / "features" / "Kconfig" for role in new_component.ROLES]
        model = FeatureModel(files)
        for key in keys.values():
            self.assertIn("my_own", model.groups[key].symbols)
        self.assertEqual(model.groups["map_my_own"].symbols,
                         {"false": "MAP_MY_OWN", "true": "MAP_MY_OWN"})
        model.require_valid({"backend": "my_own", "odometry": "my_own", "map_my_own": "true"})

    def test_of_a_module_leaves_the_products_of_others_as_they_are(self):
        files = [packages.share() / "features" / "Kconfig",
                 self.write(role="map") / "features" / "Kconfig"]
        model = FeatureModel(files)
        for product in (products.find("ekf_wheel", model), products.without_file(
                model.complete({"backend": "ekf", "odometry": "wheel"}), model)):
            self.assertEqual(product.features["map_my_own"], "false")
            self.assertNotIn("map_my_own", product.content)
            ports.require_joined(product)  # whose libraries do not know the module

    def test_is_the_example_itself_under_the_examples_name(self):
        for role in new_component.ROLES:
            example = new_component.example_of(role)
            new_component.copy(example, self.folder / example.name, "toy")
            for path in (self.folder / example.name).rglob("*"):
                if path.is_file():
                    original = example / path.relative_to(self.folder / example.name)
                    self.assertEqual(path.read_bytes(), original.read_bytes())

    def test_refuses_a_role_that_is_not_there(self):
        said = self.refusal(role="bakend")
        self.assertIn("there is no role 'bakend' (did you mean 'backend'?)", said)
        self.assertIn("backend, odometry, detector, map", said)

    def test_refuses_a_name_that_is_no_ros_name(self):
        for name in ("My", "1st", "a-b", "a b", "", "_a", "a_", "a__b", "../up", "häß",
                     300 * "a"):
            self.assertIn("is no name of a ROS package", self.refusal(name), name)

    def test_refuses_a_name_that_exists(self):
        for name, role in (("ekf", "backend"), ("wheel", "odometry"), ("aruco", "detector"),
                           ("none", "detector"), ("grid", "map")):
            self.assertIn(" already; give another name", self.refusal(name, role))
        for name, role in (("frames", "backend"), ("map", "backend"), ("seed", "backend"),
                           ("point", "map"), ("visual", "odometry")):
            self.assertIn("; give another name", self.refusal(name, role))

    def test_refuses_a_folder_that_is_there_already(self):
        self.write()
        said = self.refusal()
        self.assertIn(f"{self.folder / 'slam_backend_my_own'} is there already", said)

    def test_refuses_a_folder_that_is_not_there_or_cannot_be_written(self):
        self.assertIn("there is no folder", self.refusal(into=self.folder / "no"))
        self.assertIn("cannot write /proc/", self.refusal(into="/proc"))

    def test_the_command_says_where_it_is_and_what_the_roles_are(self):
        program = packages.program("slam_launch", "new_component")
        done = call(program, "fresh", "--role", "map", "--into", self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(str(self.folder / "slam_map_fresh"), done.stdout)
        for role in new_component.ROLES:
            self.assertIn(f"\n  {role}", call(program, "--help").stdout)
        done = call(program, "fresh", "--role", "map", "--into", self.folder)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1))
        self.assertEqual(call(program, "fresh").returncode, 2)


def call(*words):
    return subprocess.run([str(word) for word in words], check=False, capture_output=True,
                          text=True, env={**os.environ, "COLUMNS": "100"})


if __name__ == "__main__":
    unittest.main()
