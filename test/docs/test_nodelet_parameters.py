# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The private parameters of nodelets that the packages' READMEs tell are those that they read."""

import re
import unittest

from doc_commands import packages, REPO

STRUCT = re.compile(r"^struct (\w+) \{\n(.*?)^\};", re.MULTILINE | re.DOTALL)
FIELD = re.compile(r'\.add\(\s*"(\w+)",\s*&(?:\w+\.)?(\w+)')
NESTED = re.compile(r"\b(\w+)\.describe\(fields\)")
READ = re.compile(r"parametersFromRos<(?:\w+::)?(\w+)>\(")
TABLE = re.compile(r"(?:Private parameters.*:\n\n\| name|\| parameter of the nodelet) \| default \|"
                   r".*\n\|---.*\n((?:\|.*\n)+)")
ROW = re.compile(r"^\| `~?(\w+)` \| ([^|]*)\|", re.MULTILINE)
ROS = REPO / "src" / "slam_ros"  # what it brings serves the other packages as well
CORE = REPO / "src" / "slam_core"


def sources(folder):
    """Returns the C++ of a package, without its tests and without the core."""
    return [path.read_text(encoding="utf-8") for pattern in ("src/*.?pp", "include/*/*.?pp")
            for path in sorted(folder.glob(pattern))]


def structs(folder):
    return {name: body for text in sources(folder) for name, body in STRUCT.findall(text)}


def core_structs():
    """Returns the settings of components, with the source that describes them."""
    found = {}
    for path in CORE.glob("*/*_config.hpp"):
        source = path.with_suffix(".cpp")
        described = source.read_text(encoding="utf-8") if source.exists() else ""
        for name, body in STRUCT.findall(path.read_text(encoding="utf-8")):
            found[name] = body + described
    return found


def parameters(name, known):
    """Returns the defaults of a struct's parameters by name, those of its parts among them."""
    body = known[name]
    found = {key: default_of(member, body) for key, member in FIELD.findall(body)}
    for member in NESTED.findall(body):
        part = re.search(rf"(\w+) {member};", body).group(1)
        found.update(parameters(part, known))
    return found


def default_of(member, body):
    """Returns what a member is declared with; nothing is a text or list that is empty, Enum::kName
    is the choice "name"."""
    value = (re.search(rf" {member}(?: = ([^,;(]+))?[,;]", body).group(1) or "").strip('"')
    return re.sub(r"^\w+::k(\w+)$", lambda choice: choice.group(1).lower(), value)


def read_by(folder):
    """Returns the defaults of all private parameters of a package's nodelets; one that several of
    them read has several."""
    known = {**core_structs(), **structs(ROS), **structs(folder)}
    found = {}
    for name in {name for text in sources(folder) for name in READ.findall(text)} & set(known):
        for key, default in parameters(name, known).items():
            found.setdefault(key, set()).add(default)
    return found


def same(told, default):
    """Whether a table's cell is a default of the code: 2 is 2.0, nothing the empty text."""
    told = told.strip().strip("`")
    try:
        return float(told) == float(default)
    except ValueError:
        return told == default


class NodeletParameters(unittest.TestCase):
    def test_are_all_told_in_the_package_s_readme(self):
        missing, count = [], 0
        for package in packages():
            text = (package.parent / "README.md").read_text(encoding="utf-8")
            names = read_by(package.parent)
            count += len(names)
            missing += [f"{package.parent.name}: {name}" for name in names
                        if f"`{name}`" not in text and f"`~{name}`" not in text]
        self.assertGreater(count, 20)
        self.assertEqual(missing, [])

    def test_of_a_table_exist_and_have_its_defaults(self):
        wrong, count = [], 0
        for package in packages():
            text = (package.parent / "README.md").read_text(encoding="utf-8")
            names = read_by(package.parent)
            for table in TABLE.findall(text):
                for name, told in ROW.findall(table):
                    count += 1
                    if not any(same(told, default) for default in names.get(name, ())):
                        wrong.append(f"{package.parent.name}: {name}, default '{told.strip()}'; "
                                     f"the code has {names.get(name, 'no such parameter')}")
        self.assertGreater(count, 15)
        self.assertEqual(wrong, [])

    def test_are_found_in_the_code_with_their_parts(self):
        known = {"Part": 'double rate = 2.0;\n  fields.add("rate", &rate, "x");',
                 "Whole": "  ns::Part part;\n  bool is_on = true;\n  part.describe(fields);\n"
                          '  fields\n      .add("on", &is_on, "y");'}
        known["Part"] = "  " + known["Part"]
        self.assertEqual(parameters("Whole", known), {"rate": "2.0", "on": "true"})
        self.assertEqual(default_of("kind", "  Kind kind = Kind::kAuto;"), "auto")
        self.assertTrue(same("`auto` ", "auto") and same(" 2", "2.0") and same(" ", ""))
        self.assertFalse(same("3", "2.0") or same("", "true"))


if __name__ == "__main__":
    unittest.main()
