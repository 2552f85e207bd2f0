# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the feature model allows and what it says of the rest."""

import pathlib
import tempfile
import unittest

from slam_launch import packages
from slam_launch.errors import ProductError
from slam_launch.feature_model import FeatureModel, text
from small_model import EXTENSION, KCONFIG, small_model


class SmallModel(unittest.TestCase):
    def setUp(self):
        self.model = small_model(KCONFIG)

    def refusal(self, **features):
        with self.assertRaises(ProductError) as caught:
            self.model.require_valid(features)
        return str(caught.exception)

    def test_has_a_group_for_each_choice_and_each_module(self):
        self.assertEqual(sorted(self.model.groups), ["camera", "filter", "laser", "map"])
        self.assertEqual(list(self.model.groups["filter"].symbols), ["gauss", "cloud"])
        self.assertIsNone(self.model.groups["filter"].default)
        self.assertEqual(self.model.groups["map"].default, "points")

    def test_names_the_nearest_feature_for_one_that_does_not_exist(self):
        self.assertIn("there is no feature 'flter' (did you mean 'filter'?)",
                      self.refusal(flter="gauss"))
        self.assertIn("(did you mean 'cloud'?)", self.refusal(filter="clod", camera="true"))

    def test_names_a_mandatory_feature_that_is_missing(self):
        self.assertIn("a product needs filter (one of: gauss, cloud), which is not given",
                      self.refusal(camera="true"))

    def test_takes_one_of_a_choice_only(self):
        self.assertIn("filter is gauss and cloud; a product has exactly one of: gauss, cloud",
                      self.refusal(filter=["gauss", "cloud"], camera="true"))

    def test_takes_the_default_where_there_is_one(self):
        self.assertEqual(self.model.require_valid({"filter": "gauss", "camera": "true"}),
                         {"filter": "gauss", "map": "points", "camera": "true", "laser": "false"})

    def test_says_why_features_do_not_go_together_and_what_comes_nearest(self):
        said = self.refusal(filter="gauss", map="cells", camera="true")
        self.assertIn("filter=gauss map=cells camera=true makes no product: Cells need samples.",
                      said)
        self.assertIn("filter=gauss map=points camera=true", said)
        self.assertIn("filter=cloud map=cells camera=true", said)

    def test_wants_some_of_a_group(self):
        self.assertIn("makes no product: Something has to be seen.", self.refusal(filter="gauss"))
        for sensors in ({"camera": "true"}, {"laser": "true"},
                        {"camera": "true", "laser": "true"}):
            self.model.require_valid({"filter": "gauss", **sensors})

    def test_enumerates_what_brute_force_finds(self):
        expected = {(f, m, c, l) for f in ("gauss", "cloud") for m in ("points", "cells")
                    for c in ("true", "false") for l in ("true", "false")
                    if not (f == "gauss" and m == "cells") and "true" in (c, l)}
        found = [tuple(p[key] for key in ("filter", "map", "camera", "laser"))
                 for p in self.model.valid()]
        self.assertEqual(len(found), 9)
        self.assertEqual(set(found), expected)

    def test_tells_whose_parameters_a_section_holds(self):
        features = {"filter": "gauss", "map": "points", "camera": "true", "laser": "false"}
        self.assertEqual(self.model.needed_by("cloud", features), "filter=cloud")
        self.assertIsNone(self.model.needed_by("cloud", {**features, "filter": "cloud"}))
        self.assertIsNone(self.model.needed_by("unknown", features))

    def test_tells_what_the_features_bring(self):
        features = {"filter": "gauss", "map": "points", "camera": "true", "laser": "false"}
        self.assertEqual(self.model.strings("LAUNCH_", features), ["gauss/gauss.launch"])
        self.assertEqual(self.model.strings("LAUNCH_", {**features, "filter": "cloud"}), [])


OTHERS = """
choice BACKEND
config BACKEND_MINE
	bool "mine"
endchoice
choice ODOMETRY
config ODOMETRY_SONAR
	bool "sonar"
endchoice
config LAUNCH_MINE
	string
	default "mine/backend.launch" if BACKEND_MINE
config LAUNCH_SONAR
	string
	depends on ODOMETRY_SONAR
	default "sonar/sonar.launch"
"""


