# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A product's ports and their wiring: each component with what it takes in (left) and makes (right),
by name and kind of data, and what the data do to time. Gates are those of the wiring."""

import html

from . import diagram, ports

MULTIPLICITY = " [0..1]"  # of an input that the component can do without
TIMES = {"trigger": "&#9654;", "carrier": "&#8614;", "latched": "&#9632;"}
LEGEND = "&#9654; trigger: worth a step   &#8614; carrier: moves time on   &#9632; latched: in force " \
         "from then on   [0..1] optional"
FILLS = {"gate": "#f4f5f7", "additional module": diagram.FILLS["Additional modules"],
         "stage": diagram.FILLS["Back-end"], "back-end": diagram.FILLS["Back-end"]}


def draw(product, path):
    """Writes the diagram as SVG, PNG, PDF or in graphviz's language, by the file's name."""
    diagram.write(path, dot(ports.of_product(product)))


def dot(product):
    """Returns the diagram in graphviz's language."""
    parts = [*product.components, *product.gates]
    boxes = [box(part) for part in parts]
    return (f'{diagram.GRAPH}  graph [label="{LEGEND}", ranksep=1.1];\n  node [shape=plain];\n'
            f'{"".join(boxes)}{"".join(outside(parts))}{"".join(edges(product))}}}\n')


def identity(part):
    """Two detectors may have one name: the one at the rear camera is told by its key."""
    has_own_name = part.key is None or part.key in part.features
    return f"{part.role} {part.name if has_own_name else part.key}"


def box(part):
    inputs = [cell(f"in{number}", f"{TIMES[port.time]} {port.name}"
                   f"{'' if port.is_mandatory else MULTIPLICITY}", port.kind)
              for number, port in enumerate(part.inputs)]
    outputs = [cell(f"out{number}", port.name, port.kind, "right")
               for number, port in enumerate(part.outputs)]
    rows = max(len(inputs), len(outputs))
    empty = "<td></td>"
    pairs = zip(inputs + [empty] * (rows - len(inputs)), outputs + [empty] * (rows - len(outputs)))
    lines = "".join(f"<tr>{left}{right}</tr>" for left, right in pairs)
    return (f'  "{identity(part)}" [label=<<table cellspacing="0" cellpadding="5" '
            f'cellborder="0" color="#9aa1aa" bgcolor="{FILLS.get(part.role, "#e8f1ee")}">'
            f'<tr><td colspan="2">{muted(f"«{part.role}»")}<br/><b>{html.escape(part.name)}</b>'
            f"</td></tr><hr/>{lines}</table>>];\n")


def cell(port, name, kind, side="left"):
    lines = [name, muted(html.escape(kind))] if kind else [name]
    text = "".join(f'{line}<br align="{side}"/>' for line in lines)
    return f'<td port="{port}" align="{side}" balign="{side}">{text}</td>'


def muted(text):
    return f'<font point-size="9" color="{diagram.MUTED}">{text}</font>'


def outside(parts):
    """Returns the nodes of what no component makes, by topic, and of where it comes from."""
    topics = {port.topic for part in parts for port in part.inputs if is_outside(port)}
    return [f'  "topic {topic}" [label="{topic}", shape=box, {diagram.END}];\n'
            for topic in sorted(topics)]


def is_outside(port):
    return not port.made_by and not port.gate


def edges(product):
    makers = {part.key: part for part in product.components}
    gates = {gate.name: gate for gate in product.gates}
    for part in [*product.components, *product.gates]:
        for number, port in enumerate(part.inputs):
            maker = makers.get(port.made_by) or gates.get(port.gate)
            start = source(maker, port) if maker else f'"topic {port.topic}":e'
            yield f'  {start} -> "{identity(part)}":in{number}:w;\n'


def source(maker, port):
    """Returns the output of the maker that goes to an input."""
    number = next(number for number, output in enumerate(maker.outputs)
                  if (output.name, output.kind) == (port.name, port.kind))
    return f'"{identity(maker)}":out{number}:e'
