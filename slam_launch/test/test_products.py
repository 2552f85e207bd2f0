# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Product files: what is refused and why, and that what is written is found again."""

import os
import pathlib
import subprocess
import tempfile
import unittest
from unittest import mock

from catkin.find_in_workspaces import find_in_workspaces
from slam_launch import config_files, products
from slam_launch.errors import ProductError
from slam_launch.feature_model import FeatureModel
import yaml

HEAD = "version: 1\nproduct: mine\n"
FEATURES = "backend: pf\nodometry: wheel\nmap: landmarks\ndetector: apriltag\n"


class ProductFiles(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.model = FeatureModel()

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        home = mock.patch.dict(os.environ, {"XDG_CONFIG_HOME": folder.name})
        home.start()
        self.addCleanup(home.stop)

    def read(self, content):
        path = self.folder / "mine.yaml"
        path.write_text(content, encoding="utf-8")
        return products.read(path, self.model)

    def expect_refusal(self, sentence, content):
        with self.assertRaises(ProductError) as caught:
            self.read(content)
        self.assertIn(sentence, str(caught.exception))
        self.assertIn(str(self.folder / "mine.yaml"), str(caught.exception))

    def make(self, *words, name="mine"):
        return products.make(name, words, self.model)


class Reading(ProductFiles):
    def test_the_shipped_ones_are_valid(self):
        self.assertGreaterEqual(len(products.named(self.model, self.fail)), 6)

    def test_takes_what_is_left_out_as_the_programs_without_ros_do(self):
        product = self.read(HEAD + "backend: ekf\nodometry: visual\n")
        self.assertEqual(product.features["detector"], "none")
        self.assertEqual(product.features["map"], "landmarks")

    def test_the_grid_product_has_no_odometry_and_is_valid_with_wheels(self):
        product = products.find("scan_grid", self.model)
        self.assertEqual({key: product.features[key] for key in ("backend", "odometry", "map",
                                                                 "detector")},
                         {"backend": "grid", "odometry": "none", "map": "grid",
                          "detector": "none"})
        with_wheels = self.read(yaml.safe_dump({**product.content, "odometry": "wheel"}))
        self.assertEqual(with_wheels.features, {**product.features, "odometry": "wheel"})

    def test_refuses_a_newer_version(self):
        self.expect_refusal("has version 2, which is newer than this program",
                            HEAD.replace("1", "2") + FEATURES)

    def test_refuses_no_version(self):
        self.expect_refusal("has no version; this program reads version 1", FEATURES)

    def test_refuses_an_unknown_feature_and_names_the_nearest(self):
        self.expect_refusal("odometry=wheels is not a feature; odometry is one of: wheel, "
                            "wheel_imu, visual",
                            HEAD + FEATURES.replace("wheel", "wheels"))

    def test_refuses_a_missing_mandatory_feature(self):
        self.expect_refusal("needs odometry (one of:", HEAD + "backend: pf\n")

    def test_refuses_two_of_a_one_of_group(self):
        self.expect_refusal("backend is ekf and pf; a product has exactly one of: ",
                            HEAD + "backend: [ekf, pf]\nodometry: wheel\n")
        self.expect_refusal("backend stands there a second time",
                            HEAD + FEATURES + "backend: ekf\n")

    def test_refuses_a_parameter_of_a_feature_that_is_not_chosen(self):
        self.expect_refusal("ekf.gate_probability is a parameter of backend=ekf, which is not "
                            "chosen: the product is backend=pf",
                            HEAD + FEATURES + "ekf: {gate_probability: 0.9}\n")
        self.read(HEAD + FEATURES + "pf: {particles: 20}\n")

    def test_reports_a_bad_file_among_the_named_ones_and_lists_the_others(self):
        folder = config_files.user_products()
        folder.mkdir(parents=True)
        (folder / "mine.yaml").write_text(HEAD, encoding="utf-8")
        faults = []
        self.assertGreaterEqual(len(products.named(self.model, faults.append)), 6)
        self.assertEqual(len(faults), 1)


class Writing(ProductFiles):
    def test_a_written_product_is_found_by_its_name(self):
        written = self.make("backend=pf", "odometry=visual", "detector=aruco", "pf.particles=50")
        path = products.write(written)
        self.assertEqual(path, self.folder / "slam" / "products" / "mine.yaml")
        found = products.find("mine", self.model)
        self.assertEqual(found.features["detector"], "aruco")
        self.assertEqual(found.content["pf"], {"particles": 50})
        self.assertEqual(yaml.safe_load(path.read_text(encoding="utf-8")), found.content)
        self.assertIn("mine", [product.name for product in products.named(self.model)])

    def test_arguments_may_be_written_as_those_of_a_launch(self):
        self.assertEqual(self.make("backend:=pf", "odometry:=wheel").features["backend"], "pf")

    def expect_refusal_of(self, sentence, *words, name="mine"):
        with self.assertRaises(ProductError) as caught:
            products.write(self.make(*words, name=name))
        self.assertIn(sentence, str(caught.exception))
        self.assertFalse(config_files.user_products().exists())

    def test_refuses_a_name_that_is_taken_or_is_none(self):
        self.expect_refusal_of("there is a product 'pf_wheel' already", "backend=pf",
                               "odometry=wheel", name="pf_wheel")
        self.expect_refusal_of("'../x' is no name of a product", "backend=pf", "odometry=wheel",
                               name="../x")

    def test_refuses_what_is_given_twice(self):
        self.expect_refusal_of("backend is given twice, as ekf and as pf", "backend=ekf",
                               "backend=pf", "odometry=wheel")

    def test_refuses_a_parameter_of_a_feature_that_is_not_chosen(self):
        self.expect_refusal_of("pf.particles is a parameter of backend=pf, which is not chosen",
                               "backend=ekf", "odometry=wheel", "pf.particles=50")

    def test_refuses_a_word_without_a_value(self):
        self.expect_refusal_of("'backend' is not KEY=VALUE", "backend")
        for word in (".particles=5", "pf.=5"):
            self.expect_refusal_of(f"'{word}' is not KEY=VALUE", word)

    def test_refuses_a_value_that_no_file_could_hold(self):
        for value in ("[1", "!!python/object:os.system ls"):
            self.expect_refusal_of(f"pf.particles={value} is no value: ", "backend=pf",
                                   "odometry=wheel", f"pf.particles={value}")

    def test_names_the_feature_that_was_meant_in_capitals(self):
        self.expect_refusal_of("there is no feature 'BACKEND' (did you mean 'backend'?)",
                               "BACKEND=pf")

    def test_names_the_parameter_that_was_meant_without_its_section(self):
        self.expect_refusal_of("there is no feature 'particles'; pf.particles is a parameter of "
                               "that name, given with the section", "backend=pf",
                               "odometry=wheel", "particles=50")
        self.expect_refusal_of("ekf.mode and graph.mode and grid.mode and mono_ekf.mode and "
                               "mono_graph.mode and pf.mode and rat.mode and seif.mode are "
                               "parameters of that name",
                               "mode=slam")

    def test_refuses_an_octal_number(self):
        self.expect_refusal_of("pf.particles=010 is no value: a number does not begin with 0",
                               "backend=pf", "odometry=wheel", "pf.particles=010")
        self.assertEqual(self.make("backend=pf", "odometry=wheel", "pf.resampling_threshold=0.5")
                         .content["pf"], {"resampling_threshold": 0.5})

    def test_says_where_it_cannot_write(self):
        (self.folder / "slam").write_text("a file", encoding="ascii")
        with self.assertRaisesRegex(ProductError, "cannot write .*/slam/products/mine.yaml"):
            products.write(self.make("backend=pf", "odometry=wheel"))


class ByFeatures(ProductFiles):
    def test_the_named_product_comes_first(self):
        features = self.model.require_valid({"backend": "pf", "odometry": "wheel"})
        self.assertEqual(products.with_features(features, self.model).name, "pf_wheel")

    def test_another_detector_keeps_the_rest_of_a_named_product(self):
        features = self.model.require_valid({"backend": "pf", "odometry": "wheel",
                                             "detector": "aruco"})
        product = products.with_features(features, self.model)
        self.assertEqual((product.name, product.content["detector"]), ("pf_wheel", "aruco"))
        self.assertIn("particles", product.content["pf"])

    def test_a_product_of_the_user_is_found_by_its_name_only(self):
        words = ("backend=pf", "odometry=visual", "detector=aruco")
        features = self.model.require_valid(dict(word.split("=") for word in words))
        before = products.with_features(features, self.model)
        products.write(self.make(*words, "pf.particles=7"))
        self.assertEqual(products.find("mine", self.model).features, features)
        self.assertEqual(products.with_features(features, self.model), before)
        self.assertEqual(before.name, "pf_visual")


class Listing(ProductFiles):
    def listed(self):
        program = find_in_workspaces(["libexec"], "slam_launch", "products", first_match_only=True)
        return subprocess.run(program, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              check=False)

    def test_a_product_whose_parameters_cannot_be_read_is_told_instead(self):
        products.write(self.make("backend=pf", "odometry=wheel", "pf.particles=7"))
        listed = self.listed()
        self.assertEqual((listed.returncode, listed.stderr), (0, ""))
        self.assertIn("\nmine ", listed.stdout)
        path = products.write(self.make("backend=pf", "odometry=wheel", name="other"))
        path.write_text(HEAD + FEATURES + "pf: {particles: many}\n", encoding="utf-8")
        listed = self.listed()
        self.assertEqual(listed.returncode, 1)
        self.assertIn(f"products: pf.particles in {path}:7: 'many' is not of type integer",
                      listed.stderr)
        self.assertNotIn("\nother ", listed.stdout)
        self.assertIn("\nmine ", listed.stdout)


if __name__ == "__main__":
    unittest.main()
