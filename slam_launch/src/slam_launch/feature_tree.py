# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The feature model as a tree (thesis, Fig. 4.1; marks as in FODA, Kang et al. 1990), and what a
product has chosen of it (Fig. 5.1).

The tree is made of the Kconfig files that packages bring and of the parameters that components
describe; it states nothing of its own.
"""

import dataclasses

import kconfiglib

from . import parameters
from .errors import ProductError
from .feature_model import wanted_by
from .kconfig_reasons import sentence

MANDATORY, OPTIONAL, ALTERNATIVE, OR = "mandatory", "optional", "alternative", "or"
BRANCH, ABSENT = "branch", "not offered"
CHOSEN, EXCLUDED = "chosen", "excluded"
NOT_OFFERED = "not offered: "


@dataclasses.dataclass(frozen=True)
class Node:
    """A feature, a group of features or a branch of a group."""

    title: str
    mark: str            # how it is bound to what it hangs from
    name: str = ""       # KEY=VALUE, of a group of alternatives its KEY
    notes: tuple = ()    # why it is not offered, what it needs, why it does not go with the others
    state: str = ""      # in a product: chosen, excluded, or neither
    children: tuple = ()


class FeatureTree:
    """Makes the tree of a feature model."""

    def __init__(self, model, product=None):
        """Of a product, marks what it has chosen and what its choice excludes."""
        self.model = model
        self.features = product.features if product else None
        self.content = product.content if product else {}
        self.keys = {name: (key, value) for key, group in model.groups.items()
                     for value, name in group.symbols.items() if value != "false"}
        self.branches = [symbol for symbol in model.kconfig.unique_defined_syms
                         if symbol.name.startswith("BRANCH_")]
        self.libraries = [value.name for symbol in model.kconfig.unique_defined_syms
                          if symbol.name.startswith("LIBRARY_") for value, _ in symbol.defaults]
        self.some_of = {term for term in kconfiglib.expr_items(model.root().direct_dep)
                        if term.name} if model.root() else set()
        self.choices = set()
        if product:
            model.faults(self.features)  # puts them in force

    def root(self):
        return Node("SLAM", MANDATORY, state=self._state(True),
                    children=tuple(self._children(self.model.kconfig.top_node)))

    def _children(self, parent):
        """Returns the nodes below one; menus of one title, which packages open again, are one."""
        nodes = {}
        for below in below_of(parent):
            for node in self._nodes(below):
                same = nodes.get((node.name, node.title))
                if same:
                    node = dataclasses.replace(same, children=same.children + node.children,
                                               state=same.state or node.state)
                nodes[node.name, node.title] = node
        return list(nodes.values())

    def _nodes(self, node):
        item = node.item
        if item == kconfiglib.MENU:
            yield self._menu(node)
        elif item == kconfiglib.COMMENT:
            yield absent(node.prompt[0])
        elif isinstance(item, kconfiglib.Choice):
            if item not in self.choices:  # packages open it again
                self.choices.add(item)
                yield self._choice(item)
        elif node.prompt:
            yield self._feature(item, OPTIONAL)
        elif item.name.startswith("PARAMETER_"):
            yield self._parameter(item)
        elif item.name.startswith("BESIDE_"):
            yield self._beside(item)
        elif item.name.startswith("MODEL_"):
            yield Node(title_of(item), OR, state=self._state(item.tri_value == 2))

    def _menu(self, node):
        children = self._children(node)
        symbols = {below.item for below in below_of(node)}
        for group in self.some_of & symbols:
            children = self._as_some_of(group, children)
        is_optional = all(child.mark in (OPTIONAL, ABSENT) for child in children)
        return Node(node.prompt[0], OPTIONAL if is_optional else MANDATORY,
                    state=self._state(any(child.state == CHOSEN for child in children)),
                    children=tuple(children))

    def _as_some_of(self, group, children):
        """Marks the members of an or-group: those that select it, here or elsewhere in the tree."""
        members = [self.model.kconfig.syms[name] for name in self.keys
                   if group in {selected for selected, _ in self.model.kconfig.syms[name].selects}]
        keys = {self.keys[symbol.name][0] for symbol in members}
        here = {child.name.partition("=")[0] for child in children}
        marked = [dataclasses.replace(child, mark=OR)
                  if child.name.partition("=")[0] in keys else child for child in children]
        return marked + [self._feature(symbol, OR, " (stands elsewhere in the tree)")
                         for symbol in members if self.keys[symbol.name][0] not in here]

    def _choice(self, choice):
        key = choice.name.lower()
        members = [self._feature(symbol, ALTERNATIVE) for symbol in choice.syms]
        lacking = [absent(node.prompt[0]) for choice_node in choice.nodes
                   for node in below_of(choice_node) if node.item == kconfiglib.COMMENT]
        return Node(self.model.groups[key].title, MANDATORY, key, state=self._state(True),
                    children=(*self._on_branches(choice, members), *lacking))

    def _on_branches(self, choice, members):
        """Puts the members of a choice on their branches, in the order of the first of each."""
        branch_of = {symbol.name: branch for branch in self.branches
                     for symbol in wanted_by(branch) if symbol.choice is choice}
        grouped = {}
        for symbol, member in zip(choice.syms, members):
            branch = branch_of.get(symbol.name, symbol)
            grouped.setdefault(branch, []).append(member)
        for branch, on_it in grouped.items():
            if branch in self.branches:
                yield Node(branch_title(branch), BRANCH, children=tuple(on_it),
                           state=self._state(any(node.state == CHOSEN for node in on_it)))
            else:
                yield from on_it

    def _feature(self, symbol, mark, remark=""):
        key, value = self.keys[symbol.name]
        name = f"{key}={value}"
        title = next(node.prompt[0] for node in symbol.nodes if node.prompt) + remark
        if self.features is None:
            return Node(title, mark, name, tuple(self._needs(symbol)))
        if self.features[key] == value:
            return Node(title, mark, name, state=CHOSEN)
        reasons = self.model.faults({**self.features, key: value})
        self.model.put_in_force(self.features)
        return Node(title, mark, name, tuple(reasons), EXCLUDED if reasons else "")

    def _needs(self, symbol):
        """Returns what a feature asks of the others, in the model's sentences."""
        return [sentence(term, self.model.describe)
                for term in kconfiglib.split_expr(symbol.direct_dep, kconfiglib.AND)
                if term is not self.model.kconfig.y and term is not symbol.choice]

    def _parameter(self, symbol):
        """A variation point within a component: the values that its description allows."""
        name = next(value.str_value or value.name for value, _ in symbol.defaults)
        values, default = parameters.values_of(name, self.libraries)
        section, _, key = name.partition(".")
        chosen = (self.content.get(section) or {}).get(key, default)
        is_there = self.features is not None and bool(symbol.str_value)
        return Node(title_of(symbol), OPTIONAL, name, state=CHOSEN if is_there else "",
                    children=tuple(Node(value, ALTERNATIVE, state=CHOSEN if is_there and
                                        value == chosen else "") for value in values))

    def _beside(self, symbol):
        """What a launch file of its own adds to products; none of them has chosen it."""
        value, condition = symbol.defaults[0]
        is_excluded = self.features is not None and not symbol.str_value
        needs = [sentence(term, self.model.describe)
                 for term in kconfiglib.split_expr(condition, kconfiglib.AND)
                 if term is not self.model.kconfig.y]
        return Node(title_of(symbol), OPTIONAL, value.name,
                    tuple(needs) if is_excluded or self.features is None else (),
                    EXCLUDED if is_excluded else "")

    def _state(self, is_chosen):
        return CHOSEN if self.features is not None and is_chosen else ""


def absent(comment):
    """Returns the feature that a comment `not offered: NAME: TITLE: REASON` says is lacking."""
    parts = comment.removeprefix(NOT_OFFERED).split(": ", 2)
    if not comment.startswith(NOT_OFFERED) or len(parts) < 3:
        raise ProductError(f"the feature model: the comment '{comment}' is not "
                           f"'{NOT_OFFERED}FEATURE: TITLE: REASON'")
    name, title, reason = parts
    return Node(title, ABSENT, name, (reason,))


def below_of(node):
    """Returns the nodes directly below one."""
    below = node.list
    while below:
        yield below
        below = below.next


def title_of(symbol):
    return " ".join(next(node.help for node in symbol.nodes if node.help).split())


def branch_title(symbol):
    return symbol.defaults[0][0].name


def nodes_of(node):
    """Returns a node and all below it."""
    yield node
    for child in node.children:
        yield from nodes_of(child)
