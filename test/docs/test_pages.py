# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""README is short and leads everywhere; its tables and drawn pictures are those of the programs."""

import html
import pathlib
import re
import subprocess
import tempfile
import unittest

from catkin.find_in_workspaces import find_in_workspaces
from doc_commands import packages, REPO, texts
import yaml

README = REPO / "README.md"
PRODUCTS = REPO / "docs" / "products.md"
LONGEST = 130  # lines: one screen and a half
LINK = re.compile(r"\]\((?!https?:)([^)#\s]*)#([^)\s]+)\)")
TEXT = re.compile(r"<text [^>]*>(.*?)</text>")
ADVERTISED = re.compile(r'advertise(?:Service)?(?:<[\w:]+>)?\(\s*(?:[\w.]+ \+ )?"(/?[\w/]+)"')
ROBOT_TOPICS = ("slam_*/src/*.cpp", "src/slam_ros/src/*.cpp")
OF_A_BAG = {"/clock", "/tf", "/tf_static"}  # what a replay publishes in the robot's place


def read(path):
    return path.read_text(encoding="utf-8")


def anchors(text):
    """Returns the names by which GitHub links to the headings of a page."""
    headings = re.findall(r"^#+ (.+)$", re.sub(r"```.*?```", "", text, flags=re.DOTALL),
                          re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading))
            .strip().lower().replace(" ", "-") for heading in headings}


class Readme(unittest.TestCase):
    def test_is_one_screen_and_a_half(self):
        self.assertLessEqual(len(read(README).splitlines()), LONGEST)

    def test_leads_to_every_page(self):
        pages = [path for path in texts() if path.parent in (REPO, REPO / "docs")]
        self.assertGreater(len(pages), 20)
        self.assertEqual([path.name for path in pages if path != README and
                          f"]({path.relative_to(REPO)})" not in read(README)], [])


class Anchors(unittest.TestCase):
    def test_lead_to_headings_that_are_there(self):
        broken, count = [], 0
        for path in texts():
            for target, anchor in LINK.findall(read(path)):
                count += 1
                page = path.parent / target if target else path
                if not page.exists() or anchor not in anchors(read(page)):
                    broken.append(f"{path.relative_to(REPO)}: {target}#{anchor}")
        self.assertGreater(count, 15)
        self.assertEqual(broken, [])

    def test_are_made_as_github_makes_them(self):
        self.assertEqual(anchors("# `./slam run`\n## Two machines\n```sh\n# no heading\n```\n"
                                 "### Sessions: save the graph, go on\n"),
                         {"slam-run", "two-machines", "sessions-save-the-graph-go-on"})


class Products(unittest.TestCase):
    def names(self):
        return {path.stem for path in (REPO / "slam_launch" / "products").glob("*.yaml")}

    def test_are_all_described(self):
        self.assertGreater(len(self.names()), 15)
        told = set(re.findall(r"`(\w+)`", read(PRODUCTS)))
        self.assertEqual(self.names() - told, set())

    def test_of_tables_exist(self):
        for page, column in ((README, 1), (PRODUCTS, 0)):
            table = read(page).split("| product" if page == PRODUCTS else "| you have")[1]
            rows = table.split("\n\n")[0].splitlines()[2:]
            named = {name for row in rows
                     for name in re.findall(r"`(\w+)`", row.split("|")[1 + column])}
            self.assertGreater(len(named), 10)
            self.assertEqual(named - self.names(), set(), page.name)


class Release(unittest.TestCase):
    def test_has_one_version(self):
        found = {re.search(r"<version>(.*)</version>", read(path)).group(1)
                 for path in packages()}
        self.assertEqual(len(found), 1)
        version = found.pop()
        self.assertIn(f"\nversion: {version}\n", read(REPO / "CITATION.cff"))
        self.assertEqual(re.findall(r"^## ([\d.]+)", read(REPO / "CHANGELOG.md"), re.MULTILINE)[0],
                         version)

    def test_names_each_package_that_is_installed(self):
        lines = [line for name in ("packages.txt", "campaign_tools.txt", "package_tools.txt", "fuzz_tools.txt")
                 for line in read(REPO / "tools" / name).splitlines()]
        names = [line.split("#")[0].strip() for line in lines]
        notice = read(REPO / "THIRD_PARTY.md")
        self.assertEqual([name for name in names if name and f"`{name}`" not in notice], [])

    def test_is_cited_in_a_file_that_is_read(self):
        cited = yaml.safe_load(read(REPO / "CITATION.cff"))
        self.assertEqual(cited["license"], "BSD-3-Clause")
        self.assertTrue(cited["title"] and cited["authors"] and cited["message"])

    def test_has_templates_with_a_name_each(self):
        templates = sorted((REPO / ".github" / "ISSUE_TEMPLATE").glob("*.md"))
        self.assertEqual([path.stem for path in templates], ["bug", "feature", "question"])
        for path in templates:
            self.assertRegex(read(path), r"\A---\nname: .+\nabout: .+\n(?:labels: .+\n)?---\n")


class Topics(unittest.TestCase):
    def test_that_products_publish_are_on_the_robots_page(self):
        page, topics = read(REPO / "docs" / "robot.md"), set()
        for pattern in ROBOT_TOPICS:
            for path in REPO.glob(pattern):
                topics.update(ADVERTISED.findall(read(path)))
        self.assertGreater(len(topics), 25)
        self.assertEqual([topic for topic in sorted(topics - OF_A_BAG)
                          if f"`{topic.lstrip('/')}`" not in page and
                          not re.search(rf"`\w+{topic}`", page)], [])


class Pictures(unittest.TestCase):
    """Graphviz may place a box elsewhere; what stands in the boxes has to be the same."""

    def drawn(self, *arguments):
        program = find_in_workspaces(["libexec"], "slam_launch", "products",
                                     first_match_only=True)[0]
        with tempfile.TemporaryDirectory() as folder:
            picture = pathlib.Path(folder) / "picture.svg"
            option = "--svg" if "--tree" in arguments else "--out"
            subprocess.run([program, *arguments, option, picture], check=True,
                           stdout=subprocess.DEVNULL)
            return self.words(picture)

    @staticmethod
    def words(picture):
        return sorted(html.unescape(text) for text in TEXT.findall(read(picture)))

    def test_of_nodelets_is_what_the_command_draws(self):
        there = self.words(REPO / "docs" / "images" / "ekf_wheel.svg")
        self.assertGreater(len(there), 8)
        self.assertEqual(there, self.drawn("--diagram", "ekf_wheel"))

    def test_of_features_is_what_the_command_draws(self):
        there = self.words(REPO / "docs" / "images" / "features.svg")
        self.assertGreater(len(there), 100)
        self.assertEqual(there, self.drawn("--tree"))

    def test_of_a_products_features_is_what_the_command_draws(self):
        there = self.words(REPO / "docs" / "images" / "chosen.svg")
        self.assertGreater(len(there), 100)
        self.assertEqual(there, self.drawn("--tree", "ekf_wheel"))

    def test_of_ports_is_what_the_command_draws(self):
        there = self.words(REPO / "docs" / "images" / "ports.svg")
        self.assertGreater(len(there), 8)
        self.assertEqual(there, self.drawn("--diagram", "pf_wheel_grid", "--ports"))


if __name__ == "__main__":
    unittest.main()
