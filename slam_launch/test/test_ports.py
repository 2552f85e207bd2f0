# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What components say of their inputs and outputs, and products that cannot be wired."""

import dataclasses
import pathlib
import tempfile
import unittest

from slam_launch import ports, ports_diagram, products
from slam_launch.covering import covering
from slam_launch.errors import ProductError
from slam_launch.feature_model import FeatureModel, text

TOGETHER = 3  # features whose combinations are all tried


class Ports(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.model = FeatureModel()

    def of(self, name):
        return ports.of_product(products.find(name, self.model))


class Told(Ports):
    def test_every_kind_of_product_is_joined(self):
        kinds = covering(list(self.model.valid()), TOGETHER)
        told = ports.of_products([products.without_file(features, self.model)
                                  for features in kinds])
        for features, each in zip(kinds, told):
            self.assertTrue(each.components, text(features))

    def test_components_come_in_the_order_of_the_flow(self):
        self.assertEqual([part.key for part in self.of("ekf_wheel_pointmap").components],
                         ["odometry", "detector", "backend", "pointmap"])

    def test_an_input_has_its_topic_its_kind_its_time_and_its_maker(self):
        backend = next(part for part in self.of("pf_wheel_grid").components
                       if part.key == "backend")
        told = {port.name: (port.kind, port.time, port.is_mandatory, port.made_by, port.gate)
                for port in backend.inputs}
        self.assertEqual(told, {
            "motion": ("slam::Motion", "carrier", True, "odometry", None),
            "observations": ("slam::LandmarkObservationArray", "trigger", False, None, None),
            "scan": ("slam::LaserScan", "trigger", True, None, "laser")})

    def test_a_camera_comes_with_its_calibration_and_its_mount(self):
        told = self.of("pf_visual")
        self.assertEqual([(port.topic, port.time, port.gate) for port in told.components[0].inputs],
                         [("ceiling_camera/image_raw", "trigger", "ceiling_camera")])
        gate = next(gate for gate in told.gates if gate.name == "ceiling_camera")
        self.assertEqual([(port.topic, port.time) for port in gate.inputs],
                         [("ceiling_camera/image_raw", "trigger"),
                          ("ceiling_camera/camera_info", "latched"), ("tf_static", "latched")])

    def test_each_sensor_has_its_gate_once(self):
        for name, sensors in (("ekf_wheel", ["camera"]), ("pf_wheel_grid", ["laser"]),
                              ("ekf_visual_wheel", ["ceiling_camera", "camera"]),
                              ("ekf_wheel_imu", ["imu", "camera"]),
                              ("ekf_wheel_pointmap", ["camera", "laser"])):
            self.assertEqual([gate.name for gate in self.of(name).gates], sensors, name)

    def test_the_scans_of_two_lasers_reach_a_map_through_one_gate_with_motion(self):
        one = products.find("scan_grid_wheel", self.model)
        told = ports.of_product(products.without_file({**one.features, "rear_laser": "true"},
                                                      self.model))
        backend = told.components[-1]
        scans = next(port for port in backend.inputs if port.gate == "joined_scan")
        self.assertEqual([(port.name, port.topic, port.made_by, port.gate)
                          for port in ports.before_gates(scans, told)],
                         [("scan", "scan", None, "laser"),
                          ("rear_scan", "rear_scan", None, "rear_scan"),
                          ("motion", "motion", "odometry", None)])

    def test_motion_is_a_hint_of_an_odometry_source_or_is_not_taken_in(self):
        alone = products.find("scan_grid", self.model)
        wheels = products.without_file({**alone.features, "odometry": "wheel"}, self.model)
        for product, expected in ((alone, {"scan": (True, None)}),
                                  (wheels, {"scan": (True, None), "motion": (False, "odometry")})):
            backend = ports.of_product(product).components[-1]
            self.assertEqual({port.name: (port.is_mandatory, port.made_by)
                              for port in backend.inputs}, expected)

    def test_the_transform_of_the_odometry_follows_from_what_its_source_takes_in(self):
        for name, owns in (("ekf_wheel", False), ("ekf_wheel_imu", False), ("pf_visual", True),
                           ("pf_visual_wheel", True)):
            self.assertEqual(self.of(name).owns_odometry_edge, owns, name)


class Refused(Ports):
    def test_is_a_product_whose_library_is_missing(self):
        product = products.find("ekf_wheel", self.model)
        content = {**product.content, "libraries": ["libslam_nowhere.so"]}
        product = dataclasses.replace(product, content=content)
        for ask in (ports.require_joined, ports.of_product):
            with self.assertRaises(ProductError) as caught:
                ask(product)
            self.assertIn("cannot load the product's library libslam_nowhere.so",
                          str(caught.exception))
            self.assertNotIn("\n", str(caught.exception))


class Diagram(Ports):
    def test_shows_each_port_with_its_kind_and_time_and_joins_it_with_its_maker(self):
        drawn = ports_diagram.dot(self.of("pf_wheel_grid"))
        for shown in ("slam::OdometrySample", "slam::LaserMount", "observations [0..1]",
                      f"{ports_diagram.TIMES['carrier']} motion", "particlecloud"):
            self.assertIn(shown, drawn)
        self.assertIn('"odometry source wheel":out0:e -> "back-end pf":in0:w', drawn)
        self.assertIn('"gate laser":out0:e -> "back-end pf":in2:w', drawn)
        self.assertIn('"topic tf_static":e -> "gate laser":in1:w', drawn)
        self.assertNotIn('"topic motion"', drawn)

    def test_is_a_small_picture(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "ports.svg"
            ports_diagram.draw(products.find("pf_wheel_grid", self.model), path)
            self.assertIn("slam::Motion", path.read_text(encoding="utf-8"))
            self.assertLess(path.stat().st_size, 30000)


if __name__ == "__main__":
    unittest.main()
