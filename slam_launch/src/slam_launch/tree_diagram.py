# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The feature tree as a picture, with FODA's marks: a filled circle is mandatory, an open one
optional; an open triangle stands before alternatives, a filled one before some-of."""

import html
import itertools
import textwrap

from . import diagram
from .feature_tree import ABSENT, ALTERNATIVE, BRANCH, CHOSEN, EXCLUDED, MANDATORY, OPTIONAL, OR
from .tree_text import numbered, references, sentences

WIDTH = 36        # characters of a line in a box
NOTE_WIDTH = 150  # of a line of the notes
HEADS = {MANDATORY: "dot", OPTIONAL: "odot"}
CARDINALITIES = {ALTERNATIVE: "[1..1]", OR: "[1..*]"}
LEGEND = ("● mandatory   ○ optional   ◁ [1..1] alternative   ◀ [1..*] or   dashed: not offered",
          "   coloured: chosen   struck out: excluded by what is chosen")
CHOICE = "#fbe9df"  # behind what a product has chosen


def write(root, path, is_product=False):
    """Writes the picture as SVG, PNG, PDF or in graphviz's language, by the file's name."""
    diagram.write(path, dot(root, is_product))


def dot(root, is_product):
    notes = numbered(root)
    lines = ["".join(LEGEND if is_product else LEGEND[:1]), ""]
    for sentence in sentences(notes):
        lines += textwrap.wrap(sentence, NOTE_WIDTH)
    label = "".join(f'{html.escape(line)}<br align="left"/>' for line in lines)
    body = "".join(below(root, "n", notes))
    return (f"{diagram.GRAPH}  graph [label=<{label}>, labeljust=l, nodesep=0.08, ranksep=0.4, "
            f"ordering=out];\n"
            f'  edge [dir=both, arrowtail=none];\n{box(root, "n", notes)}{body}}}\n')


def below(node, name, notes):
    """Yields what hangs from a node: its children and their edges, by the kind of their mark."""
    for mark, group in itertools.groupby(enumerate(node.children), lambda item: kind(item[1])):
        start = name
        if mark in CARDINALITIES and node.mark != BRANCH:
            start = f"{name}_{mark}"
            yield point(name, start, mark, node)
        for number, child in group:
            end = f"{name}_{number}"
            yield box(child, end, notes)
            yield edge(start, end, child)
            yield from below(child, end, notes)


def kind(node):
    """Branches, and what is not offered, hang from the point of the alternatives that they sort."""
    return ALTERNATIVE if node.mark == BRANCH else node.mark


def point(parent, name, mark, node):
    """The variation point before alternatives or some-of."""
    fill = diagram.INK if mark == OR else "white"
    return (f'  "{name}" [shape=triangle, orientation=90, width=0.16, height=0.16, fixedsize=true, '
            f'label="", style=filled, fillcolor="{fill}", xlabel=<<font point-size="9">'
            f'{CARDINALITIES[mark]}</font>>];\n  "{parent}" -> "{name}" [arrowhead=none];\n')


def box(node, name, notes):
    title = "<br/>".join(map(html.escape, textwrap.wrap(node.title, WIDTH)))
    if node.state == EXCLUDED:
        title = f"<s>{title}</s>"
    muted = " ".join(filter(None, [node.name, references(node, notes)]))
    label = f"{title}<br/>{small(muted)}" if muted else title
    return f'  "{name}" [label=<{label}>, margin="0.08,0.03", height=0.2, {look(node)}];\n'


def small(text):
    return f'<font point-size="9" color="{diagram.MUTED}">{html.escape(text)}</font>'


def look(node):
    if node.mark == ABSENT:
        return f'style=dashed, fontcolor="{diagram.MUTED}"'
    if node.mark == BRANCH and node.state != CHOSEN:
        return 'style="rounded,filled", fillcolor="#f4f5f7"'
    if node.state == CHOSEN:
        return f'style=filled, fillcolor="{CHOICE}", color="{diagram.NEW}"'
    return 'style=filled, fillcolor="white"'


def edge(start, end, node):
    head = HEADS.get(node.mark, "none")
    dashes = ", style=dashed" if node.mark == ABSENT else ""
    return f'  "{start}" -> "{end}" [arrowhead={head}{dashes}];\n'
