# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The feature model: which features there are and which go together (features/Kconfig).

Features are a map of keys and values: {"backend": "pf", "odometry": "visual", "pointmap": "true"}.
"""

import dataclasses
import functools
import glob
import itertools
import tempfile

import kconfiglib

from . import packages
from .errors import did_you_mean, ProductError
from .kconfig_reasons import reason, requirement

FRONT_END = "Front-end"  # the menu of what runs at the sensors
NEAREST = 3  # products that are named beside a combination that makes none


@dataclasses.dataclass(frozen=True)
class Group:
    """A variation point: a choice of one value, or an optional module (true, false)."""

    key: str
    title: str
    symbols: dict  # name of the Kconfig symbol by value
    default: str   # None where one has to be chosen


class FeatureModel:
    """Reads the model of slam_launch and what other packages add to it."""

    def __init__(self, files=None):
        """Reads other Kconfig files instead, where they are given."""
        if files is None:
            files = [packages.share() / "features" / "Kconfig", *packages.exported("features")]
        self.kconfig = read_kconfig(files)
        self.groups = {group.key: group for group in self._groups()}

    def _groups(self):
        choices = self.kconfig.unique_choices
        modules = [symbol for symbol in self.kconfig.unique_defined_syms
                   if symbol.choice is None and any(node.prompt for node in symbol.nodes)]
        return [choice_group(choice) for choice in choices] + [module_group(s) for s in modules]

    def require_known(self, given):
        """Names a key or value that the model does not have."""
        for key, value in given.items():
            if key not in self.groups:
                raise ProductError(f"there is no feature '{key}'{did_you_mean(key, self.groups)}; "
                                   f"the features are: {', '.join(self.groups)}")
            values = self.groups[key].symbols
            if isinstance(value, (list, tuple)):
                raise ProductError(f"{key} is {' and '.join(map(str, value))}; a product has "
                                   f"exactly one of: {', '.join(values)}")
            if value not in values:
                raise ProductError(f"{key}={value} is not a feature; {key} is one of: "
                                   f"{', '.join(values)}{did_you_mean(str(value), values)}")

    def complete(self, given):
        """Returns the features that a product with the given ones has: defaults added."""
        self.require_known(given)
        missing = [group for key, group in self.groups.items()
                   if key not in given and group.default is None]
        if missing:
            lacks = " and ".join(f"{group.key} (one of: {', '.join(group.symbols)})"
                                 for group in missing)
            raise ProductError(f"a product needs {lacks}, which is not given")
        return {key: given.get(key, group.default) for key, group in self.groups.items()}

    def faults(self, features):
        """Returns why complete features make no product: a sentence for each constraint."""
        self.put_in_force(features)
        wanted = [self._symbol(key, value) for key, value in features.items() if value != "false"]
        sentences = [reason(symbol, self.describe) for symbol in [*wanted, self.root()]
                     if symbol is not None and symbol.tri_value == 0]
        unwanted = [key for key, value in features.items()
                    if value == "false" and self._symbol(key, "true").tri_value != 0]
        sentences += [f"{key} is needed by the other features" for key in unwanted]
        return list(dict.fromkeys(sentences))

    def require_valid(self, given):
        """Returns complete features that make a product."""
        features = self.complete(given)
        faults = self.faults(features)
        if faults:
            raise ProductError(f"{text(features)} makes no product: {'; '.join(faults)}. "
                               f"The nearest valid products are: "
                               f"{'; '.join(map(text, self.nearest(features)))}")
        return features

    def valid(self):
        """Returns the features of every valid product."""
        return self._valid

    @functools.cached_property
    def _valid(self):
        values = [group.symbols for group in self.groups.values()]
        combinations = [dict(zip(self.groups, chosen)) for chosen in itertools.product(*values)]
        before = combinations[0]
        self.put_in_force(before)
        valid = []
        for features in combinations:  # tens of thousands: what has not changed is not set again
            for key in features:
                if features[key] != before[key]:
                    self._set(key, features[key])
            if self._is_whole(features):
                valid.append(features)
            before = features
        return valid

    def _is_whole(self, features):
        """Whether the features, which are in force, all have the values that they were given."""
        root = self.root()
        return (root is None or root.tri_value != 0) and all(
            (self._symbol(key, value).tri_value == 0) == (value == "false")
            for key, value in features.items())

    def nearest(self, features):
        """Returns the valid products that share most features with these."""
        def same(other):
            return sum(other[key] == value for key, value in features.items())
        valid = self.valid()
        most = max(map(same, valid), default=0)
        return [other for other in valid if same(other) == most][:NEAREST]

    def needed_by(self, section, features):
        """Returns which feature a product file's section belongs to, where that is not chosen."""
        symbol = self.kconfig.syms.get("SECTION_" + section.upper())
        if symbol is None:
            return None
        self.put_in_force(features)
        return None if symbol.tri_value else requirement(symbol.direct_dep, self.describe)

    def strings(self, prefix, features):
        """Returns what the features bring: LIBRARY_... to load, LAUNCH_... files to include."""
        return list(self.named_strings(prefix, features).values())

    def named_strings(self, prefix, features):
        """Returns the same by what stands behind the prefix."""
        self.put_in_force(features)
        values = {symbol.name[len(prefix):]: symbol.str_value
                  for symbol in self.kconfig.unique_defined_syms if symbol.name.startswith(prefix)}
        return {name: value for name, value in values.items() if value}

    def launch_files(self, features):
        """Returns PACKAGE/FILE of what the features launch, {"frontend": [...], "backend": [...]}:
        the front-end's for a feature of that menu, all others beside the back-end."""
        self.put_in_force(features)
        files = {"frontend": [], "backend": []}
        for symbol in self.kconfig.unique_defined_syms:
            if symbol.name.startswith("LAUNCH_") and symbol.str_value:
                half = "frontend" if is_for(symbol, FRONT_END) else "backend"
                files[half].append(symbol.str_value)
        return files

    def launches(self, features):
        """Returns the keys of the features that each PACKAGE/FILE is launched for."""
        keys = {name: key for key, group in self.groups.items() for name in group.symbols.values()}
        launched = self.named_strings("LAUNCH_", features)
        wanted = {file: wanted_by(self.kconfig.syms["LAUNCH_" + name])
                  for name, file in launched.items()}
        return {file: {keys[item.name] for item in items if item.name in keys}
                for file, items in wanted.items()}

    def describe(self, symbol):
        """Returns KEY=VALUE for a feature's symbol, else its name."""
        for key, group in self.groups.items():
            for value, name in group.symbols.items():
                if name == symbol.name and value != "false":
                    return f"{key}={value}"
        return symbol.name

    def chosen(self):
        """Returns the features that are in force in the Kconfig object, as a menu leaves it."""
        return {key: next(value for value in group.symbols
                          if self._symbol(key, value).tri_value == (0 if value == "false" else 2))
                for key, group in self.groups.items()}

    def put_in_force(self, features):
        """Sets complete features, whose symbols then have the values that follow."""
        self.kconfig.unset_values()
        for key, value in features.items():
            self._set(key, value)

    def _set(self, key, value):
        self._symbol(key, value).set_value(0 if value == "false" else 2)

    def _symbol(self, key, value):
        return self.kconfig.syms[self.groups[key].symbols[value]]

    def root(self):
        """Returns the symbol of the whole, which asks for some of each group; None without one."""
        return self.kconfig.syms.get("SLAM")


