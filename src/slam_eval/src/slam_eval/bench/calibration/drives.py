# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Drives through random halls with a robot file that is wrong: what a product finds out, what its
pose is worth meanwhile, and what the robot file that it writes is worth."""
import dataclasses
import functools
import shutil

import yaml

from slam_eval.bench.calibration.cases import CASES, RIGHT
from slam_eval.bench.calibration.reported import estimates
from slam_eval.bench.calibration.results import (CALIBRATING, errors_of, parameter_table, REMARK,
                                                 run_table, verdict_lines, WRITTEN, WRONG)
from slam_eval.bench.calibration.true_wheels import true_wheels
from slam_eval.bench.harness.bag_edit import edit
from slam_eval.bench.harness.error import BenchError, Failure
from slam_eval.bench.harness.hall_drives import Drives, LANDMARKS, log_of, run_product, truth_of
from slam_eval.bench.harness.programs import simulation_file
from slam_eval.bench.harness.table import Section
from slam_eval.io.errors import InputError
from slam_eval.io.run_folder import read_run
from slam_eval.metrics.evaluation import evaluate
from slam_eval.plot.calibration import plot_errors


@dataclasses.dataclass(frozen=True)
class Outcome:
    """Of one run: ATE after alignment [m], mean NEES [1], time confidently wrong [s], ATE of the
    revised path [m] where the product has one."""

    ate: float
    nees: float
    wrong: float
    revised: float | None = None


@dataclasses.dataclass
class Seed:
    """The runs of a case with one seed, {WRONG, CALIBRATING, WRITTEN: Outcome or Failure}, and
    {parameter: Estimate}."""

    runs: dict
    estimates: dict


def _outcome(folder):
    metrics = evaluate(read_run(folder)).metrics
    try:
        return Outcome(*(metrics[key] for key in ("ate_rmse_m", "nees_mean",
                                                  "confidently_wrong_s")),
                       metrics.get("ate_final_rmse_m"))
    except KeyError as key:
        raise BenchError(f"the run {folder.name} has no {key.args[0]}; look at its log") from None


class Runner:
    """Runs the cases with a product; keeps the drives, and what their wheels are."""

    def __init__(self, context, product, drives):
        self._context, self._product, self._drives, self._wheels = context, product, drives, {}
        self.cpu_s = 0.0

    def _true_wheels(self, seed, drive):
        if seed not in self._wheels:
            robot = yaml.safe_load(simulation_file("robots", "segway").read_text(encoding="utf-8"))
            self._wheels[seed] = true_wheels(robot["wheels"], truth_of(drive).poses)
        return self._wheels[seed]

    def _run(self, bag, name, seed, robot=None, estimate=()):
        """(Outcome or Failure, folder)."""
        folder = bag.with_name(f"{bag.stem}_{self._product}_{name}_run")
        settings = [f"calibration.estimate=[{', '.join(estimate)}]"] if estimate else []
        try:
            self.cpu_s += run_product(folder, self._product, bag, seed, robot, settings)
            return _outcome(folder), folder
        except (BenchError, InputError) as error:
            return Failure(str(error)), folder

    def _calibrate(self, bag, seed, case, true_values):
        """The runs with calibration, and what it found."""
        estimate = case.estimated_by(self._product)
        outcome, folder = self._run(bag, CALIBRATING, seed, estimate=estimate)
        if isinstance(outcome, Failure):
            return {CALIBRATING: outcome}, {}
        found = estimates(log_of(folder).read_text(encoding="utf-8"), true_values)
        if not found:
            return {CALIBRATING: Failure("the run reported nothing of its calibration")}, {}
        again, _ = self._run(bag, WRITTEN, seed, robot=folder / "robot.yaml")
        return {CALIBRATING: outcome, WRITTEN: again}, found

    def seed(self, name, seed):
        """The Seed of a case."""
        case, drive = CASES[name], self._drives.bag(seed, LANDMARKS)
        bag = drive.with_name(f"{drive.stem}_{name}.bag")
        edit(drive, bag, case.wrong.change())
        runs, found = {WRONG: self._run(bag, WRONG, seed)[0]}, {}
        if case.estimate:
            true_values = case.wrong.true_values(self._true_wheels(seed, drive))
            more, found = self._calibrate(bag, seed, case, true_values)
            runs.update(more)
        if self._context.options.keep is None:
            bag.unlink()
            for path in bag.parent.glob(f"{bag.stem}_*_run"):
                shutil.rmtree(path, ignore_errors=True)
        return Seed(runs, found)


def _section(context, product, results, right, cpu_s):
    options = context.options
    halls = f"{options.seeds} halls" if options.seeds > 1 else "one hall"
    section = Section(f"{product} with a robot file that is wrong, {halls}")
    cases = "; ".join(f"`{name}`: {CASES[name].title}" for name in results)
    section.paragraphs += [run_table(results, right), parameter_table(results),
                           verdict_lines(results, right), REMARK, f"Cases: {cases}.",
                           f"CPU time of all runs {cpu_s:.0f} s."]
    errors = errors_of(results)
    if errors:
        path = context.out / f"calibration_errors_{product}.png"
        plot_errors(errors, path)
        section.pictures["errors of the calibrated parameters, a dot for each hall"] = path
    return section


def measure(context, name):
    """Nothing but with the last of the cases that were asked for: then the sections of all, one for
    each product. The case `right`, which the others are compared with, is always run."""
    options, made = context.options, context.made
    if "runners" not in made:
        drives = Drives(context)
        made["runners"] = {each: Runner(context, each, drives) for each in options.products}
    results = made.setdefault("results", {product: {} for product in options.products})
    for product, runner in made["runners"].items():
        for case in dict.fromkeys((RIGHT, name)):
            if case in results[product] or not CASES[case].is_for(product):
                continue
            results[product][case] = []
            for seed in range(1, options.seeds + 1):
                context.progress.begin(f"{product}, {case}: seed {seed} of {options.seeds}")
                results[product][case].append(runner.seed(case, seed))
    if name != options.only[-1]:
        return []
    return [_section(context, product, of, [seed.runs[WRONG] for seed in of[RIGHT]],
                     made["runners"][product].cpu_s) for product, of in results.items()]


PARTS = {name: functools.partial(measure, name=name) for name in CASES}
