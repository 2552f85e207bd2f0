# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a product's components take in and make.

Their ports say so in the components and nowhere else; the program slam_ports has them.
"""

import dataclasses
import json
import subprocess

from . import packages
from .errors import ProductError
from .feature_model import mentioned

PROGRAM = "slam_ports"
LATCHED = "latched"


@dataclasses.dataclass(frozen=True)
class Input:
    """What a component takes in."""

    name: str
    topic: str           # where the robot file names no other
    sentence: str        # what comes in there, for people
    is_mandatory: bool
    time: str            # trigger, carrier, latched
    kind: str            # of the data, as C++ calls it
    made_by: str = None  # the key of the component that makes it; none: it comes from outside
    gate: str = None     # that makes it fit for use, of what comes from outside


@dataclasses.dataclass(frozen=True)
class Output:
    """What a component makes; without a kind it is only published."""

    name: str
    topic: str
    kind: str = None


@dataclasses.dataclass(frozen=True)
class Component:
    """A component, or a gate, which has no role and no key, with its ports."""

    name: str  # in the registry
    inputs: tuple
    outputs: tuple
    role: str = "gate"
    key: str = None  # of the product file, which names the component there
    features: tuple = ()  # the keys that bring it


@dataclasses.dataclass(frozen=True)
class ProductPorts:
    """The ports of all components of a product, in the order of the data's flow."""

    components: tuple
    gates: tuple
    owns_odometry_edge: bool  # whether the odometry source publishes odom -> base_link itself


def of_product(product):
    """Returns the ProductPorts of a product."""
    return read(ask(product))


def of_products(products):
    """Returns the ProductPorts of each product, several times as fast as one after the other. Of
    products that bring libraries those of the same ones are asked for together."""
    found = [None] * len(products)
    groups = {}
    for i, product in enumerate(products):
        groups.setdefault(tuple(library_words(product)), []).append(i)
    for libraries, members in groups.items():
        lines = "".join(" ".join(feature_words(products[i])) + "\n" for i in members)
        for i, line in zip(members, call(["-", *libraries], lines).splitlines(), strict=True):
            found[i] = read(line)
    return found


def components(libraries=()):
    """Returns the names of all components, those of libraries as well, by the key of their role in
    a product file; additional modules, each a key of its own, by `modules`."""
    words = [word for name in libraries for word in ("--library", name)]
    return json.loads(call([*words, "--components"]))


def before_gates(port, product):
    """Returns the inputs that an input's data come from: where a gate makes data of another name, what
    that gate takes in, in the same nodelet."""
    gate = next((gate for gate in product.gates if gate.name == port.gate), None)
    if gate is None or any(before.name == port.name for before in gate.inputs):
        return [port]
    return [outer for before in gate.inputs if before.time != LATCHED
            for outer in before_gates(before, product)]


def read(text):
    """Returns what the program says of a product as ProductPorts."""
    told = json.loads(text)
    return ProductPorts(tuple(map(component, told["components"])),
                        tuple(map(component, told["gates"])), told["owns_odometry_edge"])


def component(told):
    return Component(**{**told, "inputs": tuple(Input(**port) for port in told["inputs"]),
                        "outputs": tuple(Output(**port) for port in told["outputs"]),
                        "features": tuple(told.get("features", ()))})


def require_joined(product):
    """Refuses a product whose libraries are missing, or whose components cannot be joined by their
    ports: two make the same, or nobody makes what one cannot do without."""
    ask(product, "--check")


def ask(product, *options):
    """Returns what the program says of a product with these features and libraries."""
    return call([*feature_words(product), *library_words(product), *options])


def feature_words(product):
    """What is left out is not mentioned: another package's module is not known without it."""
    return [f"{key}={value}" for key, value in mentioned(product.features).items()]


def library_words(product):
    return [word for name in product.content.get("libraries") or []
            for word in ("--library", name)]


def call(words, lines=""):
    """Returns what the program prints, to which lines are given. Raises ProductError."""
    done = subprocess.run([packages.program("slam_ros", PROGRAM), *words], input=lines, text=True,
                          capture_output=True, check=False)
    if done.returncode != 0:
        faults = done.stderr.strip().replace(f"{PROGRAM}: ", "", 1).splitlines()
        raise ProductError("; ".join(faults) or f"{PROGRAM} ended with exit code {done.returncode}")
    return done.stdout
