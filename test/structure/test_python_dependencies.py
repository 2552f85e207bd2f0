# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What slam_eval imports: its sub-packages keep their direction, benchmarks know nothing of one
another, and only benchmarks and what feeds foreign systems need ROS."""

import ast
import pathlib
import unittest

EVAL = pathlib.Path(__file__).resolve().parents[2] / "src" / "slam_eval" / "src" / "slam_eval"

# each may import those before it
ORDER = ["geometry", "io", "metrics", "plot", "report", "bench", "foreign", "campaign"]
BENCH_ORDER = ["harness", "peers"]  # what comes after is a benchmark
LISTS_THE_BENCHMARKS = "cli.py"
NEED_ROS = {"bench", "foreign"}
READS_BAGS = "io/bag.py"  # imports ROS when it is called
ROS = {"catkin_pkg", "rosbag", "roslib", "roslaunch", "rospkg", "rospy", "tf2_ros"}


def sources():
    return sorted(EVAL.rglob("*.py"))


def imports(text):
    """The modules that a module imports, dotted; `from a import b` counts as a.b."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            prefix = "." * node.level + (f"{node.module}." if node.module else "")
            yield from (prefix + alias.name for alias in node.names)


def places(path):
    """The folders and the module below slam_eval, like ("bench", "ekf", "update")."""
    return path.relative_to(EVAL).with_suffix("").parts


def own(path):
    """What a module imports of slam_eval, as places; the name at the end may be a function."""
    names = [name.split(".") for name in imports(path.read_text(encoding="utf-8"))]
    return [tuple(name[1:]) for name in names if name[0] == "slam_eval"]


def level(order, name):
    return order.index(name) if name in order else len(order)


class OneWay(unittest.TestCase):
    """geometry <- io <- metrics <- plot <- report <- bench <- foreign <- campaign, and in bench
    harness <- peers <- benchmarks; tests may look at more."""

    def test_the_rule_sees_every_kind_of_import(self):
        text = "import a.b as c\nfrom . import h\ndef f():\n    from d.e import (f,\n        g)\n"
        self.assertEqual(sorted(imports(text)), [".h", "a.b", "d.e.f", "d.e.g"])

    def test_every_module_is_in_a_folder_that_says_what_belongs_there(self):
        self.assertGreater(len(sources()), 50)
        self.assertEqual([path.name for path in EVAL.glob("*.py")], ["__init__.py"])
        self.assertEqual({path.parent.name for path in EVAL.glob("*/__init__.py")}, set(ORDER))
        for folder in {path.parent for path in sources()}:
            text = (folder / "__init__.py").read_text(encoding="utf-8")
            self.assertTrue(ast.get_docstring(ast.parse(text)), folder)

    def test_imports_name_the_package(self):
        found = [f"{path.relative_to(EVAL)}: {name}" for path in sources()
                 for name in imports(path.read_text(encoding="utf-8")) if name.startswith(".")]
        self.assertEqual(found, [])

    def test_nothing_imports_what_is_above_it(self):
        found = [f"{path.relative_to(EVAL)} imports {used[0]}" for path in sources()
                 for used in own(path)
                 if level(ORDER, used[0]) > level(ORDER, places(path)[0])]
        self.assertEqual(found, [])

    def test_benchmarks_never_import_one_another(self):
        found = []
        for path in (EVAL / "bench").rglob("*.py"):
            user = places(path)[1:]
            if path == EVAL / "bench" / LISTS_THE_BENCHMARKS:
                continue
            for used in (used[1:] for used in own(path) if used[0] == "bench"):
                ranks = level(BENCH_ORDER, user[0]), level(BENCH_ORDER, used[0])
                if ranks[1] > ranks[0] or (min(ranks) == len(BENCH_ORDER) and used[0] != user[0]):
                    found.append(f"{path.relative_to(EVAL)} imports {'.'.join(used)}")
        self.assertEqual(found, [])

    def test_only_benchmarks_and_foreign_systems_need_ros(self):
        found = [f"{path.relative_to(EVAL)}: {name}" for path in sources()
                 for name in imports(path.read_text(encoding="utf-8"))
                 if name.split(".")[0] in ROS and places(path)[0] not in NEED_ROS
                 and path != EVAL / READS_BAGS]
        self.assertEqual(found, [])


if __name__ == "__main__":
    unittest.main()
