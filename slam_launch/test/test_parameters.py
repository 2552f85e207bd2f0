# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parameters of products against what the components read, and the sentences of refusals."""

import os
import pathlib
import tempfile
import unittest
from unittest import mock

from slam_launch import config_files, packages, parameters, products
from slam_launch.errors import ProductError
from slam_launch.feature_model import FeatureModel

HEAD = "version: 1\nproduct: mine\nbackend: pf\nodometry: wheel\n"


class Refusals(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.model = FeatureModel()

    def expect_refusal(self, sentence, call, *arguments):
        with self.assertRaises(ProductError) as caught:
            call(*arguments)
        self.assertIn(sentence, str(caught.exception))
        self.assertNotIn("\n", str(caught.exception))


class InArguments(Refusals):
    def make(self, *words):
        return products.make("mine", ["backend=pf", "odometry=wheel", *words], self.model)

    def expect(self, sentence, *words):
        self.expect_refusal(sentence, self.make, *words)

    def test_what_components_read_is_taken(self):
        content = self.make("pf.particles=50", "pf.size=kld").content
        self.assertEqual(content["pf"], {"particles": 50, "size": "kld"})

    def test_an_unknown_one_is_named_with_the_nearest(self):
        self.expect("pf.particels in the arguments: unknown (did you mean 'particles'?)",
                    "pf.particels=50")

    def test_a_value_out_of_range_is_told_with_range_and_unit(self):
        self.expect("pf.kld_bin_position in the arguments: -1 is not allowed; the range is > 0, "
                    "in m", "pf.kld_bin_position=-1")
        self.expect("pf.resampling_threshold in the arguments: 2 is not allowed; the range is "
                    "[0, 1]", "pf.resampling_threshold=2")

    def test_a_value_of_another_type_or_of_no_choice_is_told(self):
        self.expect("pf.particles in the arguments: 'many' is not of type integer",
                    "pf.particles=many")
        self.expect("pf.size in the arguments: 'kdl' is not one of: fixed, kld (did you mean "
                    "'kld'?)", "pf.size=kdl")

    def test_what_belongs_to_the_robot_is_told(self):
        self.expect("fiducial.marker_size in the arguments: belongs in the robot file",
                    "fiducial.marker_size=0.2")

    def test_all_faults_are_told_at_once(self):
        self.expect("the range is [1, 100000]; pf.size", "pf.particles=0", "pf.size=big")

    def test_an_unknown_section_is_named_with_the_nearest(self):
        self.expect("section grid_mpa in the arguments belongs to no component of this product "
                    "(did you mean 'grid_map'?)", "grid_mpa.resolution=0.1")

    def test_what_a_product_file_says_otherwise_is_not_overwritten(self):
        for key in ("libraries", "seed", "backend", "version"):
            self.expect(f"{key}.x is no parameter: {key} stands for itself in a product file",
                        f"{key}.x=1")


class InFiles(Refusals):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "mine.yaml"

    def require(self, content, *overrides):
        self.path.write_text(HEAD + content, encoding="utf-8")
        products.require_parameters(products.find(str(self.path), self.model), overrides)

    def expect(self, sentence, content, *overrides):
        self.expect_refusal(sentence, self.require, content, *overrides)

    def test_shipped_ones_hold_what_components_read(self):
        files = config_files.files("products")
        self.assertGreaterEqual(len(files), 8)
        for path in files.values():
            parameters.require_valid_file(path)

    def test_a_fault_is_told_with_its_line(self):
        self.expect(f"pf.particles in {self.path}:6: 0 is not allowed; the range is [1, 100000]",
                    "pf:\n  particles: 0\n")
        self.expect(f"sede in {self.path}:5: unknown (did you mean 'seed'?)", "sede: 4\n")

    def test_a_section_of_no_component_is_told(self):
        self.expect(f"section fp in {self.path}:5 belongs to no component", "fp: {particles: 3}\n")

    def test_overrides_may_be_the_robots_but_must_be_known(self):
        self.require("", "fiducial.marker_size=0.2", "frames.map=world", "source_timeout=3")
        self.expect("override fiducial.marker_size: 0 is not allowed; the range is > 0, in m", "",
                    "fiducial.marker_size=0")
        self.expect("override pf.particels: unknown (did you mean 'particles'?)", "",
                    "pf.particels=3")
        self.expect("override topcis.odom=o names no section of this product (did you mean "
                    "'topics'?)", "", "topcis.odom=o")

    def test_a_library_that_is_not_there_is_named(self):
        self.expect("cannot load the product's library libnowhere.so",
                    "libraries: [libnowhere.so]\n")


class WithoutProgram(Refusals):
    def test_is_told_where_there_is_something_to_check(self):
        with mock.patch.object(packages, "find_in_workspaces", return_value=[]):
            parameters.require_valid_parameters([], [])
            self.expect_refusal("the program 'slam_parameters' of slam_ros is not built",
                                parameters.require_valid_parameters, ["pf.particles=3"], [])

    def test_a_program_that_dies_is_told(self):
        with mock.patch.object(packages, "program", return_value="/bin/false"):
            self.expect_refusal("slam_parameters ended with exit code 1",
                                parameters.require_valid_file, os.devnull)


if __name__ == "__main__":
    unittest.main()