class Halves(unittest.TestCase):
    """Which machine a launch file goes to."""

    def setUp(self):
        self.model = FeatureModel()

    def files(self, **given):
        return self.model.launch_files(self.model.require_valid(given))

    def test_what_features_of_the_front_end_launch_is_front_end(self):
        files = self.files(backend="pf", odometry="visual", pointmap="true")
        self.assertEqual(files["frontend"], ["slam_visual_odometry/launch/odometry.launch",
                                             "slam_frontend/launch/detector.launch"])
        self.assertEqual(files["backend"], ["slam_backend_pf/launch/backend.launch",
                                            "slam_pointmap/launch/pointmap.launch"])

    def test_so_it_is_with_a_package_that_opens_a_choice_again(self):
        with tempfile.TemporaryDirectory() as folder:
            other = pathlib.Path(folder) / "Kconfig"
            other.write_text(OTHERS, encoding="ascii")
            model = FeatureModel([packages.share() / "features" / "Kconfig", other])
        files = model.launch_files(model.require_valid({"backend": "mine", "odometry": "sonar"}))
        self.assertIn("sonar/sonar.launch", files["frontend"])
        self.assertEqual(files["backend"], ["mine/backend.launch"])


class ExtendedModel(unittest.TestCase):
    def test_takes_a_feature_from_another_file(self):
        model = small_model(KCONFIG, EXTENSION)
        self.assertEqual(list(model.groups["filter"].symbols), ["gauss", "cloud", "grid"])
        features = model.require_valid({"filter": "grid", "map": "cells", "laser": "true"})
        self.assertEqual(model.strings("LIBRARY_", features), ["libgrid.so"])

    def test_names_the_place_of_a_fault_in_a_file(self):
        with self.assertRaisesRegex(ProductError, r"\[1\] Kconfig:3"):
            small_model(KCONFIG, "choice FILTER\nconfig FILTER_X\n\tmandatory\nendchoice\n")
        with self.assertRaisesRegex(ProductError, "X .*has to begin with FILTER_"):
            small_model(KCONFIG, "choice FILTER\nconfig X\n\tbool \"x\"\nendchoice\n")


