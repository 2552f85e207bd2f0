# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Component diagrams: what they show of the products there are, and what cannot be drawn."""

import os
import pathlib
import subprocess
import tempfile
import unittest
from unittest import mock

from slam_launch import diagram, packages, products
from slam_launch.covering import covering
from slam_launch.errors import ProductError
from slam_launch.feature_model import FeatureModel, text
from slam_launch.thesis_products import EXPERIMENTS, product_of

TOGETHER = 2  # features whose combinations are all tried; three: test_ports


class Diagrams(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.model = FeatureModel()

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def parts(self, name):
        return diagram.components(products.find(name, self.model), self.model)

    def expect_refusal(self, sentence, call, *arguments):
        with self.assertRaises(ProductError) as caught:
            call(*arguments)
        self.assertIn(sentence, str(caught.exception))


class Components(Diagrams):
    def test_are_the_nodelets_of_the_launch_files(self):
        self.assertEqual({part.name: part.plugin for part in self.parts("ekf_wheel")},
                         {"wheel_odometry": "slam_frontend/WheelOdometry",
                          "fiducial_detector": "slam_frontend/FiducialDetector",
                          "slam_backend": "slam_backend_ekf/Ekf"})

    def test_have_stages_in_nodelets_of_their_own_beside_the_back_end(self):
        parts = {part.name: part for part in self.parts("rat_wheel")}
        self.assertEqual({name: part.plugin for name, part in parts.items()},
                         {"wheel_odometry": "slam_frontend/WheelOdometry",
                          "local_view": "slam_backend_rat/LocalView",
                          "pose_cells": "slam_backend_rat/PoseCells",
                          "slam_backend": "slam_backend_rat/Rat"})
        self.assertEqual(parts["local_view"].inputs, ("camera/image_raw",))
        self.assertEqual(set(parts["pose_cells"].inputs), {"motion", "local_view"})
        self.assertEqual(set(parts["slam_backend"].inputs), {"motion", "pose_cells"})
        self.assertEqual({part.group for name, part in parts.items() if name != "wheel_odometry"},
                         {"Back-end"})

    def test_have_a_source_for_each_input_in_every_kind_of_product(self):
        for features in covering(list(self.model.valid()), TOGETHER):
            with self.subTest(text(features)):
                product = products.without_file(features, self.model)
                parts = diagram.components(product, self.model)
                made = {topic for part in parts for topic in part.outputs}
                taken = {topic for part in parts for topic in part.inputs}
                self.assertLessEqual(taken, made | set(diagram.SENSORS))
                self.assertIn("pose", made)
                has_odometry = features["odometry"] != "none"
                self.assertEqual("motion" in made, has_odometry)
                scans_tell_motion = (features["backend"] == "grid" or
                                     features["backend"] == "graph" and features["map"] == "grid")
                self.assertEqual("motion" in taken, has_odometry or not scans_tell_motion)

    def test_follow_the_launch_file_that_another_one_includes(self):
        self.assertEqual(self.including("wheel.launch"),
                         ("wheel_odometry", "slam_frontend/WheelOdometry"))

    def including(self, file):
        (self.folder / "package.xml").write_text(
            '<package format="2"><name>around</name><version>0.1.0</version><description>d'
            '</description><maintainer email="a@b.c">m</maintainer><license>BSD</license>'
            "</package>", encoding="ascii")
        (self.folder / "a.launch").write_text(
            f'<launch><arg name="manager"/><include file="$(find slam_frontend)/launch/{file}" '
            'pass_all_args="true"/></launch>', encoding="ascii")
        paths = f"{self.folder}:{os.environ['ROS_PACKAGE_PATH']}"
        with mock.patch.dict(os.environ, {"ROS_PACKAGE_PATH": paths}):
            return diagram.nodelet("around/a.launch")

    def test_are_refused_where_the_model_names_what_is_not_there(self):
        self.expect_refusal("there is no package slam_nowhere", diagram.nodelet,
                            "slam_nowhere/a.launch")
        self.expect_refusal("slam_frontend/launch/none.launch", diagram.nodelet,
                            "slam_frontend/launch/none.launch")

    def test_are_refused_where_no_launch_file_starts_one(self):
        kconfig = (packages.share() / "features" / "Kconfig").read_text(encoding="utf-8")
        file = self.folder / "Kconfig"
        file.write_text(kconfig.replace("if ODOMETRY_WHEEL || ODOMETRY_WHEEL_IMU\n",
                                        "if BACKEND_NONE\n"),
                        encoding="utf-8")
        model = FeatureModel([file])
        self.expect_refusal("no LAUNCH_... starts the odometry source 'wheel', which odometry names",
                            diagram.components, products.find("ekf_wheel", model), model)

    def test_take_and_make_what_their_ports_say(self):
        parts = {part.name: part for part in self.parts("pf_wheel_grid")}
        self.assertEqual(parts["slam_backend"].inputs, ("motion", "observations", "scan"))
        self.assertEqual(parts["slam_backend"].outputs,
                         ("pose", "path", "landmarks", "particlecloud", "map"))
        parts = {part.name: part for part in self.parts("ekf_visual_wheel")}
        self.assertEqual(parts["visual_odometry"].inputs, ("ceiling_camera/image_raw", "odom"))
        self.assertEqual(parts["visual_odometry"].outputs, ("motion", "visual_odometry/odom"))
        self.assertEqual(parts["slam_backend"].outputs, ("pose", "path", "landmarks"))

    def test_that_no_part_stands_for_are_drawn_without_topics(self):
        launches = {"slam_pointmap/launch/pointmap.launch": {"backend"}}
        with mock.patch.object(self.model, "launches", lambda features: {
                **FeatureModel.launches(self.model, features), **launches}):
            parts = self.parts("ekf_wheel")
        self.assertEqual(parts[-1].name, "pointmap")
        self.assertEqual(parts[-1].inputs + parts[-1].outputs, ())


class Drawings(Diagrams):
    def test_colour_only_what_the_former_product_has_not(self):
        drawn = diagram.dot(self.parts("pf_visual"), self.parts("pf_wheel")).splitlines()
        coloured = [line.split('"')[1] for line in drawn
                    if diagram.NEW in line and "->" not in line]
        self.assertEqual(sorted(coloured), ["sensor ceiling_camera/image_raw", "visual_odometry"])
        arrows = [line for line in drawn if diagram.NEW in line and "->" in line]
        self.assertEqual(len(arrows), 3)
        self.assertNotIn(diagram.NEW, diagram.dot(self.parts("pf_visual")))

    def test_tell_a_component_that_has_another_interface(self):
        former = self.parts("pf_wheel")
        grid = products.find("pf_wheel_grid", self.model)
        swapped = products.swapped(grid, {**grid.features, "detector": "apriltag"})
        drawn = diagram.dot(diagram.components(swapped, self.model), former)
        self.assertRegex(drawn, f'"slam_backend" .*{diagram.NEW}')

    def test_show_one_nodelet_around_the_components_of_the_composition_in_one_process(self):
        parts = self.parts("pf_visual")
        drawn = diagram.dot(parts, (), diagram.coordinator_title())
        around = drawn.index('"cluster slam (slam_ros/Inprocess): the meta-coordinator')
        for group in ("Front-end", "Back-end"):
            self.assertLess(around, drawn.index(f'"cluster {group}"'))
        for part in parts:
            self.assertNotIn(part.plugin, drawn)
        dashed = [line for line in drawn.splitlines() if "style=dashed" in line]
        inside = {part.name for part in parts}
        self.assertEqual({tuple(line.split('"')[1:4:2]) for line in dashed},
                         {(start, end) for start, _, end in diagram.edges(parts)
                          if {start, end} <= inside})
        self.assertGreaterEqual(len(dashed), 2)
        self.assertNotIn("style=dashed", diagram.dot(parts))

    def test_of_both_compositions_have_the_same_components_and_data(self):
        for composition in ("pubsub", "inprocess"):
            path = self.folder / f"{composition}.svg"
            diagram.draw(products.find("ekf_wheel_pointmap", self.model), path, self.model, None,
                         composition)
            drawn = path.read_text(encoding="utf-8")
            for name in ("wheel_odometry", "slam_backend", "pointmap", "motion", "points", "laser"):
                self.assertIn(f">{name}<", drawn)
            self.assertEqual("slam_ros/Inprocess" in drawn, composition == "inprocess")

    def test_are_written_in_the_kind_that_the_name_tells(self):
        product = products.find("ekf_wheel_pointmap", self.model)
        for kind, begin in (("svg", b"<?xml"), ("png", b"\x89PNG"), ("dot", b"digraph")):
            path = self.folder / f"a.{kind}"
            diagram.draw(product, path, self.model)
            self.assertTrue(path.read_bytes().startswith(begin), kind)
        drawn = (self.folder / "a.svg").read_text(encoding="utf-8")
        for name in ("wheel_odometry", "slam_backend", "pointmap", "motion", "points", "laser"):
            self.assertIn(f">{name}<", drawn)

    def test_tell_why_there_is_none(self):
        product = products.find("ekf_wheel", self.model)
        self.expect_refusal("ends with none of: .svg, .png", diagram.draw, product,
                            self.folder / "a.gif", self.model)
        self.expect_refusal("cannot write", diagram.draw, product, self.folder / "no" / "a.svg",
                            self.model)
        run = subprocess.run

        def without_dot(command, **options):
            if command[0] == "dot":
                raise FileNotFoundError(2, "no", "dot")
            return run(command, **options)
        with mock.patch("subprocess.run", without_dot):
            self.expect_refusal("install graphviz", diagram.draw, product, self.folder / "a.svg",
                                self.model)


class Thesis(Diagrams):
    def test_every_figure_is_there_once(self):
        numbers = [number for experiment in EXPERIMENTS
                   for number in (experiment.diagram, *experiment.pictures)]
        self.assertEqual(numbers, ["6.1", "6.2a", "6.2b", "6.3", "6.4", "6.5", "6.6a", "6.6b",
                                   "6.7", "6.8", "6.9", "6.10"])

    def test_its_products_are_valid(self):
        for experiment in EXPERIMENTS:
            features = product_of(experiment, self.model).features
            self.assertEqual(self.model.faults(features), [], experiment.product)


if __name__ == "__main__":
    unittest.main()
