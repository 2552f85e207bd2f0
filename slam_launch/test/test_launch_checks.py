# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The arguments of slam.launch before anything is started."""

import os
import pathlib
import tempfile
import unittest

from slam_launch import launch_checks
from slam_launch.errors import ProductError

DEFAULTS = dict.fromkeys(
    ("product", "backend", "odometry", "map", "detector", "pointmap", "load_map", "bag", "seed",
     "output_dir", "save_on_exit", "publish_tf", "set", "frontend_machine", "backend_machine",
     "env_loader", "only"), "")
DEFAULTS.update(composition="pubsub", mode="slam", rate="1", camera_transport="auto")


class LaunchChecks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.parts = pathlib.Path(folder.name) / "parts.launch"

    def check(self, **given):
        return launch_checks.product_for({**DEFAULTS, "parts": str(self.parts), **given})

    def expect_refusal(self, sentence, **given):
        with self.assertRaises(ProductError) as caught:
            self.check(**given)
        self.assertIn(sentence, str(caught.exception))
        self.assertFalse(self.parts.exists())

    def test_the_defaults_make_a_product_and_a_list_of_its_parts(self):
        self.assertEqual(self.check()["product"], "ekf_wheel")
        self.assertIn("slam_backend_ekf", self.parts.read_text(encoding="utf-8"))

    def test_refuses_a_value_that_is_not_among_those_there_are(self):
        self.expect_refusal("publish_tf:=ja is not one of: true, false", publish_tf="ja")
        self.expect_refusal("composition:=inproces is not one of: pubsub, inprocess (did you mean "
                            "'inprocess'?)", composition="inproces")
        self.expect_refusal("rate:=nan is not a number >= 0", rate="nan")

    def test_a_path_is_seen_from_where_roslaunch_is_called(self):
        self.check(output_dir="runs/first", save_on_exit="/maps")
        parts = self.parts.read_text(encoding="utf-8")
        self.assertIn(f'"output_dir" value="{os.getcwd()}/runs/first"', parts)
        self.assertIn('"save_on_exit" value="/maps"', parts)
        self.check(output_dir="runs/first", backend_machine="192.0.2.2")
        self.assertNotIn("runs/first", self.parts.read_text(encoding="utf-8"))

    def test_refuses_what_sets_no_parameter(self):
        for word in ("ekf.gate_probability", ".mode=slam", "ekf.gate_probability=", "x"):
            self.expect_refusal(f"'{word}' is set, which is not [SECTION.]KEY=VALUE",
                                set=f"ekf.mode=slam {word}")
        self.check(set="ekf.gate_probability=0.9 frames.map=world source_timeout=20")

    def test_a_feature_is_an_argument_of_its_own(self):
        for word in ("backend=pf", "odometry=visual", "map=grid", "pointmap=true", "detector=none"):
            self.expect_refusal(f"set:={word} is a feature, not a parameter: give "
                                f"{word.replace('=', ':=')}", set=f"ekf.mode=slam {word}")

    def test_refuses_what_is_set_twice(self):
        self.expect_refusal("ekf.gate_probability is set twice, to 0.9 and to 0.8; set it once",
                            set="ekf.gate_probability=0.9 seed=2 ekf.gate_probability=0.8")

    def test_localization_needs_a_map_however_it_is_asked_for(self):
        sentence = "localization keeps a map fixed and needs one: load_map:=FILE"
        self.expect_refusal(f"mode:={sentence}", mode="localization")
        self.expect_refusal(f"set:=ekf.mode={sentence}", set="ekf.mode=localization")
        self.check(set="ekf.mode=localization", load_map=os.getcwd())

    def robot(self, content, **given):
        path = self.parts.parent / "robot.yaml"
        path.write_text(f"version: 1\nrobot: mine\n{content}\n", encoding="utf-8")
        return launch_checks.robot_for({**DEFAULTS, "robot": str(path), **given}), path

    def test_a_robot_may_have_what_the_product_does_not_use(self):
        content, _ = self.robot("fiducial: {marker_sizes: {5: 0.2}}")
        self.assertEqual(content["fiducial"], {"marker_sizes": {"5": 0.2}})

    def test_refuses_a_robot_that_no_component_could_read_and_names_the_line(self):
        path = self.parts.parent / "robot.yaml"
        for content, sentence in (
                ("wheel_odometry: {alpha1: lots}",
                 f"wheel_odometry.alpha1 in {path}:3: 'lots' is not of type number"),
                ("wheel_odometry:\n  alpah1: 1",
                 f"wheel_odometry.alpah1 in {path}:4: unknown (did you mean 'alpha1'?)"),
                ("wheel_odometry: {alpha1: -1}", "-1 is not allowed; the range is >= 0"),
                ("weel_odometry: {alpha1: 1}", f"section weel_odometry in {path}:3 belongs to no"),
                ("ekf: {mode: slam}", f"ekf.mode in {path}:3: belongs in the product file")):
            with self.subTest(content), self.assertRaises(ProductError) as caught:
                self.robot(content)
            self.assertIn(sentence, str(caught.exception))

    def test_refuses_parameters_that_no_component_reads(self):
        self.expect_refusal("override ekf.gate_probabilty: unknown (did you mean "
                            "'gate_probability'?)", set="ekf.gate_probabilty=0.9")
        self.expect_refusal("override pf.particles: 0 is not allowed; the range is [1, 100000]",
                            backend="pf", pointmap="true", set="pf.particles=0")
        path = self.parts.parent / "mine.yaml"
        path.write_text("version: 1\nbackend: ekf\nodometry: wheel\nekf: {mod: slam}\n",
                        encoding="utf-8")
        self.expect_refusal(f"ekf.mod in {path}:4: unknown (did you mean 'mode'?)",
                            product=str(path))


if __name__ == "__main__":
    unittest.main()
