# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""How the Python of the repository is written: double quotes."""

import io
import pathlib
import subprocess
import tokenize
import unittest

REPO = pathlib.Path(__file__).resolve().parents[2]


def is_python(path):
    if path.suffix:
        return path.suffix == ".py"
    with open(path, "rb") as stream:
        first = stream.readline()
    return first.startswith(b"#!") and b"python" in first


def sources():
    """The Python files that git knows, programs without an ending included."""
    names = subprocess.run(["git", "-C", str(REPO), "ls-files", "-z", "--cached", "--others",
                            "--exclude-standard"], check=True, capture_output=True).stdout
    paths = [REPO / name for name in names.decode().split("\0") if name]
    return [path for path in paths if path.is_file() and is_python(path)]


def single_quoted(text):
    """(line, literal) of the strings in single quotes that hold no double quote."""
    return [(token.start[0], token.string)
            for token in tokenize.generate_tokens(io.StringIO(text).readline)
            if token.type == tokenize.STRING
            and token.string.lstrip("bfruBFRU")[0] == "'" and '"' not in token.string]


class Quotes(unittest.TestCase):
    def test_the_rule_knows_what_double_quotes_would_have_to_escape(self):
        text = "a = 'x'\nb = '\"'\nc = \"it's\"\nd = f'{a}'\n"
        self.assertEqual(single_quoted(text), [(1, "'x'"), (4, "f'{a}'")])

    def test_strings_stand_in_double_quotes(self):
        if not (REPO / ".git").exists():
            self.skipTest("no git repository")
        self.assertGreater(len(sources()), 150)
        found = [f"{path.relative_to(REPO)}:{line}: {literal}" for path in sources()
                 for line, literal in single_quoted(path.read_text(encoding="utf-8"))]
        self.assertEqual(found, [], "double quotes, but around what holds double quotes")


if __name__ == "__main__":
    unittest.main()