class ShippedModel(unittest.TestCase):
    def setUp(self):
        self.model = FeatureModel()

    def test_every_dependency_of_a_feature_says_why(self):
        for group in self.model.groups.values():
            for name in group.symbols.values():
                for node in self.model.kconfig.syms[name].nodes:
                    if node.dep is not self.model.kconfig.y:
                        lacks = [s.name for s in dependencies(node) if not explained(s)]
                        self.assertEqual(lacks, [], f"{name} depends on these without a sentence")

    def test_every_forbidden_pair_has_a_sentence_and_a_nearest_product(self):
        valid = self.model.valid()
        for pair in pairs(self.model):
            if any(pair.items() <= features.items() for features in valid):
                continue
            rest = {key: value for key, value in valid[0].items() if key not in pair}
            with self.subTest(text(pair)), self.assertRaises(ProductError) as caught:
                self.model.require_valid({**rest, **pair})
            self.assertRegex(str(caught.exception), r"makes no product: \w+ \w+ .*nearest valid")

    def test_a_product_may_have_no_odometry_of_its_own(self):
        features = self.model.require_valid({"backend": "ekf", "odometry": "none"})
        self.assertEqual(self.model.launch_files(features)["frontend"],
                         ["slam_frontend/launch/detector.launch"])
        self.assertEqual(self.model.needed_by("wheel_odometry", features),
                         "odometry=wheel or odometry=wheel_imu or odometry=visual_wheel or "
                         "odometry=laser_wheel")

    def test_the_grid_back_end_maps_no_landmarks(self):
        sentence = ("makes no product: The grid back-end maps what a laser sees and no landmarks, "
                    "so that it goes with map=grid, detector=none and association=known_ids.")
        alone = {"backend": "grid", "odometry": "wheel", "map": "grid", "detector": "none"}
        for change in ({"map": "landmarks"}, {"detector": "apriltag"}, {"detector": "aruco"},
                       {"association": "nearest"}, {"association": "jcbb"},
                       {"association": "descriptor"}):
            with self.subTest(text(change)), self.assertRaises(ProductError) as caught:
                self.model.require_valid({**alone, **change})
            self.assertIn(sentence, str(caught.exception))
        self.assertIn("backend=grid odometry=wheel detector=none association=known_ids "
                      "map=grid", str(caught.exception))

    def test_association_by_descriptors_needs_a_detector_that_tells_them(self):
        chosen = {"backend": "ekf", "odometry": "wheel", "association": "descriptor"}
        for backend in ("ekf", "pf", "graph", "seif"):
            for detector in ("ceiling_features", "laser_trunks", "none"):
                self.model.require_valid({**chosen, "backend": backend, "detector": detector})
        for detector in ("apriltag", "aruco", "laser_reflectors", "laser_corners", "laser_lines"):
            with self.subTest(detector), self.assertRaises(ProductError) as caught:
                self.model.require_valid({**chosen, "detector": detector})
            self.assertIn("needs a detector that tells them, so that association=descriptor goes "
                          "with detector=laser_trunks", str(caught.exception))

    def test_the_grid_back_end_goes_with_any_odometry_and_with_none(self):
        for odometry in self.model.groups["odometry"].symbols:
            features = self.model.require_valid({"backend": "grid", "odometry": odometry,
                                                 "map": "grid", "detector": "none"})
            self.assertEqual(self.model.launch_files(features)["backend"],
                             ["slam_backend_grid/launch/backend.launch"])
            self.assertIsNone(self.model.needed_by("scan_to_map", features))
            self.assertEqual(self.model.needed_by("pf", features), "backend=pf")

    def test_ratslam_goes_with_any_odometry_and_without_detectors_and_associations(self):
        chosen = {"backend": "rat", "odometry": "wheel", "map": "landmarks", "detector": "none"}
        for odometry in self.model.groups["odometry"].symbols:
            features = self.model.require_valid({**chosen, "odometry": odometry})
            self.assertEqual(self.model.launch_files(features)["backend"],
                             [f"slam_backend_rat/launch/{name}.launch"
                              for name in ("local_view", "pose_cells", "backend")])
        for wrong in ({"detector": "apriltag"}, {"association": "jcbb"}):
            with self.subTest(wrong), self.assertRaises(ProductError) as caught:
                self.model.require_valid({**chosen, **wrong})
            self.assertIn("maps no landmarks, so that backend=rat goes with detector=none",
                          str(caught.exception))
        with self.assertRaises(ProductError):
            self.model.require_valid({**chosen, "map": "grid"})

    def test_the_monocular_ekf_finds_its_corners_itself(self):
        chosen = {"backend": "mono_ekf", "odometry": "wheel", "map": "landmarks", "detector": "none"}
        features = self.model.require_valid(chosen)
        self.assertEqual(self.model.launch_files(features)["backend"],
                         ["slam_backend_mono_ekf/launch/backend.launch"])
        for wrong in ({"detector": "apriltag"}, {"association": "jcbb"}):
            with self.subTest(wrong), self.assertRaises(ProductError) as caught:
                self.model.require_valid({**chosen, **wrong})
            self.assertIn("so that backend=mono_ekf goes with detector=none", str(caught.exception))
        with self.assertRaises(ProductError):
            self.model.require_valid({**chosen, "map": "grid"})

    def test_keyframes_of_a_camera_go_with_any_odometry_and_without_detectors_and_associations(self):
        chosen = {"backend": "mono_graph", "odometry": "wheel", "map": "landmarks",
                  "detector": "none"}
        features = self.model.require_valid(chosen)
        self.assertEqual(self.model.launch_files(features)["backend"],
                         ["slam_backend_mono_graph/launch/backend.launch"])
        for wrong in ({"detector": "apriltag"}, {"association": "jcbb"}):
            with self.subTest(wrong), self.assertRaises(ProductError) as caught:
                self.model.require_valid({**chosen, **wrong})
            self.assertIn("maps no landmarks, so that backend=mono_graph goes with detector=none",
                          str(caught.exception))
        with self.assertRaises(ProductError):
            self.model.require_valid({**chosen, "map": "grid"})

    def test_the_matcher_of_scans_belongs_to_grids_whichever_back_end_makes_them(self):
        features = self.model.require_valid({"backend": "pf", "odometry": "wheel", "map": "grid",
                                             "detector": "none"})
        self.assertIsNone(self.model.needed_by("scan_to_map", features))
        features = self.model.require_valid({"backend": "pf", "odometry": "wheel"})
        self.assertEqual(self.model.needed_by("scan_to_map", features),
                             "map=grid or odometry=laser or odometry=laser_wheel or "
                             "odometry=laser_imu")

    def test_back_ends_and_odometry_are_mandatory(self):
        self.assertEqual([key for key, group in self.model.groups.items()
                          if group.default is None], ["backend", "odometry"])


def dependencies(node):
    import kconfiglib
    symbols = kconfiglib.expr_items(node.dep)
    return [s for s in symbols if isinstance(s, kconfiglib.Symbol) and not s.is_constant]


def explained(symbol):
    return any(node.help for node in symbol.nodes)


def pairs(model):
    features = [(key, value) for key, group in model.groups.items() for value in group.symbols]
    return [dict([one, other]) for one in features for other in features if one[0] < other[0]]


if __name__ == "__main__":
    unittest.main()
