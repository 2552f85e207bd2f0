# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The shell commands that stand in Markdown: fenced blocks of the language sh.

A comment in the line before a block, <!-- not run: REASON -->, says that no test can run it;
<!-- needs: NAME --> that it needs a folder of the data that tests may find, or a program that need
not be installed.
"""

import dataclasses
import pathlib
import re

REPO = pathlib.Path(__file__).resolve().parents[2]
FENCE = re.compile(r"^```(\S*)\s*$")
COMMENT = re.compile(r"^<!-- (not run|needs): (.+) -->$")


@dataclasses.dataclass(frozen=True)
class Block:
    """A fenced block with what the comment before it says."""

    file: pathlib.Path
    line: int
    language: str
    text: str
    not_run: str = ""  # the reason
    needs: str = ""    # a folder of the data, or a program

    def __str__(self):
        return f"{self.file.relative_to(REPO)}:{self.line}"


def blocks(path):
    """Returns the fenced blocks of a file, in order."""
    found, before, start = [], "", None
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        fence = FENCE.match(line)
        if fence and start is None:
            start, language, content, comment = number, fence.group(1), [], COMMENT.match(before)
        elif fence:
            told = {comment.group(1).replace(" ", "_"): comment.group(2)} if comment else {}
            found.append(Block(path, start, language, "\n".join(content) + "\n", **told))
            start = None
        elif start is not None:
            content.append(line)
        before = line.strip() or before
    if start is not None:
        raise ValueError(f"{path}:{start}: the block does not end")
    return found


def texts():
    """Returns the Markdown files that users read: the root's, docs', the packages'."""
    return sorted([*texts_of_root(), *texts_of_docs(), *texts_of_packages()])


def texts_of_root():
    return sorted(REPO.glob("*.md"))


def texts_of_docs():
    return sorted((REPO / "docs").glob("*.md"))


def texts_of_packages():
    return sorted(path for package in packages() for path in package.parent.glob("*.md"))


def packages():
    """Returns the package.xml of each package; the tests' toys are none."""
    return sorted(path for pattern in ("*/package.xml", "src/*/package.xml")
                  for path in REPO.glob(pattern))


def shell_blocks(files=None):
    """Returns the blocks of files, without them of all texts."""
    return [block for path in (texts() if files is None else files) for block in blocks(path)
            if block.language == "sh"]
