# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A class of slam_core has at most ten public methods beside its configuration.

Counted by name, so that overloads are one method. Not counted: constructors, operators, what a base
class declares (it is counted there), what configures (`configure`, `describe`), and `persist`, which
lists the members for an archive.
"""

import pathlib
import re
import unittest

CORE = pathlib.Path(__file__).resolve().parents[2] / "src" / "slam_core"

MOST = 10
CLASS = re.compile(r"^( *)(?:class|struct) (\w+)[^;]*$")
ACCESS = re.compile(r"^ *(public|protected|private):$")
METHOD = re.compile(r"([\w~]+|operator\S+)\(")
NO_METHOD = re.compile(r" *(//|using |friend |template |static_assert|static constexpr |\}|#)")
EVERYWHERE = {"configure", "describe", "persist"}
# With the reason why it is not taken apart.
MORE = {"Pose2": "a value, and what mathematics has of it",
        "EkfState": "estimate, covariance and ids change together or not at all",
        "Neighbourhood": "one covariance in two parts, which only it can keep in step"}


def classes(lines):
    """Yields name, indentation, kind and lines of every class of a file that clang-format wrote."""
    for number, line in enumerate(lines):
        opened = CLASS.match(line)
        if not opened:
            continue
        indentation, name = opened.groups()
        end = next((last for last in range(number, len(lines))
                    if lines[last].startswith(indentation + "};")), number)
        yield name, len(indentation), "struct" in line.split(name)[0], lines[number + 1:end]


def public_methods(name, indentation, is_struct, lines):
    """Returns the names of a class's own public methods."""
    access = "public" if is_struct else "private"
    methods = set()
    for number, line in enumerate(lines):
        given = ACCESS.match(line)
        if given and len(line) - len(line.lstrip()) == indentation + 1:
            access = given.group(1)
        is_member = len(line) - len(line.lstrip()) == indentation + 2
        if access != "public" or not is_member or NO_METHOD.match(line):
            continue
        declaration = declared(lines[number:])
        found = METHOD.search(declaration)
        if found and "override" not in declaration and " = " not in declaration[:found.start()]:
            methods.add(found.group(1))
    return {method for method in methods - EVERYWHERE
            if method.strip("~") != name and not method.startswith("operator")}


def declared(lines):
    """Returns the declaration that the lines begin with, without its body."""
    text = ""
    for line in lines:
        text += line.split("//")[0].strip() + " "
        if re.search(r"[;{]", text):
            break
    return re.sub(r"<[^()]*(\([^()]*\))?[^()]*>", "", re.split(r"[;{]", text)[0])


class ClassSize(unittest.TestCase):
    def test_counts_what_a_reader_would(self):
        text = """class Robot final : public Machine {
 public:
  explicit Robot(int wheels);
  ~Robot() override;
  void configure(Settings& settings);
  void drive(double distance);
  void drive(const Path& path,
             double speed) {
    steer(path);
  }
  bool isBusy() const override { return true; }
  std::function<void(int)> listener;
  Robot& operator=(const Robot&) = delete;
  static double length(int count) { return count; }

 private:
  void steer(const Path& path);
};""".splitlines()
        self.assertEqual([public_methods(*found) for found in classes(text)],
                         [{"drive", "length"}])

    def test_no_class_has_more_than_ten(self):
        counted = {}
        for path in CORE.rglob("*.hpp"):
            if "test" in path.parts:
                continue
            for name, *found in classes(path.read_text(encoding="utf-8").splitlines()):
                methods = public_methods(name, *found)
                if len(methods) > MOST and name not in MORE:
                    counted[f"{path.relative_to(CORE)}: {name}"] = sorted(methods)
        self.assertEqual(counted, {}, "take what belongs together into a class or a struct")


if __name__ == "__main__":
    unittest.main()
