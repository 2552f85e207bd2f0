# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part drives of benchmark lost: drives through random buildings among people, with right maps
and wrong ones, and robots that are carried away."""
import dataclasses
import pathlib
import random
import shutil

from slam_eval.bench.harness import bag_edit
from slam_eval.bench.harness.buildings import write_building
from slam_eval.bench.harness.runs import run_ours, simulate
from slam_eval.bench.harness.table import number, Section, table, verdict
from slam_eval.bench.lost.alarms import judge, NEAR, wrong_from_start
from slam_eval.io.run_folder import read_run

EVERY = 15.0  # mean time between two people who come by [s]
THEN = 15.0   # how long a drive goes on after the robot was carried, or in a wrong map [s]

CASES = ("mapping", "localisation", "carried", "wrong map")
MOST_FALSE = 1.0   # alarms in 10 h
LEAST_TOLD = 95.0  # of those that are wrong [%]


@dataclasses.dataclass
class Mapped:
    """The run that mapped a building, and whether its map is right."""

    folder: pathlib.Path
    is_right: bool


def _duration(folder):
    stamps = read_run(folder).trajectory.stamps
    return (stamps[-1] - stamps[0]) * 1e-9


class Buildings:
    """Runs of a product in one random building after the other."""

    def __init__(self, context):
        self._context, self._product = context, context.options.product
        self._before = None  # the mapped building before this one
        self.verdicts = {case: {} for case in CASES}  # by the building's seed

    def _run(self, name, bag, map_of=None):
        settings = ("grid.mode=localization", "pf.mode=localization")
        mode = "pf" if self._product.startswith("pf") else "grid"
        chosen = [s for s in settings if s.startswith(mode)] if map_of else []
        folder, _ = run_ours(self._context, name, bag, product=self._product, settings=chosen,
                             load_map=map_of)
        return folder

    def _map(self, name, bag, seed):
        folder = self._run(name, bag)
        found = judge(read_run(folder))
        self.verdicts["mapping"][seed] = found
        return Mapped(folder, found.wrong is None)

    def _localise(self, name, simulated, mapped, seed):
        bag = simulated.with_name(f"{name}.bag")
        bag_edit.rewrite(simulated, bag, bag_edit.People(seed + 1_000_000, EVERY))
        folder = self._run(name, bag, mapped.folder)
        self.verdicts["localisation"][seed] = judge(read_run(folder))
        self._remove(bag, folder)

    def _carry(self, name, bag, duration, seed):
        chance = random.Random(seed)
        at = duration * chance.uniform(0.5, 0.7)
        carried = bag_edit.Carried(at, at + chance.uniform(8.0, 0.25 * duration), THEN)
        cut = bag.with_name(f"{name}.bag")
        bag_edit.rewrite(bag, cut, carried=carried)
        folder = self._run(name, cut)
        self.verdicts["carried"][seed] = judge(read_run(folder))
        self._remove(cut, folder)

    def _mistake(self, name, bag, mapped, seed):
        start = bag.with_name(f"{name}.bag")
        bag_edit.rewrite(bag, start, carried=bag_edit.Carried(0.0, 0.0, THEN))
        folder = self._run(name, start, mapped.folder)
        self.verdicts["wrong map"][seed] = wrong_from_start(read_run(folder))
        self._remove(start, folder)

    @staticmethod
    def _remove(*paths):
        for path in paths:
            if path.is_dir():
                shutil.rmtree(path)
            else:
                path.unlink()

    def drive(self, seed):
        """All cases in the building of a seed."""
        name = f"building_{seed}"
        world = write_building(self._context.work / f"{name}.yaml", seed)
        simulated = simulate(self._context, name, world, seed, "odom,scan")
        bag = simulated.with_name(f"{name}_people.bag")
        bag_edit.rewrite(simulated, bag, bag_edit.People(seed, EVERY))
        mapped = self._map(name, bag, seed)
        if mapped.is_right:
            self._localise(f"{name}_localised", simulated, mapped, seed)
            self._carry(f"{name}_carried", bag, _duration(mapped.folder), seed)
        if self._before is not None:
            self._mistake(f"{name}_mistaken", bag, self._before, seed)
            self._remove(self._before.folder)
        self._before = mapped
        self._remove(simulated, bag, world)


def row(case, verdicts):
    """A line of the table."""
    hours, wrong = sum(v.hours for v in verdicts), [v for v in verdicts if v.wrong is not None]
    false, told = sum(v.is_false for v in verdicts), sum(v.is_in_time for v in wrong)
    return [case, number(len(verdicts), "d"), number(hours, ".2f"), number(false, "d"),
            number(len(wrong), "d"), number(told, "d"),
            number(100.0 * told / len(wrong) if wrong else None, ".1f")]


def verdict_lines(verdicts):
    """A line for each goal, over all cases."""
    hours = sum(v.hours for v in verdicts)
    false = sum(v.is_false for v in verdicts)
    wrong = [v for v in verdicts if v.wrong is not None]
    lines = [f"- false alarms in 10 h: {10.0 * false / hours:.2f} "
             f"({verdict(10.0 * false / hours, MOST_FALSE, True)})"]
    if wrong:
        told = 100.0 * sum(v.is_in_time for v in wrong) / len(wrong)
        lines.append(f"- told within {NEAR:g} m: {told:.1f} % ({verdict(told, LEAST_TOLD, False)})")
    return "\n".join(lines)


def exceptions(verdicts):
    """The runs that were not judged as they should be, by case and building."""
    lines = []
    for case, found in verdicts.items():
        for seed, v in found.items():
            if v.is_false:
                lines.append(f"- false alarm: {case}, building {seed}, at {v.told:.1f} s")
            elif v.wrong is not None and not v.is_in_time:
                later = "never" if v.told is None else f"after {v.way:.1f} m"
                lines.append(f"- wrong from {v.wrong:.1f} s on, told {later}: {case}, building {seed}")
    return "\n".join(lines)


def measure(context):
    """The section of this part."""
    buildings, count = Buildings(context), context.options.drives
    first = context.options.first
    for seed in range(first, first + count):
        buildings.drive(seed)
    lists = {case: list(found.values()) for case, found in buildings.verdicts.items()}
    every = [v for found in lists.values() for v in found]
    section = Section(f"Lost or not, {context.options.product}, {count} buildings")
    section.paragraphs += [
        table(["case", "runs", "data [h]", "false alarms", "wrong", "told within 5 m", "told [%]"],
              [*(row(case, found) for case, found in lists.items()), row("all", every)]),
        verdict_lines(every),
        *filter(None, [exceptions(buildings.verdicts)]),
        "Wrong: the pose was more than 0.5 m off for 5 m of way. A robot that was carried and found "
        "within that is not wrong. False: an alarm while the pose was right."]
    return section
