# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The feature tree in a terminal: a line a feature, with its mark; reasons stand below."""

from .feature_tree import (ABSENT, ALTERNATIVE, BRANCH, CHOSEN, EXCLUDED, MANDATORY, nodes_of,
                           OPTIONAL, OR)

MARKS = {MANDATORY: "●", OPTIONAL: "○", ALTERNATIVE: "◇", OR: "◆", BRANCH: "─", ABSENT: "✗"}
LEGEND = {MANDATORY: "mandatory", OPTIONAL: "optional", ALTERNATIVE: "alternative, exactly one",
          OR: "or, at least one", ABSENT: "not offered"}
STATES = {CHOSEN: "[x] ", EXCLUDED: "[-] ", "": "[ ] "}


def draw(root, product=None):
    """Returns the lines of a tree; of a product, each with what it has chosen."""
    notes = numbered(root)
    legend = [f"{MARKS[mark]} {meaning}" for mark, meaning in LEGEND.items()]
    if product:
        legend += ["[x] chosen", "[-] excluded by what is chosen"]
    lines = [*branch(root, "", "", notes, bool(product)), "", "   ".join(legend), ""]
    return lines + list(sentences(notes))


def numbered(root):
    """Returns the number of each note of the tree."""
    notes = dict.fromkeys(note for node in nodes_of(root) for note in node.notes)
    return {note: number for number, note in enumerate(notes, 1)}


def sentences(notes):
    """Yields what stands below the tree."""
    for note, number in notes.items():
        yield f"({number}) {note[0].upper()}{note[1:]}."


def references(node, notes):
    return " ".join(f"({notes[note]})" for note in node.notes)


def label(node):
    """Returns a group's title with its key, a feature's name before its title."""
    if node.children and node.name:
        return [f"{node.title} ({node.name})"]
    return [node.name, node.title]


def branch(node, first, rest, notes, is_product):
    """Yields the lines of a node and of all below it, which begin with `first` and `rest`."""
    state = STATES[node.state] if is_product and node.mark != ABSENT else ""
    words = [MARKS[node.mark], *label(node), references(node, notes)]
    yield first + state + " ".join(filter(None, words))
    for number, child in enumerate(node.children):
        is_last = number == len(node.children) - 1
        yield from branch(child, rest + ("└─ " if is_last else "├─ "),
                          rest + ("   " if is_last else "│  "), notes, is_product)
