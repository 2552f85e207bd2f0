# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part grid: a laser in the grid of a building, simulated ones and those of bags."""
import dataclasses

import numpy as np

from slam_eval.bench.harness import bag_edit
from slam_eval.bench.harness.buildings import write_building
from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.runs import simulate
from slam_eval.bench.relocalisation.cases import Cases, map_of
from slam_eval.bench.relocalisation.log import Log, Slip
from slam_eval.bench.relocalisation.starts import Case, SECOND, Start
from slam_eval.io.run_folder import read_run
from slam_eval.metrics.evaluation import trajectory_error

PRODUCT, SETTINGS = "scan_grid_wheel", ("grid.mode=localization",)
LIMIT = 10.0      # [s]
THEN = 12         # a drive goes on so long after its start [s]
LEAST_WAY = 2.0   # that is driven within LIMIT [m]
LEAST_FOUND = 0.95
MOST_BUILDINGS, LARGEST_MAP_ERROR = 10, 0.3  # buildings that are tried; of one that is right [m]
SLIP_AFTER, SLIP_TURN, SLIP_WAY = 1, 0.3, 0.2  # [s], [rad], [m]
EVERY = 5.0       # mean time between two people who come by [s]
REMARK = (f"Starts are where the robot drives {LEAST_WAY:g} m or more in the next {LIMIT:g} s.")


@dataclasses.dataclass
class TroubledCase(Case):
    """Wheels slip while the robot is looked for."""

    def change_of(self, start, number_):
        side = 1 if number_ % 2 else -1
        return Slip(start.stamp + SLIP_AFTER * SECOND, side * SLIP_TURN, SLIP_WAY)


def driving(log, truth):
    """Makes a Start of a stamp at which the robot is under way."""
    steps = np.hypot(*np.diff(truth.poses[:, :2], axis=0).T)
    way = np.concatenate([[0.0], np.cumsum(steps)])

    def start_of(stamp):
        end = stamp + THEN * SECOND
        begin, later = np.interp([stamp, stamp + LIMIT * SECOND], truth.stamps, way)
        return Start(stamp, stamp, end) if later - begin >= LEAST_WAY and end < log.end else None
    return start_of


def case_of(context, name, bag, robot=None):
    """A case with the map of its own drive, and what makes its starts."""
    folder, truth = map_of(context, name, bag, PRODUCT, robot=robot)
    log = Log(bag)
    return Case(name, log, folder, truth, PRODUCT, SETTINGS, LIMIT, robot), driving(log, truth)


def _building(context, seed):
    """(case, what makes its starts, bag) of the first building from a seed on whose map is right."""
    for tried in range(seed, seed + MOST_BUILDINGS):
        name = f"building_{tried}"
        world = write_building(context.work / f"{name}.yaml", tried)
        bag = simulate(context, name, world, tried, "odom,scan")
        case, start_of = case_of(context, name, bag)
        run = read_run(case.map_folder)
        if trajectory_error(run.trajectory, run.truth).max < LARGEST_MAP_ERROR:
            return case, start_of, bag
    raise BenchError(f"the maps of the buildings {seed} to {tried} are all wrong; take another --seed")


def measure(context):
    """The section of this part."""
    cases, seed = Cases(context, "Grids"), context.options.seed
    case, start_of, bag = _building(context, seed)
    cases.add(case, start_of, least=LEAST_FOUND)
    crowd = bag.with_name("people.bag")
    bag_edit.rewrite(bag, crowd, bag_edit.People(seed, EVERY))
    cases.add(TroubledCase(**{**vars(case), "name": f"{case.name}_people_slips",
                              "log": Log(crowd)}),
              start_of, least=LEAST_FOUND)
    other, start_of, _ = _building(context, seed + 100)
    cases.add(dataclasses.replace(other, name="wrong_map", map_folder=case.map_folder), start_of)
    for path in context.options.bag:
        cases.add(*case_of(context, path.stem, path, context.options.robot), least=LEAST_FOUND)
    return cases.finished(
        REMARK, f"people_slips: people walk by, and {SLIP_AFTER} s after the start the wheels slip by "
        f"{SLIP_TURN} rad and {SLIP_WAY} m. wrong_map: the robot is in another building, so that it "
        "cannot be right.")
