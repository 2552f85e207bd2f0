# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Each package has a README that names what it brings; what READMEs name is there."""

import re
import unittest
import xml.etree.ElementTree as ElementTree

from doc_commands import packages, REPO, texts

ROW = re.compile(r"^\| (in|out|srv) \| ([^|]+) \|", re.MULTILINE)
CODE = re.compile(r"`([^`]+)`")
MESSAGE = re.compile(r"\bslam_msgs/(\w+)")
LINK = re.compile(r"\]\((?!https?:)([^)#]+)(?:#[^)]*)?\)")
LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
ASIDE = {"/tf", "/tf_static", "/diagnostics"}  # those of ROS, published through its classes


def name_of(package):
    return ElementTree.parse(package).getroot().findtext("name")


def literals():
    """Returns every text in quotes of the sources; a topic's name is one, or the end of one."""
    found = set()
    for path in [*REPO.glob("slam_*/src/*.?pp"), *REPO.glob("src/*/**/*.?pp"),
                 *REPO.glob("slam_bridges/src/**/*.py"), *REPO.glob("slam_labels/src/**/*.py")]:
        if "test" not in path.parts:
            found.update(LITERAL.findall(path.read_text(encoding="utf-8")))
    return found


def plugins(folder):
    file = folder / "nodelet_plugins.xml"
    return [entry.get("name") for entry in ElementTree.parse(file).iter("class")] if (
        file.exists()) else []


class PackageReadme(unittest.TestCase):
    def readmes(self):
        for package in packages():
            path = package.parent / "README.md"
            self.assertTrue(path.exists(), f"{package.parent} has no README.md")
            yield package, path.read_text(encoding="utf-8")

    def test_bears_the_packages_name_and_says_what_it_is_for(self):
        for package, text in self.readmes():
            lines = [line for line in text.splitlines() if line.strip()]
            self.assertEqual(lines[0], f"# {name_of(package)}")
            self.assertGreater(len(" ".join(lines[1:3]).split()), 8, str(package))

    def test_names_every_nodelet_and_launch_file(self):
        missing = []
        for package, text in self.readmes():
            brought = plugins(package.parent)
            brought += [path.name for path in (package.parent / "launch").glob("*.launch")]
            missing += [f"{name_of(package)}: {name}" for name in brought if name not in text]
        self.assertEqual(missing, [])


class Topics(unittest.TestCase):
    def test_that_a_readme_lists_are_those_of_the_code(self):
        known, unknown, count = literals(), [], 0
        for path in texts():
            for _, cell in ROW.findall(path.read_text(encoding="utf-8")):
                for topic in CODE.findall(cell):
                    count += 1
                    if topic not in ASIDE and not is_known(topic, known):
                        unknown.append(f"{path.relative_to(REPO)}: {topic}")
        self.assertGreater(count, 40)
        self.assertEqual(unknown, [])

    def test_that_rviz_shows_are_told(self):
        view = (REPO / "rviz" / "slam.rviz").read_text(encoding="utf-8")
        shown = re.findall(r"Topic: (\S+)", view)
        self.assertGreater(len(shown), 5)
        told = (REPO / "rviz" / "README.md").read_text(encoding="utf-8")
        self.assertEqual([topic for topic in shown if f"`{topic}`" not in told], [])

    def test_a_name_that_nobody_uses_is_noticed(self):
        known = literals()
        for topic, is_there in (("pose", True), ("camera/image_raw", True),
                                ("camera/image_raw/compressed", True), ("pos", False),
                                ("lidar/pose_of_nobody", False)):
            self.assertEqual(is_known(topic, known), is_there, topic)

    def test_messages_and_services_of_ours_exist(self):
        there = {path.stem for path in (REPO / "slam_msgs").glob("*/*.*")}
        named = {(path.name, name) for path in texts()
                 for name in MESSAGE.findall(path.read_text(encoding="utf-8"))}
        self.assertGreaterEqual(len(named), 5)
        self.assertEqual([entry for entry in named if entry[1] not in there], [])


def is_known(topic, known):
    """Whether the sources have the name, or make it of a folder's name and what is in it."""
    folder, slash, name = topic.rstrip(".").rstrip("/").rpartition("/")
    return topic in known or f"/{name}" in known and (not slash or is_known(folder, known) or
                                                      any(text.startswith(folder + "/")
                                                          for text in known))


class Architecture(unittest.TestCase):
    def test_names_every_folder_of_the_core_and_every_package(self):
        text = (REPO / "docs" / "architecture.md").read_text(encoding="utf-8")
        core = REPO / "src" / "slam_core"
        folders = {path.parent.name for path in core.glob("*/*.?pp")}
        self.assertGreater(len(folders), 15)
        folders |= {f"{path.parent.relative_to(REPO)}/" for path in packages()}
        self.assertEqual([name for name in folders if name not in text], [])


class Links(unittest.TestCase):
    def test_lead_to_files_that_are_there(self):
        broken = [f"{path.relative_to(REPO)}: {target}" for path in texts()
                  for target in LINK.findall(path.read_text(encoding="utf-8"))
                  if not (path.parent / target).exists()]
        self.assertEqual(broken, [])


if __name__ == "__main__":
    unittest.main()
