# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part landmarks: CPU time and memory against map size, beside MRPT's kf-slam."""
import dataclasses
from typing import Optional

from slam_eval.bench.harness.products import EKF_WHEEL
from slam_eval.bench.harness.programs import system_program
from slam_eval.bench.harness.runs import call
from slam_eval.bench.harness.table import ABSENT, Section, number, table, verdict
from slam_eval.bench.peers import mrpt_config as mrpt
from slam_eval.bench.peers.kf_slam import kf_slam_on_rawlog, ours_on_rawlog, Result
from slam_eval.plot.benchmarks import plot_cpu

GOALS = {300: 15.0, 1000: 300.0}  # times less CPU than kf-slam

COST = ["landmarks", "seen", "ours CPU [s]", "kf-slam CPU [s]", "ratio", "goal",
        "ours memory [MB]", "kf-slam memory [MB]"]
ACCURACY = ["landmarks", "ours [mm]", "kf-slam [mm]", "ours, aligned [mm]",
            "kf-slam, aligned [mm]"]


@dataclasses.dataclass
class Size:
    """Both results in a world of so many landmarks."""

    landmarks: int
    ours: Result
    theirs: Optional[Result]

    @property
    def ratio(self):
        """How many times less CPU ours takes, or None."""
        return None if self.theirs is None else self.theirs.usage.cpu_s / self.ours.usage.cpu_s


def _of(result, pick, form):
    return number(None if result is None else pick(result), form)


def cost_row(size):
    """A line of the table of CPU time and memory."""
    both, ratio = (size.ours, size.theirs), size.ratio
    goal = GOALS.get(size.landmarks) if ratio is not None else None
    return [str(size.landmarks), number(size.ours.errors["matched"], "d"),
            *(_of(result, lambda r: r.usage.cpu_s, ".2f") for result in both),
            number(ratio, ".1f"), ABSENT if goal is None else verdict(ratio, goal, False),
            *(_of(result, lambda r: r.usage.max_rss_mb, ".1f") for result in both)]


def accuracy_row(size):
    """A line of the table of mean landmark errors."""
    both = (size.ours, size.theirs)
    return [str(size.landmarks), *(_of(result, lambda r, key=key: 1e3 * r.errors[key], ".3f")
                                   for key in ("mean_m", "aligned_mean_m") for result in both)]


def simulate(context, world):
    """(rawlog, truth) of a world that simul-landmarks makes."""
    folder = context.folder(f"world_{world.landmarks}")
    (folder / "world.ini").write_text(mrpt.simulation_ini(world, "world.rawlog"), encoding="ascii")
    call(context, f"simulation of {world.landmarks} landmarks",
         [system_program("simul-landmarks"), "world.ini"], folder / "world.log", folder)
    return folder / "world.rawlog", folder / "world.rawlog_ground_truth.txt"


def measure_size(context, world):
    """Ours and kf-slam in turn on the same log."""
    rawlog, truth = simulate(context, world)
    name = f"{world.landmarks}_landmarks"
    ours, _ = ours_on_rawlog(context, name, rawlog, truth)
    ini = mrpt.kf_slam_ini(world.last_step, world.range_sigma, world.bearing_sigma_deg)
    theirs = kf_slam_on_rawlog(context, name, rawlog, truth, ini, world.last_step)
    return Size(world.landmarks, ours, theirs)


def _remarks(world, with_kf_slam):
    side = world.high - world.low
    cost = (f"simul-landmarks: seed {world.seed}, {world.steps} steps, square path of "
            f"{world.path_side}, {side:g} m x {side:g} m, view {world.view_range:g} m and "
            f"{world.view_angle_deg:g} deg. CPU of the whole process, for ours with reading the "
            "bag (import not counted).")
    accuracy = ("Mean error over the landmarks by one rule: in the frame of the start, and after a "
                "rigid alignment.")
    if not with_kf_slam:
        return cost, accuracy + (" kf-slam is not installed (Debian package mrpt-apps): its "
                                 "columns are left out.")
    return cost, accuracy + (
        f" kf-slam's sensor sigmas are those simulated ({world.range_sigma:g} m, "
        f"{world.bearing_sigma_deg:g} deg), as ours. It leaves out the first frame of a log, which "
        "moves its map as a whole; the alignment takes that away.")


def measure(context):
    """The section of this part."""
    section = Section("Cost against the number of landmarks")
    if system_program("simul-landmarks") is None:
        section.paragraphs.append("Left out: simul-landmarks is not installed (Debian package "
                                  "mrpt-apps).")
        return section
    worlds = [mrpt.World(size) for size in context.options.sizes]
    sizes = [measure_size(context, world) for world in worlds]
    cost, accuracy = _remarks(worlds[0], sizes[0].theirs is not None)
    section.paragraphs += [table(COST, [cost_row(size) for size in sizes]), cost,
                           table(ACCURACY, [accuracy_row(size) for size in sizes]), accuracy]
    path = context.out / "cpu_of_landmarks.png"
    plot_cpu(sizes, EKF_WHEEL, path)
    section.pictures["CPU time against landmarks"] = path
    return section
