# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The arguments of slam.launch before anything is started."""

import os
import pathlib
import tempfile
import unittest
from unittest import mock
import xml.etree.ElementTree as ElementTree

from slam_launch import launch_checks, launch_parameters, ports
from slam_launch.errors import ProductError
import yaml

DEFAULTS = dict.fromkeys(
    ("product", "load_map", "load_session", "bag", "remap", "output_dir", "save_on_exit",
     "checkpoints", "publish_tf", "set", "frontend_machine", "backend_machine", "env_loader", "only",
     *launch_parameters.OVERRIDING), "")
DEFAULTS.update(composition="pubsub", mode="slam", rate="1", camera_transport="auto",
                autosave="10", resume="false", rviz="false", robot="sim_segway")


class LaunchChecks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.parts = pathlib.Path(folder.name) / "parts.launch"

    def check(self, **given):
        return launch_parameters.prepare({**DEFAULTS, "parts": str(self.parts), **given})

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
        for limit in ("-0.1", "nan", "slow"):
            self.expect_refusal(f"jump_limit:={limit} is not a number >= 0", jump_limit=limit)

    def test_the_transform_of_the_odometry_is_its_sources_but_for_that_of_a_driver(self):
        for given, published in (({}, "false"), ({"odometry": "wheel_imu"}, "false"),
                                 ({"odometry": "visual"}, "true"),
                                 ({"odometry": "visual_wheel"}, "true"),
                                 ({"odometry": "visual", "publish_tf": "false"}, "false"),
                                 ({"publish_tf": "true"}, "true")):
            with self.subTest(given):
                self.check(**given)
                self.assertIn(f'"publish_tf" value="{published}"',
                              self.parts.read_text(encoding="utf-8"))
        self.check(bag=__file__, robot="sim_segway")  # of which its own transform is left out
        self.assertIn('"publish_tf" value="true"', self.parts.read_text(encoding="utf-8"))

    def test_rviz_is_only_needed_where_it_is_to_be_shown(self):
        bare = str(self.parts.parent)  # beside Debian's packages nothing is there
        with mock.patch.dict(os.environ, ROS_PACKAGE_PATH=bare):
            self.expect_refusal("rviz:=true needs the package slam_rviz, which is not installed: "
                                "install it", rviz="true")
        self.check(rviz="true")
        self.assertIn("slam_launch/sim_segway", self.parameter("robot_description"))

    def test_refuses_components_that_cannot_be_joined(self):
        sentence = "two components make 'motion'; leave one of them out"
        with mock.patch.object(ports, "require_joined", side_effect=ProductError(sentence)):
            self.expect_refusal(sentence)

    def test_a_path_is_seen_from_where_roslaunch_is_called(self):
        self.check(output_dir="runs/first", save_on_exit="/maps")
        parts = self.parts.read_text(encoding="utf-8")
        self.assertIn(f'"output_dir" value="{os.getcwd()}/runs/first"', parts)
        self.assertIn('"save_on_exit" value="/maps"', parts)
        self.check(output_dir="runs/first", backend_machine="192.0.2.2")
        self.assertNotIn("runs/first", self.parts.read_text(encoding="utf-8"))

    def test_a_uri_carries_what_roslaunch_cannot(self):
        folder = self.parts.parent / "it's \"a\" := <place> & 100% ö"
        folder.mkdir()
        bag = folder / "a b.bag"
        bag.write_bytes(b"")
        given = {"bag": bag.as_uri(), "output_dir": folder.as_uri()}
        self.check(**launch_checks.with_plain_paths({**DEFAULTS, **given}))
        tree = ElementTree.parse(self.parts)
        values = {entry.get("name"): entry.get("value") for entry in tree.iter("arg")}
        self.assertEqual((values["bag"], values["output_dir"]), (str(bag), str(folder)))
        with self.assertRaisesRegex(ProductError, "roslaunch takes a '\\$\\('"):
            launch_checks.with_plain_paths({"bag": "file:///a%24(b)"})
        self.assertEqual(launch_checks.with_plain_paths({"bag": "a%20b", "set": "file://x"}),
                         {"bag": "a%20b", "set": "file://x"})

    def test_refuses_pipes_and_devices(self):
        pipe = str(self.parts.parent / "pipe.yaml")
        os.mkfifo(pipe)
        for key in ("bag", "load_map", "product", "robot"):
            self.expect_refusal("pipe.yaml is a folder, a pipe or a device", **{key: pipe})
        self.expect_refusal("bag:=/dev/zero is a folder, a pipe or a device", bag="/dev/zero")
        self.expect_refusal("there is no such file", bag="/nowhere/x.bag")

    def test_refuses_yaml_out_of_all_bounds(self):
        bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n" + "".join(
            f"a{i}: &a{i} [{', '.join([f'*a{i - 1}'] * 10)}]\n" for i in range(1, 30))
        for content, sentence in ((bomb, "more than 200000 values"),
                                  ("ekf: &a {b: *a}", "stands within what it refers to"),
                                  ("ekf: " + "[" * 5000 + "]" * 5000, "more than 32 deep")):
            with self.assertRaises(ProductError) as caught:
                self.robot(content)
            self.assertIn(sentence, str(caught.exception))
            self.assertIn("robot.yaml", str(caught.exception))
        content = self.robot("fiducial: {marker_sizes: &s {5: 0.2}}\n# an alias: *s")
        self.assertEqual(content["fiducial"], {"marker_sizes": {"5": 0.2}})

    def test_refuses_a_damaged_bag_of_which_it_wants_to_know_the_robot(self):
        bag = self.parts.parent / "x.bag"
        bag.write_bytes(b"#ROSBAG V2.0\n" + bytes(range(256)) * 40)
        self.expect_refusal(f"cannot read the bag {bag}", robot="", bag=str(bag))

    def test_refuses_what_sets_no_parameter(self):
        for word in ("ekf.gate_probability", ".mode=slam", "ekf.gate_probability=", "x"):
            self.expect_refusal(f"'{word}' is set, which is not [SECTION.]KEY=VALUE",
                                set=f"ekf.mode=slam {word}")
        self.check(set="ekf.gate_probability=0.9 frames.map=world source_timeout=20")

    def test_arguments_count_instead_of_the_files_values(self):
        self.check(odom_topic="/odom it's", seed="3", set="ekf.gate_probability=0.9")
        self.assertEqual(self.parameter("overrides"),
                         ["seed=3", "topics.odom=/odom it's", "ekf.gate_probability=0.9"])
        self.check()
        self.assertEqual(self.parameter("overrides"), [])

    def test_a_bags_topics_may_have_other_names(self):
        self.check(bag=__file__, remap="scan=/front/scan, odom=/wheels")
        values = {entry.get("name"): entry.get("value")
                  for entry in ElementTree.parse(self.parts).iter("arg")}
        self.assertEqual(yaml.safe_load(values["remaps"]), ["scan:=/front/scan", "odom:=/wheels"])

    def test_a_feature_is_an_argument_of_its_own(self):
        for word in ("backend=pf", "odometry=visual", "map=grid", "pointmap=true", "detector=none"):
            self.expect_refusal(f"set:={word} is a feature, not a parameter: give "
                                f"{word.replace('=', ':=')}", set=f"ekf.mode=slam {word}")

    def test_refuses_what_is_set_twice(self):
        self.expect_refusal("ekf.gate_probability is set twice, to 0.9 and to 0.8; set it once",
                            set="ekf.gate_probability=0.9 seed=2 ekf.gate_probability=0.8")
        self.expect_refusal("seed is set twice, to 3 and to 4; set it once", seed="3", set="seed=4")

    def test_localization_needs_a_map_however_it_is_asked_for(self):
        sentence = "localization keeps a map fixed and needs one: load_map:=FILE"
        self.expect_refusal(f"mode:={sentence}", mode="localization")
        self.expect_refusal(f"set:=ekf.mode={sentence}", set="ekf.mode=localization")
        self.check(set="ekf.mode=localization", load_map=os.getcwd())
        self.check(backend="graph", mode="localization", load_session=__file__)

    def test_checkpoints_have_a_folder_an_interval_and_a_choice(self):
        def asked(checkpoints, autosave="10", resume="false"):
            return launch_checks.checkpoints_for(
                {"checkpoints": checkpoints, "autosave": autosave, "resume": resume})
        self.assertEqual(asked(""), {"folder": "", "autosave": 10.0, "resume": False})
        self.assertEqual(asked("here", "2.5", "True"),
                         {"folder": os.path.abspath("here"), "autosave": 2.5, "resume": True})
        for sentence, arguments in (("checkpoints:=DIR", ("", "10", "true")),
                                    ("resume:=maybe", ("here", "10", "maybe")),
                                    ("autosave:=0 is not", ("here", "0")),
                                    ("autosave:=nan is not", ("here", "nan"))):
            with self.assertRaisesRegex(ProductError, sentence):
                asked(*arguments)

    def test_nodes_are_started_again_where_they_have_a_checkpoint_to_go_on_from(self):
        self.assertFalse(launch_checks.is_kept_alive({"bag": ""}))
        self.assertFalse(launch_checks.is_kept_alive({"bag": "", "checkpoints": ""}))
        self.assertTrue(launch_checks.is_kept_alive({"bag": "", "checkpoints": "D"}))
        self.assertFalse(launch_checks.is_kept_alive({"bag": "x.bag", "checkpoints": "D"}))

    def test_a_session_goes_without_a_map_and_to_a_backend_that_keeps_one(self):
        self.expect_refusal("give load_map:= or load_session:=, not both", backend="graph",
                            load_map=__file__, load_session=__file__)
        self.expect_refusal("load_session:=/no/such: there is no such file", backend="graph",
                            load_session="/no/such")
        self.expect_refusal("the back-end ekf keeps no session: leave out load_session:=",
                            load_session=__file__)
        self.check(backend="graph", load_session=__file__)
        self.assertIn("load_session", self.parts.read_text(encoding="utf-8"))

    def robot(self, content, **given):
        """Returns the parameter for a robot file that holds this."""
        path = self.parts.parent / "robot.yaml"
        path.write_text(f"version: 1\nrobot: mine\n{content}\n", encoding="utf-8")
        self.check(robot=str(path), **given)
        return self.parameter("robot")

    def parameter(self, name):
        """Returns the parameter that the launch file of the last check sets."""
        tags = ElementTree.parse(self.parts).iter("param")
        file = next(tag.get("textfile") for tag in tags if tag.get("name") == name)
        return yaml.safe_load(pathlib.Path(file).read_text(encoding="utf-8"))

    def test_a_robot_may_have_what_the_product_does_not_use(self):
        content = self.robot("fiducial: {marker_sizes: {5: 0.2}}")
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
