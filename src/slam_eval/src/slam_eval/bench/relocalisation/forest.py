# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part forest: trees without ids that a laser sees, by a car that is switched on somewhere, or that is
carried away while it maps."""
import dataclasses
import pathlib

import numpy as np

from slam_eval.bench.harness import bag_edit
from slam_eval.bench.harness.process import run
from slam_eval.bench.harness.programs import workspace_program
from slam_eval.bench.relocalisation.cases import Cases, map_of
from slam_eval.bench.relocalisation.log import Log
from slam_eval.bench.relocalisation.markers import seen_in
from slam_eval.bench.relocalisation.starts import Case, SECOND, Start
from slam_eval.io.trajectory import Trajectory

PRODUCT, SETTINGS = "ekf_wheel_trunks", ("detector=none",)
LIMIT = 10.0  # [s]
THEN = 12     # a drive goes on so long after its start [s]
LAP = 80      # the first lap takes less [s]
NOTICED = 3   # a robot that was carried has to know so much later that it is lost [s]
CARRIED_THEN = 20  # a drive goes on so long after the robot was put down [s]


def simulated(context):
    """The bag of a car's drive through the forest."""
    bag = context.work / "forest.bag"
    context.progress.begin("forest: simulation")
    run([workspace_program("slam_sim", "slam_sim"), bag, "--world", "forest", "--robot", "car",
         "--seed", str(context.options.seed), "--only", "odom,scan"],
        context.work / "forest_simulation.log")
    return bag


@dataclasses.dataclass
class CarriedCase(Case):
    """Cars that map from the drive's beginning on, and are carried in the second lap: a start is
    where they are lifted. whole: the bag of the drive."""

    whole: pathlib.Path = None
    begins_with_map: bool = False

    def _put(self, start):
        """The stamp [ns] of where the car is put down: 8 to 40 s further on the way."""
        return start.stamp + (8 + start.stamp // SECOND % 33) * SECOND

    def write_bag(self, start, number_, target):
        at, until = ((stamp - self.log.start) / SECOND for stamp in (start.stamp, self._put(start)))
        carried = bag_edit.Carried(at, until, CARRIED_THEN)
        bag_edit.rewrite(self.whole, target, carried=carried)

    def truth_of(self, start):
        stamps, put = self.truth.stamps, self._put(start)
        before, after = stamps < start.stamp, stamps >= put
        moved = stamps - np.where(after, put - start.stamp, 0)
        return Trajectory(moved[before | after], self.truth.poses[before | after])


def measure(context):
    """The section of this part."""
    cases = Cases(context, "Trees without ids")
    bag = simulated(context)
    log = Log(bag, seen_in(context, "forest", bag, PRODUCT))
    whole = log.write(context.work / "forest_log.bag")
    folder, truth = map_of(context, "forest", whole, PRODUCT, SETTINGS)

    def start_of(stamp):
        end = stamp + THEN * SECOND
        return Start(stamp, stamp, end) if end < log.end else None

    def lifted(stamp):
        is_late = log.end - stamp < (40 + CARRIED_THEN) * SECOND
        if stamp - log.start < LAP * SECOND or is_late:
            return None
        return Start(stamp, stamp, log.end, stamp + NOTICED * SECOND)

    case = Case("forest", log, folder, truth, PRODUCT, SETTINGS, LIMIT)
    cases.add(case, start_of, least=0.95)
    carried = CarriedCase(**{**vars(case), "name": "forest carried", "begins_with_map": False},
                          whole=whole)
    cases.add(carried, lifted, least=0.95)
    return cases.finished(
        "Time counts from the start, or from where the car is lifted. A car that is carried maps "
        f"until then; its poses are judged from {NOTICED} s later on, so that the times are no less.")
