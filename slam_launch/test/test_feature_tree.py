# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The feature tree: that it says what the model and the components say, and how it is drawn."""

import pathlib
import subprocess
import tempfile
import unittest

import rospkg
from slam_launch import packages, parameters, ports, products, tree_diagram, tree_text
from slam_launch.errors import ProductError
from slam_launch.feature_model import FeatureModel
from slam_launch.feature_tree import (ABSENT, ALTERNATIVE, BRANCH, CHOSEN, EXCLUDED, FeatureTree,
                                      MANDATORY, nodes_of, OPTIONAL, OR)
from small_model import EXTENSION, KCONFIG, small_model

NO_COMPONENT = {"none"}  # a value of a choice that leaves a role without a component
SMALL = """
menu "Sensors"
config SEES
	bool
config LAMP
	bool "lamp"
	select SEES
comment "not offered: sonar: sonar: Nobody has built it"
endmenu
config BRANCH_FILTER_SAMPLES
	string
	default "samples, many" if FILTER_CLOUD
"""


class Tree(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.model = FeatureModel()
        cls.root = FeatureTree(cls.model).root()

    def instance(self, name):
        """Returns the nodes of a product's tree by their names."""
        root = FeatureTree(self.model, products.find(name, self.model)).root()
        return {node.name: node for node in nodes_of(root)}


class Whole(Tree):
    def test_has_each_feature_of_the_model_and_no_other(self):
        told = {node.name for node in nodes_of(self.root) if "=" in node.name and
                node.mark != ABSENT}
        self.assertEqual(told, {f"{key}={value}" for key, group in self.model.groups.items()
                                for value in group.symbols if value != "false"})

    def test_has_each_component_that_registers_itself_and_no_other(self):
        told = ports.components()
        for key in ("backend", "odometry", "detector", "association"):
            offered = {node.name.partition("=")[2] for node in nodes_of(self.root)
                       if node.name.startswith(f"{key}=") and node.mark != ABSENT}
            self.assertEqual(offered - NO_COMPONENT, set(told[key]), key)
        # a second detector is one of those; a second camera or laser is no component
        modules = {node.name.partition("=")[0] for node in nodes_of(self.root)
                   if node.name.endswith("=true")}
        self.assertEqual(modules - {"second_camera", "rear_laser"}, set(told["modules"]))

    def test_what_is_not_offered_is_in_no_component(self):
        told = ports.components()
        absent = [node for node in nodes_of(self.root) if node.mark == ABSENT]
        self.assertEqual({node.name for node in absent},
                         {"detector=visual_features",
                          "second_detector=laser_trunks", "scene_reconstruction"})
        for node in absent:
            key, _, value = node.name.partition("=")
            self.assertNotIn(value, told.get(key, []), node.name)
            self.assertNotIn(key, told["modules"])
            self.assertNotIn(key, self.model.groups if not value else [])
            self.assertTrue(node.notes[0])
            if "." in key:
                self.assert_no_choice(key, value)

    def assert_no_choice(self, parameter, value):
        try:
            self.assertNotIn(value, parameters.values_of(parameter)[0])
        except ProductError:
            pass  # there is no such parameter at all

    def test_has_the_values_that_a_components_parameter_has(self):
        node = next(node for node in nodes_of(self.root) if node.name == "ekf.linearization")
        self.assertEqual([child.title for child in node.children],
                         ["textbook", "first_estimates", "observability_constrained",
                          "right_invariant"])

    def test_refuses_a_parameter_that_is_no_choice(self):
        for name in ("ekf.gate_probability", "ekf.nothing", "nothing.at_all"):
            with self.assertRaises(ProductError) as caught:
                parameters.values_of(name)
            self.assertIn(f"{name} is no parameter with a choice", str(caught.exception))

    def test_what_runs_beside_products_is_a_launch_file(self):
        files = [node.name for node in nodes_of(self.root) if node.name.endswith(".launch")]
        self.assertIn("slam_labels/launch/labels.launch", files)
        for name in files:
            package, _, file = name.partition("/")
            self.assertTrue((pathlib.Path(rospkg.RosPack().get_path(package)) / file).exists(), name)

    def test_what_runs_beside_products_is_excluded_where_they_lack_what_it_needs(self):
        name = "slam_labels/launch/labels.launch"
        self.assertEqual(self.instance("ekf_wheel")[name].state, "")
        node = self.instance("scan_grid")[name]
        self.assertEqual(node.state, EXCLUDED)
        self.assertIn("no landmarks", node.notes[0])

    def test_the_active_path_goes_with_products_that_make_a_grid(self):
        name = "slam_active/launch/active.launch"
        self.assertEqual(self.instance("scan_grid")[name].state, "")
        self.assertEqual(self.instance("ekf_wheel")[name].state, EXCLUDED)

    def test_says_what_a_feature_needs(self):
        node = next(node for node in nodes_of(self.root) if node.name == "detector=laser_lines")
        self.assertTrue(any("goes with backend=ekf" in note for note in node.notes))

    def test_has_the_features_of_a_package_that_opens_a_choice_again(self):
        root = FeatureTree(small_model(KCONFIG, EXTENSION)).root()
        group = next(node for node in nodes_of(root) if node.name == "filter")
        self.assertEqual([child.name for child in group.children],
                         ["filter=gauss", "filter=cloud", "filter=grid"])


    def test_menus_of_one_title_are_one(self):
        menu = 'menu "More"\nconfig {0}\n\tbool "{0}"\nendmenu\n'
        root = FeatureTree(small_model(KCONFIG + menu.format("A"), menu.format("B"))).root()
        menus = [node for node in nodes_of(root) if node.title == "More"]
        self.assertEqual([[child.name for child in menu.children] for menu in menus],
                         [["a=true", "b=true"]])


class Marks(unittest.TestCase):
    def setUp(self):
        root = FeatureTree(small_model(KCONFIG + SMALL)).root()
        self.nodes = {}
        for node in nodes_of(root):
            self.nodes.setdefault(node.name or node.title, node)

    def test_follow_from_the_model(self):
        for name, mark in (("filter", MANDATORY), ("filter=gauss", ALTERNATIVE),
                           ("samples, many", BRANCH), ("laser=true", OPTIONAL),
                           ("lamp=true", OR), ("sonar", ABSENT)):
            self.assertEqual(self.nodes[name].mark, mark, name)

    def test_a_some_of_group_names_members_that_stand_elsewhere(self):
        members = [node.name for node in self.nodes["Sensors"].children if node.mark == OR]
        self.assertEqual(members, ["lamp=true", "camera=true", "laser=true"])

    def test_a_branch_holds_its_features(self):
        branch = self.nodes["samples, many"]
        self.assertEqual([child.name for child in branch.children], ["filter=cloud"])

    def test_a_comment_that_gives_no_reason_is_refused(self):
        for comment in ("not offered: sonar: sonar", "sonar: sonar: reason"):
            with self.assertRaises(ProductError) as caught:
                FeatureTree(small_model(f'comment "{comment}"\n')).root()
            self.assertIn("'not offered: FEATURE: TITLE: REASON'", str(caught.exception))


class Instance(Tree):
    def test_has_chosen_what_the_product_has(self):
        for product in products.named(self.model):
            chosen = {name for name, node in self.instance(product.name).items()
                      if node.state == CHOSEN and "=" in name}
            self.assertEqual(chosen, {f"{key}={value}" for key, value in product.features.items()
                                      if value != "false"}, product.name)

    def test_excludes_what_makes_no_product_with_the_rest(self):
        product = products.find("ekf_wheel", self.model)
        for name, node in self.instance("ekf_wheel").items():
            key, equals, value = name.partition("=")
            if not equals or node.mark == ABSENT or node.state == CHOSEN:
                continue
            faults = self.model.faults({**product.features, key: value})
            self.assertEqual((node.state == EXCLUDED, list(node.notes)), (bool(faults), faults))

    def test_has_the_product_files_value_of_a_parameter(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "mine.yaml"
            path.write_text("version: 1\nbackend: pf\nodometry: wheel\ndetector: apriltag\n"
                            "pf: {resampling: residual}\n", encoding="utf-8")
            node = self.instance(str(path))["pf.resampling"]
        self.assertEqual([child.title for child in node.children if child.state == CHOSEN],
                         ["residual"])

    def test_has_a_model_of_motion_and_one_of_measurement(self):
        for product in products.named(self.model):
            root = FeatureTree(self.model, product).root()
            for title in ("Motion", "Measurement"):
                menu = next(node for node in nodes_of(root) if node.title == title)
                self.assertTrue([child for child in menu.children
                                 if (child.mark, child.state) == (OR, CHOSEN)], product.name)


class Drawn(Tree):
    def test_each_reason_stands_once_below_the_tree(self):
        lines = tree_text.draw(self.root)
        self.assertEqual(lines[0], "● SLAM")
        self.assertEqual(sum("A product needs" in line for line in lines), 0)
        self.assertEqual(sum("Line landmarks need a back-end" in line for line in lines), 1)
        self.assertNotIn("[x]", "\n".join(lines))

    def test_a_product_has_marks_of_its_choice(self):
        product = products.find("ekf_wheel", self.model)
        lines = tree_text.draw(FeatureTree(self.model, product).root(), product)
        text = "\n".join(lines)
        for piece in ("[x] ◇ backend=ekf", "[ ] ◇ backend=pf", "[-] ◇ backend=grid",
                      "[-] ◇ backend=mono_graph", "[-] ◇ backend=rat", "[ ] ◇ backend=seif"):
            self.assertIn(piece, text)

    def test_the_picture_has_each_feature_with_its_mark(self):
        text = tree_diagram.dot(self.root, False)
        for node in nodes_of(self.root):
            if node.name:
                self.assertIn(f">{node.name.split()[0]}", text)
        for piece in ("arrowhead=dot", "arrowhead=odot", "[1..1]", "[1..*]", "style=dashed"):
            self.assertIn(piece, text)

    def test_the_command_draws_files_and_refuses_what_it_cannot_do(self):
        program = packages.program("slam_launch", "products")
        with tempfile.TemporaryDirectory() as folder:
            svg, png = pathlib.Path(folder) / "tree.svg", pathlib.Path(folder) / "tree.png"
            done = call(program, "--tree", "ekf_wheel", "--svg", svg, "--png", png)
            self.assertEqual((done.returncode, done.stdout), (0, f"{svg}\n{png}\n"), done.stderr)
            self.assertTrue(svg.read_text(encoding="utf-8").startswith("<?xml"))
            self.assertTrue(png.read_bytes().startswith(b"\x89PNG"))
            missing = pathlib.Path(folder) / "no" / "tree.svg"
            wrong = pathlib.Path(folder) / "wrong.yaml"
            shipped = products.find("ekf_wheel", self.model).path
            wrong.write_text(f"{shipped.read_text(encoding='utf-8')}\nekf:\n  filter: none\n",
                             encoding="utf-8")
            for words, code, sentence in (
                    (("--svg", svg), 2, "--svg and --png go with --tree"),
                    (("--tree", "--svg", png), 2, "ends with .svg"),
                    (("--tree", "--diagram", "ekf_wheel"), 2, "one at a time"),
                    (("--tree", "ekf_whel"), 1, "did you mean 'ekf_wheel'"),
                    (("--tree", wrong), 1, "'none' is not one of: extended, unscented"),
                    (("--tree", "--svg", missing), 1, "cannot write")):
                done = call(program, *words)
                self.assertEqual(done.returncode, code, words)
                self.assertIn(sentence, done.stderr)


def call(*words):
    return subprocess.run([str(word) for word in words], check=False, capture_output=True,
                          text=True)


if __name__ == "__main__":
    unittest.main()
