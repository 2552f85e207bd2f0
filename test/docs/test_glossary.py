# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The documents use the terms of docs/glossary.md, and none of the words that it rules out."""

import re
import unittest

from doc_commands import REPO, texts

GLOSSARY = REPO / "docs" / "glossary.md"
RULED_OUT = {"begin anew": r"\bbeg[aiu]ns? anew|\bbeginning anew", "begun anew": r"\bbegun anew",
             "foretell": r"\bforetells?", "foretold": r"\bforetold", "foresee": r"\bfores(?:aw|een?s?)\b",
             "as wrong as it says": "as wrong as it says", "stretch": r"\bstretch(?:es)?\b",
             "told": r"\btold\b", "starving": r"\bstarv(?:es?|ing)\b"}
# What is generated from the code, or is history.
ASIDE = {"parameters.md", "CHANGELOG.md", "glossary.md"}
SPELLING = re.compile(r"\bgray\b|\bcolor|\bcenter\b|\bneighbor|\binitializ|\brelocaliz", re.IGNORECASE)
NOT_PROSE = re.compile(r"```.*?```|`[^`]*`|(?<!\w)\"[^\"\n]*\"|\]\([^)]*\)", re.DOTALL)


def prose(text):
    """Returns a page without code, commands, quoted messages and links' targets, on one line."""
    return " ".join(NOT_PROSE.sub(" ", text).split())


def found_in(text):
    """Returns the words that are ruled out, with what stands around them."""
    words = prose(text)
    return [words[max(0, match.start() - 40):match.end() + 20]
            for pattern in (*RULED_OUT.values(), SPELLING)
            for match in re.finditer(pattern, words)]


class Glossary(unittest.TestCase):
    def rows(self):
        lines = GLOSSARY.read_text(encoding="utf-8").splitlines()
        return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines
                if line.startswith("| ")]

    def test_names_a_term_its_meaning_and_what_not_to_say(self):
        self.assertGreater(len(self.rows()), 40)
        self.assertEqual([row for row in self.rows() if len(row) != 3 or not row[0] or not row[1]],
                         [])

    def test_lists_the_words_that_are_looked_for(self):
        listed = " ".join(row[2] for row in self.rows())
        self.assertEqual([word for word in RULED_OUT if word not in listed], [])

    def test_is_kept_by_the_documents(self):
        pages = [path for path in texts() if path.name not in ASIDE]
        self.assertGreater(len(pages), 30)
        found = [f"{path.relative_to(REPO)}: ... {words} ..." for path in pages
                 for words in found_in(path.read_text(encoding="utf-8"))]
        self.assertEqual(found, [], "\n".join(found))

    def test_finds_words_in_prose_alone(self):
        self.assertEqual(len(found_in("What was foretold\nis told, in gray.")), 3)
        self.assertEqual(found_in('`told` and "it is begun anew"\n```text\ngray\n```\n'
                                  "[grey](gray.md), retold"), [])


if __name__ == "__main__":
    unittest.main()