def choice_group(choice):
    prefix = choice.name + "_"
    for symbol in choice.syms:
        if not symbol.name.startswith(prefix):
            raise ProductError(f"the feature model: {symbol.name_and_loc} is one of the choice "
                               f"{choice.name}; its name has to begin with {prefix}")
    symbols = {symbol.name[len(prefix):].lower(): symbol.name for symbol in choice.syms}
    default = next((value for value, name in symbols.items()
                    if choice.defaults and choice.defaults[0][0].name == name), None)
    title = next(node.prompt[0] for node in choice.nodes if node.prompt)
    return Group(choice.name.lower(), title, symbols, default)


def module_group(symbol):
    title = next(node.prompt[0] for node in symbol.nodes if node.prompt)
    return Group(symbol.name.lower(), title, {"false": symbol.name, "true": symbol.name}, "false")


def is_for(symbol, menu):
    """Whether a symbol's value is asked for by a feature within a menu."""
    return any(stands_in(getattr(item, "choice", None) or item, menu) for item in wanted_by(symbol))


def wanted_by(symbol):
    """Returns the symbols and choices that a symbol's values depend on."""
    return {item for _, condition in symbol.defaults for item in kconfiglib.expr_items(condition)}


def stands_in(item, menu):
    for node in item.nodes:
        while node := node.parent:
            if node.prompt and node.prompt[0] == menu:
                return True
    return False


def read_kconfig(files):
    """Returns one Kconfig object of several files."""
    with tempfile.NamedTemporaryFile("w", encoding="utf-8", suffix=".Kconfig") as root:
        for path in files:
            root.write(f'source "{kconfiglib.escape(glob.escape(str(path)))}"\n')
        root.flush()
        try:
            return kconfiglib.Kconfig(root.name, warn=False)
        except (kconfiglib.KconfigError, OSError) as error:
            raise ProductError(f"the feature model cannot be read: {error}") from error


def mentioned(features):
    """Returns the features without what is left out: a module, or a second detector."""
    return {key: value for key, value in features.items()
            if value != "false" and (key, value) != ("second_detector", "none")}


def text(features):
    """Returns KEY=VALUE KEY=VALUE; what is left out is not mentioned."""
    return " ".join(f"{key}={value}" for key, value in mentioned(features).items())
