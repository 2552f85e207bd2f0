# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parameters of products: their names, types and values, as the components describe them.

The descriptions stand in the components and nowhere else; the program slam_parameters has them.
"""

import functools
import re
import subprocess

from . import packages
from .errors import ProductError


def require_valid_file(path, overrides=()):
    """Refuses what components could not read of a product file, and of SECTION.KEY=VALUE that
    count instead of its values and a robot file's."""
    check(["--check", str(path), *options("--set", overrides)])


def require_valid_overrides(overrides, libraries):
    """The same where there is no file."""
    if overrides:
        check([*options("--library", libraries), *options("--set", overrides)])


def require_valid_robot(path, libraries):
    """Refuses what components, those of libraries as well, could not read of a robot file."""
    check([*options("--library", libraries), "--check-robot", str(path)])


def require_valid_parameters(words, libraries):
    """Refuses SECTION.KEY=VALUE that a product file cannot hold."""
    if words:
        check([*options("--library", libraries), *options("--product-parameter", words)])


def of_name(key):
    """Returns SECTION.KEY of all parameters that have this name."""
    return [f"{section}.{key}" for section, table in tables().items()
            if re.search(rf"^\| `{re.escape(key)}` \| ", table, re.M)]


def values_of(name, libraries=()):
    """Returns the values that SECTION.KEY may have, and its default, of a parameter that is a
    choice; of components in libraries as well."""
    section, _, key = name.partition(".")
    row = re.search(rf"^\| `{re.escape(key)}` \|.*$", tables(tuple(libraries)).get(section, ""), re.M)
    cells = [re.findall(r"`(\w+)`", cell) for cell in row[0].split(" | ")] if row else []
    values = max(cells, key=len, default=[])
    default = next((cell[0] for cell in cells[1:] if len(cell) == 1), None)
    if default not in values or len(values) < 2:
        raise ProductError(f"the feature model: {name} is no parameter with a choice of values")
    return values, default


@functools.lru_cache(maxsize=None)
def tables(libraries=()):
    """Returns the table of each section's parameters, in Markdown."""
    return dict(re.findall(r"^## Section `(\w+)`$(.*?)(?=^## |\Z)",
                           call(options("--library", libraries)), re.M | re.S))


def options(name, values):
    return [word for value in values for word in (name, value)]


def check(arguments):
    """Has the program check parameters, which then prints nothing. Raises ProductError."""
    call(arguments)


def call(arguments):
    """Returns what slam_parameters prints. Raises ProductError."""
    name = "slam_parameters"
    done = subprocess.run([packages.program("slam_ros", name), *arguments], text=True,
                          capture_output=True, check=False)
    if done.returncode != 0:
        faults = done.stderr.strip().replace(f"{name}: ", "", 1).splitlines()
        raise ProductError("; ".join(faults) or f"{name} ended with exit code {done.returncode}")
    return done.stdout
