# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The files of one run, read and checked against each other."""
import dataclasses
import json
import pathlib
from typing import Optional

import numpy as np
import yaml

from slam_eval.io.errors import InputError, read_text
from slam_eval.io.events import read_events
from slam_eval.io.graph import Graph, read_graph
from slam_eval.io.grid_map import GridMap, read_grid
from slam_eval.io.landmarks import LandmarkMap, read_labels, read_landmarks
from slam_eval.io.places import PlaceVisits, read_places
from slam_eval.io.point_cloud import read_points
from slam_eval.io.trajectory import Trajectory, read_trajectory, read_truth
from slam_eval.io.updates import Updates, read_updates
from slam_eval.io.views import read_views, Views


@dataclasses.dataclass
class RunFolder:
    """One run. What the run did not write is None (metrics: empty, config: empty text).

    truth_is_given: the true poses are of a file that the caller named, so that they may be in
    another frame than the true landmarks.
    """

    path: pathlib.Path
    trajectory: Trajectory
    final: Optional[Trajectory] = None
    odometry: Optional[Trajectory] = None
    wheels: Optional[Trajectory] = None
    truth: Optional[Trajectory] = None
    truth_is_given: bool = False
    updates: Optional[Updates] = None
    landmarks: Optional[LandmarkMap] = None
    labels: dict = dataclasses.field(default_factory=dict)  # of landmarks, by their ids
    grid: Optional[GridMap] = None
    points: Optional[np.ndarray] = None
    graph: Optional[Graph] = None
    places: Optional[PlaceVisits] = None
    views: Optional[Views] = None
    events: Optional[list] = None
    true_landmarks: Optional[LandmarkMap] = None
    metrics: dict = dataclasses.field(default_factory=dict)
    config_text: str = ""
    config: dict = dataclasses.field(default_factory=dict)

    @property
    def title(self):
        """Product and robot of the run, or the folder's name where the run does not say."""
        names = [str(self.config[k]) for k in ("product", "robot") if self.config.get(k)]
        return " on ".join(names) if names else self.path.resolve().name

    @property
    def maps_ceiling(self):
        """Whether its landmarks are spots of the ceiling, of which no ground truth is known."""
        return self.config.get("detector") == "ceiling_features"


def _optional(path, reader):
    return reader(path) if path.exists() else None


def read_metrics(path):
    """metrics.json as a dictionary; empty where there is no such file."""
    if not path.exists():
        return {}
    try:
        metrics = json.loads(read_text(path))
    except json.JSONDecodeError as error:
        raise InputError(f"{path}:{error.lineno}: no valid JSON; delete the file or run the "
                         "product again") from None
    if not isinstance(metrics, dict):
        raise InputError(f"{path}: not a table of names and values; delete the file or run the "
                         "product again")
    return metrics


def _read_config(path):
    if not path.exists():
        return "", {}
    text = read_text(path)
    try:
        config = yaml.safe_load(text)
    except yaml.YAMLError:
        raise InputError(f"{path}: no valid YAML; run the product again") from None
    return text, config if isinstance(config, dict) else {}


def _check_same_stamps(path, stamps, trajectory):
    if len(stamps) != len(trajectory) or np.any(stamps != trajectory.stamps):
        raise InputError(f"{path}: its stamps are not those of trajectory.tum ({len(stamps)} lines "
                         f"against {len(trajectory)}); the files are of different runs or cut off, "
                         "run the product again")


def read_run(path):
    """Read a run folder. Raises InputError."""
    path = pathlib.Path(path)
    if not path.is_dir():
        raise InputError(f"{path}: no such folder; give the folder that a run wrote")
    if not (path / "trajectory.tum").exists():
        raise InputError(f"{path}: holds no trajectory.tum, so it is no folder of a run; "
                         "give the folder that a run wrote")
    run = RunFolder(path, read_trajectory(path / "trajectory.tum"))
    run.final = _optional(path / "trajectory_final.tum", read_trajectory)
    run.odometry = _optional(path / "odometry.tum", read_trajectory)
    run.wheels = _optional(path / "wheel_odometry.tum", read_trajectory)
    run.truth = _optional(path / "ground_truth.tum", read_truth)
    run.updates = _optional(path / "updates.csv", read_updates)
    run.landmarks = _optional(path / "landmarks.yaml", read_landmarks)
    if run.landmarks is not None:
        run.landmarks.has_own_ids = (path / "associations.csv").exists()
    run.labels = _optional(path / "labels.yaml", read_labels) or {}
    run.grid = _optional(path / "map.yaml", read_grid)
    run.graph = _optional(path / "graph.csv", read_graph)
    run.places = _optional(path / "places.csv", read_places)
    run.views = _optional(path / "views.csv", read_views)
    run.events = _optional(path / "events.csv", read_events)
    run.points = _optional(path / "points.pcd", read_points)
    run.metrics = read_metrics(path / "metrics.json")
    run.config_text, run.config = _read_config(path / "config.yaml")
    if not run.maps_ceiling:
        run.true_landmarks = _optional(path / "ground_truth_landmarks.yaml", read_landmarks)
    if run.updates is not None:
        _check_same_stamps(path / "updates.csv", run.updates.stamps, run.trajectory)
    return run
