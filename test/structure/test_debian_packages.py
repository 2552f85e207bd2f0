# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Each catkin package has its Debian package, of one version, which depends on what package.xml names."""

from importlib.machinery import SourceFileLoader
import importlib.util
import pathlib
import re
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

REPO = pathlib.Path(__file__).resolve().parents[2]
OF_NONE = {"ros-slam", "ros-slam-dev"}  # binary packages that belong to no catkin package
COMPILED = re.compile(r"^\s*(?:add_library|add_executable|slam_core_library)\(", re.MULTILINE)
MAN_MACROS = (".TH ", ".SH ", ".nf", ".fi")


def load():
    loader = SourceFileLoader("split", str(REPO / "debian/split"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("split", loader))
    loader.exec_module(module)
    return module


def read(name):
    return (REPO / name).read_text(encoding="utf-8")


def package_xml(name, *dependencies):
    text = "".join(f"<depend>{key}</depend>" for key in dependencies)
    return ElementTree.fromstring(f"<package><name>{name}</name>{text}</package>")


class Packages(unittest.TestCase):
    def setUp(self):
        self.split = load()
        self.packages = self.split.catkin_packages()

    def folders(self):
        """Returns the folder of each catkin package but the tests by name."""
        found = [path.parent for folder in ("*", "src/*") for path in REPO.glob(f"{folder}/package.xml")]
        names = {path: ElementTree.parse(path / "package.xml").getroot().findtext("name") for path in found}
        return {name: path for path, name in names.items() if name != "slam_tests"}

    def test_are_one_for_each_catkin_package(self):
        names = {f"ros-{name.replace('_', '-')}" for name in self.folders()}
        self.assertGreater(len(names), 15)
        self.assertEqual(set(self.split.architectures()), names | OF_NONE)
        self.assertEqual(set(self.packages), set(self.folders()))

    def test_are_for_one_architecture_where_something_is_compiled(self):
        kinds = self.split.architectures()
        for name, folder in self.folders().items():
            compiled = COMPILED.search((folder / "CMakeLists.txt").read_text(encoding="utf-8"))
            self.assertEqual(kinds[self.split.debian_name(name)], "any" if compiled else "all", name)

    def test_have_the_version_of_all_that_names_one(self):
        version = re.match(r"ros-slam \((.*)\) ", read("debian/changelog")).group(1)
        self.assertEqual({tree.findtext("version") for tree in self.packages.values()}, {version})
        for name, pattern in (("CHANGELOG.md", r"^## ([\d.]+)$"), ("CITATION.cff", r"^version: (.*)$"),
                              ("test/package.xml", r"<version>(.*)</version>"),
                              ("src/slam_core/CMakeLists.txt", r"^project\(slam_core VERSION (\S+)")):
            found = re.search(pattern, read(name), re.MULTILINE)
            self.assertEqual(found and found.group(1), version, name)

    def test_depend_on_what_package_xml_names(self):
        keys, kinds = self.split.read_keys(), self.split.architectures()
        for name, tree in self.packages.items():
            entries = self.split.depends(name, self.packages, keys, kinds)
            ours = {entry.split()[0] for entry in entries if entry.startswith("ros-slam-")}
            needed = {self.split.debian_name(entry.text) for tag in ("depend", "exec_depend")
                      for entry in tree.iter(tag) if entry.text in self.packages}
            self.assertEqual(ours, needed, name)
        entries = self.split.depends("slam_doctor", self.packages, keys, kinds)
        self.assertIn("python3-scipy", entries)
        self.assertIn("ros-slam-ros (= ${source:Version})", entries)

    def test_are_built_with_all_that_package_xml_names(self):
        keys = self.split.read_keys()
        build = set(re.findall(r"[\w.+-]+", read("debian/control").split("Build-Depends:")[1]
                               .split("\n\n")[0]))
        lacking = {(name, entry.text) for name, tree in self.packages.items()
                   for tag in ("buildtool_depend", "build_depend", "depend") for entry in tree.iter(tag)
                   if entry.text in keys and not set(keys[entry.text][1]) <= build}
        self.assertEqual(lacking, set())

    def test_know_every_key(self):
        named = {entry.text for tree in self.packages.values()
                 for tag in ("depend", "exec_depend", "build_export_depend") for entry in tree.iter(tag)}
        keys = set(self.split.read_keys())
        self.assertEqual(named - keys - set(self.packages), set())
        self.assertEqual(keys - named - {"catkin"}, set(), "in debian/keys, but nobody needs it")

    def test_are_refused_where_a_key_is_unknown(self):
        with self.assertRaisesRegex(self.split.SplitError,
                                    "package.xml of slam_new depends on wheels, which debian/keys lacks"):
            self.split.depends("slam_new", {"slam_new": package_xml("slam_new", "wheels")}, {}, {})


class Plugins(unittest.TestCase):
    def test_are_named_as_debian_s_pluginlib_finds_them_without_a_workspace(self):
        """It asks for /usr/lib/TRIPLET/PATH.so, where others take PATH relative to the prefix."""
        paths = [path for pattern in ("*/*plugin*.xml", "src/*/*plugin*.xml")
                 for file in REPO.glob(pattern)
                 for path in re.findall(r'<library path="(.*?)"', file.read_text(encoding="utf-8"))]
        self.assertGreater(len(paths), 10)
        self.assertEqual([path for path in paths if not re.fullmatch(r"libslam_\w+", path)], [])


class SharingOut(unittest.TestCase):
    NAMES = ("slam_core", "slam_rviz", "slam_rviz_plugins")

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.split = load()

    def share_out(self, *paths):
        for path in paths:
            file = self.folder / "tmp" / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.touch()
        self.split.share_out(self.folder / "tmp", dict.fromkeys(self.NAMES))
        return sorted(path.relative_to(self.folder).as_posix()
                      for path in self.folder.rglob("*") if not path.is_dir())

    def test_gives_each_package_its_files(self):
        self.assertEqual(self.share_out("usr/lib/x/libslam_core_common.so", "usr/share/slam_rviz/slam.rviz",
                                        "usr/lib/x/libslam_rviz_plugins.so",
                                        "usr/lib/python3/dist-packages/slam_core-0.1.0.egg-info"),
                         ["ros-slam-core/usr/lib/python3/dist-packages/slam_core-0.1.0.egg-info",
                          "ros-slam-core/usr/lib/x/libslam_core_common.so",
                          "ros-slam-rviz-plugins/usr/lib/x/libslam_rviz_plugins.so",
                          "ros-slam-rviz/usr/share/slam_rviz/slam.rviz"])

    def test_puts_what_builds_need_into_a_package_of_its_own(self):
        paths = ["usr/include/slam_core/a.hpp", "usr/lib/x/pkgconfig/slam_core.pc",
                 "usr/share/slam_core/cmake/slam_coreConfig.cmake"]
        self.assertEqual(self.share_out(*paths), [f"ros-slam-dev/{path}" for path in paths])

    def test_refuses_what_belongs_to_nobody(self):
        with self.assertRaisesRegex(self.split.SplitError, "usr/share/maps/a.yaml was installed, but "
                                                           "belongs to no catkin package"):
            self.share_out("usr/share/maps/a.yaml")


class ManualPage(unittest.TestCase):
    def test_says_what_the_command_says(self):
        page = subprocess.run([REPO / "debian/manual_page", REPO / "slam"], check=True, text=True,
                              stdout=subprocess.PIPE).stdout
        self.assertTrue(page.startswith(".TH SLAM 1\n"), page)
        self.assertIn("\nUsage: ", page)
        strange = [line for line in page.splitlines()
                   if line.startswith((".", "'")) and not line.startswith(MAN_MACROS)]
        self.assertEqual(strange, [], "lines that man takes for macros")


if __name__ == "__main__":
    unittest.main()
