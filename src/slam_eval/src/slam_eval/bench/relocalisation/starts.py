# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Robots that are switched on at random times of a drive, in the map of that drive."""
import concurrent.futures
import dataclasses
import pathlib
import random
import shutil

import numpy as np

from slam_eval.bench.harness import process
from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import workspace_program
from slam_eval.bench.harness.table import number
from slam_eval.bench.relocalisation.judge import judge, Outcome
from slam_eval.io.atomic_file import write_atomically
from slam_eval.io.run_folder import read_run
from slam_eval.io.trajectory import interpolate

WORKERS = 2  # runs at a time
SECOND = 10**9
MOST_DRAWS = 200  # for each start

HEADER = ["case", "starts", "right in time", "right", "wrong", "did not know", "median [s]",
          "worst [s]"]


@dataclasses.dataclass(frozen=True)
class Start:
    """Where a drive is entered: stamp [ns], when the time that counts begins, the bag's end, and from
    when on the poses are judged."""

    stamp: int
    counts_from: int
    end: int
    judged_from: int = 0


@dataclasses.dataclass
class Case:
    """What the starts of a row have in common.

    log: of the drive; truth: a Trajectory in the frame of map_folder's map; limit: time within
    which a robot should be found [s].
    """

    name: str
    log: object
    map_folder: pathlib.Path
    truth: object
    product: str
    settings: tuple
    limit: float
    robot: str = None
    begins_with_map: bool = True

    def write_bag(self, start, number_, target):
        """The bag of the start with this number."""
        self.log.write(target, start.stamp, start.end, self.change_of(start, number_))

    def change_of(self, start, number_):
        """What happens to the robot, for Log.write()."""

    def truth_of(self, start):
        """The truth of the start's bag."""
        return self.truth


def draw(count, seed, log, start_of):
    """Starts at random times; start_of(stamp) makes a Start of one, or None. Raises BenchError."""
    chance, starts = random.Random(seed), []
    for _ in range(MOST_DRAWS * count):
        start = start_of(chance.randrange(log.start, log.end))
        if start is not None:
            starts.append(start)
        if len(starts) == count:
            return starts
    raise BenchError(f"of {MOST_DRAWS * count} places of the drive only {len(starts)} can be starts; "
                     "give a longer drive or fewer --starts")


def _run(context, case, number_, start):
    """The verdict of a start; its bag and its run are removed unless the files are kept."""
    folder = context.folder("starts")
    name = f"{case.name}_{number_}".replace(" ", "_")
    bag, out = folder / f"{name}.bag", folder / f"{name}_run"
    case.write_bag(start, number_, bag)
    command = [workspace_program("slam_ros", "slam_offline"), case.product, "--bag", bag, "--out",
               out]
    command += ["--load-map", case.map_folder] if case.begins_with_map else []
    command += ["--robot", case.robot] if case.robot else []
    command += [word for setting in case.settings for word in ("--set", setting)]
    process.run(command, folder / f"{name}.log")
    verdict = judge(read_run(out), case.truth_of(start), start.counts_from, start.judged_from)
    if context.options.keep is None:
        shutil.rmtree(out)
        bag.unlink()
    return verdict


def run_starts(context, case, starts):
    """The verdicts of all starts, in their order."""
    context.progress.begin(case.name)
    with concurrent.futures.ThreadPoolExecutor(WORKERS) as pool:
        futures = [pool.submit(_run, context, case, i, start) for i, start in enumerate(starts)]
        for done, future in enumerate(futures):
            future.result()
            context.progress.update(f"{done + 1} of {len(starts)} starts")
    return [future.result() for future in futures]


def is_in_time(case, verdict):
    """Whether a robot was found soon enough."""
    return verdict.outcome is Outcome.RIGHT and verdict.seconds <= case.limit


def row(case, verdicts):
    """The line of the table."""
    count = {o: sum(v.outcome is o for v in verdicts) for o in Outcome}
    times = [v.seconds for v in verdicts if v.outcome is Outcome.RIGHT]
    return [case.name, number(len(verdicts), "d"),
            number(sum(is_in_time(case, v) for v in verdicts), "d"),
            *(number(count[o], "d") for o in Outcome),
            number(float(np.median(times)) if times else None, ".1f"),
            number(max(times) if times else None, ".1f")]


def places_of(case, starts):
    """The true poses (N x 3) of the starts, in the map's frame."""
    return interpolate(case.truth, [start.stamp for start in starts], max_gap=60.0)[0]


def write_csv(path, case, starts, verdicts):
    """A line for each start."""
    lines = ["stamp,x,y,heading,outcome,seconds,error_m,turn_rad"]
    for start, pose, v in zip(starts, places_of(case, starts), verdicts):
        figures = [number(x, ".3f") if x is not None else "" for x in (v.seconds, v.error, v.turn)]
        lines.append(",".join([f"{start.stamp / SECOND:.3f}", *(f"{x:.3f}" for x in pose),
                               v.outcome.value, *figures]))
    write_atomically(path, "\n".join(lines) + "\n")
