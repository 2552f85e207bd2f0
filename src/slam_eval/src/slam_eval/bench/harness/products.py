# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The products that are measured, and what a simulated drive has to hold for them."""
import dataclasses

import yaml

from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import package_folder

EKF_WHEEL = "ekf_wheel"
GRAPH_WHEEL = "graph_wheel"
PF_WHEEL_GRID = "pf_wheel_grid"
SENSORS = "odom,camera"
ODOMETRY_OF_LOGS = ("none", "wheel", "laser", "laser_wheel")


@dataclasses.dataclass(frozen=True)
class Twin:
    """A product that another one is compared with on the same drives."""

    product: str
    limit: float  # of the mean error over this one's [1]


def sensors_for(product):
    """What a drive for this product has to hold."""
    return f"{SENSORS},ceiling_camera" if twin_of(product) else SENSORS


def map_sensors_for(product):
    """What a drive has to hold for a product whose map comes from a camera, from one that looks at the
    ceiling, or from a laser."""
    file = package_folder("slam_launch") / "products" / f"{product}.yaml"
    if not file.is_file():
        raise BenchError(f"there is no product {product}; products are the files in {file.parent}")
    features = yaml.safe_load(file.read_text(encoding="utf-8"))
    detector = features.get("detector", "none")
    if detector.startswith("laser_") or makes_a_grid(features):
        return "odom,scan"
    return "odom,ceiling_camera" if detector == "ceiling_features" else sensors_for(product)


def twin_of(product):
    """For one of our products that look at the ceiling the one with wheels instead, where the ceiling
    takes the markers' place the one with markers; else None."""
    backend, _, rest = product.partition("_")
    if rest == "ceiling":
        return Twin("pf_visual", 1.5)
    return Twin(f"{backend}_wheel", 1.1) if rest in ("visual", "visual_wheel") else None


def makes_a_grid(features):
    """Whether a product of these features makes its map of a log's scans, and needs no camera."""
    return (features.get("map") == "grid" and features.get("odometry") in ODOMETRY_OF_LOGS
            and features.get("detector", "none") == "none")


def laser_products():
    """The shipped products that make a grid of a laser's scans."""
    files = sorted((package_folder("slam_launch") / "products").glob("*.yaml"))
    return [path.stem for path in files
            if makes_a_grid(yaml.safe_load(path.read_text(encoding="utf-8")))]
