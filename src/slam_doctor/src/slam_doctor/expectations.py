# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is to be found: the robot file, and what products take in, as slam_launch tells it."""
import dataclasses
import functools
import re
import subprocess
from typing import Optional

from slam_launch import config_files, packages, parameters, ports, products
from slam_launch.errors import ProductError
from slam_launch.feature_model import FeatureModel

from slam_doctor.errors import InputError, UsageError

# The inputs that a second camera and a second laser bring, with the kinds of their data.
SECOND_SENSORS = {"rear_camera": "slam::CameraView", "rear_scan": "slam::LaserScan"}


@dataclasses.dataclass(frozen=True)
class Robot:
    """A robot file."""

    name: str
    content: dict
    fault: str = ""  # why it cannot be read; without a name: why there is none

    def value(self, section, key):
        """A value, or its default; None where no component describes it."""
        values = self.content.get(section)
        if isinstance(values, dict) and key in values:
            return values[key]
        return defaults().get(f"{section}.{key}")


NO_ROBOT = Robot("", {})


@functools.lru_cache(maxsize=None)
def defaults():
    """The defaults of all parameters by SECTION.KEY, numbers and texts, as the program
    slam_parameters tells them. Raises InputError."""
    try:
        program = packages.program("slam_ros", "slam_parameters")
    except ProductError as fault:
        raise InputError(str(fault)) from None
    page = subprocess.run([program], text=True, stdout=subprocess.PIPE, check=False).stdout
    found = {}
    for section, table in re.findall(r"^## Section `(\w+)`$(.*?)(?=^## |\Z)", page, re.M | re.S):
        for key, default in re.findall(r"^\| `(\w+)` \|(?: [^|`]+ \|)? `([^`]*)` \|", table, re.M):
            found[f"{section}.{key}"] = plain(default)
    return found


def plain(text):
    """A default as a number where it is one."""
    try:
        return float(text)
    except ValueError:
        return text


def read_robot(name):
    """The Robot of a name or file. Raises UsageError."""
    try:
        path = config_files.find("robots", name)
        content = config_files.load(path)
    except ProductError as fault:
        raise UsageError(str(fault)) from None
    try:
        parameters.require_valid_robot(path, [])
    except ProductError as fault:
        return Robot(name, content, str(fault))
    return Robot(name, content)


@dataclasses.dataclass(frozen=True)
class Need:
    """What a product takes in from outside, or may take from a bag instead of making it."""

    input: str             # its name, such as `scan`
    topic: str             # where the robot file names no other
    kind: str              # of the data, as C++ calls it
    sentence: str          # for people
    is_mandatory: bool
    replaced_by: frozenset  # kinds of data that a bag may hold instead


@dataclasses.dataclass(frozen=True)
class Product:
    """A product with what it needs."""

    name: str
    detectors: tuple  # the first one first
    needs: tuple


def read_product(name):
    """The Product of a name or file. Raises UsageError."""
    try:
        product = products.find(name, FeatureModel())
        return with_needs(product, ports.of_product(product))
    except ProductError as fault:
        raise UsageError(str(fault)) from None


def all_products():
    """Every Product that has a name. Raises InputError."""
    try:
        named = list(products.named(FeatureModel()))
        return [with_needs(*each) for each in zip(named, ports.of_products(named))]
    except ProductError as fault:
        raise InputError(str(fault)) from None


def with_needs(product, told):
    """The Product of slam_launch's product, by its ports."""
    needs = tuple(Need(port.name, port.topic, port.kind, port.sentence, port.is_mandatory,
                       frozenset(output.kind for output in component.outputs if output.kind))
                  for component in told.components for taken in component.inputs
                  for port in ports.before_gates(taken, told) if port.made_by is None)
    made = tuple(Need(output.name, output.topic, output.kind, output.name, False, frozenset())
                 for component in told.components for output in component.outputs if output.kind)
    named = (product.features.get(key, "none") for key in ("detector", "second_detector"))
    return Product(product.name or "this product",
                   tuple(name for name in named if name != "none"), needs + made)


@dataclasses.dataclass(frozen=True)
class Expectations:
    """What a recording is checked against."""

    robot: Robot
    product: Optional[Product]  # None: whatever any product could use
    products: tuple             # that product alone, or all

    def base(self):
        """The robot's frame."""
        return str(self.robot.value("frames", "base") or "base_link")

    def odom(self):
        """Odometry's frame."""
        return str(self.robot.value("frames", "odom") or "odom")

    def inputs(self):
        """{name of an input: its topic} of the products, by the robot file. That of a second sensor,
        which no named product has, is looked for where the robot file names it."""
        topics = {need.input: need.topic for product in self.products for need in product.needs}
        own = self.robot.content.get("topics") or {}
        for name in SECOND_SENSORS:
            if self.product is None and name in own:
                topics.setdefault(name, own[name])
        return {name: str(own.get(name, topic)) for name, topic in topics.items()}
