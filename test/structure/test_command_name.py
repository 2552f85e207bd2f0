# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What programs print names the command as it was called: ./slam in a clone, slam where Debian
packages have installed it. Both say so in the environment, as SLAM_COMMAND."""

import ast
import pathlib
import re
import unittest

from test_python_style import is_python

REPO = pathlib.Path(__file__).resolve().parents[2]
LITERAL = re.compile(r'"(?:[^"\\\n]|\\.)*"')
COMMENT = re.compile(r"^\s*//.*$", re.MULTILINE)
FIXED = "./slam"


def programs():
    """The sources of what is installed."""
    paths = [path for folder in ("slam_*", "src/slam_*") for path in REPO.glob(f"{folder}/**/*")]
    return [path for path in paths if path.is_file() and "test" not in path.parts and
            "__pycache__" not in path.parts]


def docstrings(tree):
    """The docstrings of a module that no parser of arguments prints."""
    shown = any(isinstance(node, ast.Name) and node.id == "__doc__" for node in ast.walk(tree))
    kinds = (ast.FunctionDef, ast.ClassDef) + (() if shown else (ast.Module,))
    nodes = [node for node in ast.walk(tree) if isinstance(node, kinds) and ast.get_docstring(node)]
    return [node.body[0].value for node in nodes]


def printed_by_python(text):
    tree = ast.parse(text)
    left_out = docstrings(tree)
    return [node.value for node in ast.walk(tree) if isinstance(node, ast.Constant) and
            isinstance(node.value, str) and not any(node is entry for entry in left_out)]


def printed_by_cpp(text):
    return LITERAL.findall(COMMENT.sub("", text))


class CommandName(unittest.TestCase):
    def test_the_rule_tells_messages_from_comments(self):
        text = '"""./slam a"""\n# ./slam b\nprint(f"{x} ./slam c")\ndef f():\n    """./slam d"""\n'
        self.assertEqual([word for word in printed_by_python(text) if FIXED in word], [" ./slam c"])
        shown = '"""./slam a"""\nparser(description=__doc__)\n'
        self.assertEqual(printed_by_python(shown), ["./slam a"])
        self.assertEqual(printed_by_cpp('  /// "./slam a"\nsay("./slam b");\n'), ['"./slam b"'])

    def test_no_program_takes_it_for_granted(self):
        found, count = [], 0
        for path in programs():
            if path.suffix in (".cpp", ".hpp"):
                printed = printed_by_cpp(path.read_text(encoding="utf-8"))
            elif path.suffix in ("", ".py") and is_python(path):
                printed = printed_by_python(path.read_text(encoding="utf-8"))
            else:
                continue
            count += 1
            found += [f"{path.relative_to(REPO)}: {word}" for word in printed if FIXED in word]
        self.assertGreater(count, 500)
        self.assertEqual(found, [])


if __name__ == "__main__":
    unittest.main()
