# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Benchmark office: a product on simulated drives of many seeds, beside dead reckoning."""
import pathlib
import time

from slam_eval.bench.harness.goals import Goal
from slam_eval.bench.harness.products import sensors_for, twin_of
from slam_eval.bench.harness.runs import run_ours, simulate
from slam_eval.bench.harness.table import lines_of, mean_row, Section, table, verdict
from slam_eval.io.run_folder import read_run
from slam_eval.metrics.evaluation import evaluate
from slam_eval.plot.benchmarks import plot_seeds
from slam_eval.plot.map import plot_map, plot_trajectory

HEADER = ["seed", "ATE [m]", "twin [m]", "dead reckoning [m]", "mapped", "of",
          "landmarks [m]", "false markers", "NEES", "NIS/dof", "wall [s]", "CPU [s]", "scale error",
          "update p50 [ms]", "update p99 [ms]"]
FORMS = [".4f", ".4f", ".3f", "g", "g", ".4f", "g", ".2f", ".3f", ".1f", ".1f", ".4f",
         ".1f", ".1f"]
# What the worst seed is: (column, largest or least value). Little drift makes an office too easy.
WORST = (max, max, min, min, min, max, max, max, max, max, max, max, max, max)

GOALS = {
    "office": (Goal("ATE [m]", 0.03, name="worst ATE"),
               Goal("landmarks [m]", 0.03, name="worst landmark RMSE"),
               Goal("false markers", 0, name="false markers"),
               Goal("NEES", 1.0, False, "mean NEES", of_mean=True),
               Goal("NEES", 4.2, name="mean NEES", of_mean=True),
               Goal("dead reckoning [m]", 0.25, False, "least drift of dead reckoning")),
    "gallery": (Goal("ATE [m]", 0.03, name="worst ATE"),
                Goal("scale error", 0.01, name="worst error of the scale"),
                Goal("NEES", 1.0, False, "mean NEES", of_mean=True),
                Goal("NEES", 4.2, name="mean NEES", of_mean=True),
                Goal("update p99 [ms]", 33.0, name="worst update time, 99 %"),
                Goal("dead reckoning [m]", 0.25, False, "least drift of dead reckoning")),
    "corridor": (Goal("ATE [m]", 0.25, name="worst ATE"),),
}
# The covariance of graph_mono is too large by design, so that its NEES has no lower goal.
OF_PRODUCT = {
    ("gallery", "graph_mono"): (
        Goal("ATE [m]", 0.015, name="worst ATE"),
        Goal("NEES", 4.2, name="mean NEES", of_mean=True),
        Goal("scale error", 0.01, name="worst error of the scale"),
        Goal("update p99 [ms]", 15.0, name="worst update time, 99 %"),
        Goal("dead reckoning [m]", 0.25, False, "least drift of dead reckoning")),
}


def goals_of(world, product):
    """What is expected of this product in this world; nothing of a world of one's own."""
    return OF_PRODUCT.get((world, product), GOALS.get(world, ()))


class RemainingTime:
    """How long the other seeds may take, by the mean of those that are done."""

    def __init__(self, count):
        self._count, self._done, self._start = count, 0, time.monotonic()

    def finished(self):
        """One more is done."""
        self._done += 1

    def __str__(self):
        text = f"{self._done + 1} of {self._count}"
        if not self._done:
            return text
        seconds = (time.monotonic() - self._start) * (self._count / self._done - 1)
        return f"{text}, about {seconds / 60:.0f} min left" if seconds >= 90 else (
            f"{text}, about {seconds:.0f} s left")


def values(seed, run, result, usage, twin=None):
    """The numbers of a line of the table. twin: metrics of the product beside
    it. Landmarks with ids of their own are no markers."""
    m, true = result.metrics, set(run.true_landmarks.ids) if run.true_landmarks else set()
    mapped = set(run.landmarks.ids) if run.landmarks else set()
    scale = m.get("scale_error")
    if run.landmarks and run.landmarks.has_own_ids:
        true = mapped = None
    return [str(seed), m.get("ate_rmse_m"), (twin or {}).get("ate_rmse_m"),
            m.get("odometry_ate_rmse_m"), *_counts(mapped, true), m.get("landmark_rmse_m"),
            None if mapped is None else len(mapped - true), m.get("nees_mean"), m.get("nis_mean"),
            usage.wall_s, usage.cpu_s, None if scale is None else abs(scale),
            run.metrics.get("update_ms_p50"), run.metrics.get("update_ms_p99")]


def _counts(mapped, true):
    """Of the markers: (how many are mapped, how many there are)."""
    return (None, None) if mapped is None else (len(mapped & true), len(true))


def worst_row(rows):
    """The worst of each column of numbers; None where a value is missing."""
    columns = list(zip(*rows))[1:]
    return ["worst"] + [None if None in column else worst(column)
                        for worst, column in zip(WORST, columns)]


def verdicts(goals, mean, worst, twin=None):
    """A line for each goal, and whether all markers are mapped."""
    texts = []
    ours, other = mean[HEADER.index("ATE [m]")], mean[HEADER.index("twin [m]")]
    if twin and ours is not None and other is not None:
        ratio = ours / other
        texts.append(f"- mean ATE over that of {twin.product} {ratio:.3f} "
                     f"({verdict(ratio, twin.limit, True)})")
    for goal in goals:
        value = (mean if goal.of_mean else worst)[HEADER.index(goal.column)]
        is_for_wheels = goal.column == "dead reckoning [m]" and other is not None
        if value is not None and not is_for_wheels:
            texts.append(goal.line(value))
    if goals:
        mapped, of = (worst[HEADER.index(name)] for name in ("mapped", "of"))
        if of:
            texts.append(f"- fewest markers mapped {mapped:g} ({verdict(mapped, of, False)})")
    return "\n".join(texts)


def run_seed(context, seed, remaining):
    """Simulate, run and evaluate one seed; returns (run, result, usage, metrics of its twin)."""
    options = context.options
    world, settings = options.world, [f"detector={options.detector}"] if options.detector else []
    stem = pathlib.Path(world).stem
    label, name = f"{stem}, seed {remaining}", f"{stem}_{seed}"
    bag = simulate(context, name, world, seed, sensors_for(options.product), label)
    folder, usage = run_ours(context, name, bag, product=options.product, settings=settings,
                             label=label)
    twin = None
    if twin_of(options.product):
        beside, _ = run_ours(context, f"{name}_twin", bag, product=twin_of(options.product).product,
                             settings=settings, label=label)
        twin = evaluate(read_run(beside)).metrics
    if options.keep is None:
        bag.unlink()
    run = read_run(folder)
    remaining.finished()
    return run, evaluate(run), usage, twin


def _pictures(context, stem, runs, rows, goals):
    run, result, *_ = runs[0]
    pictures = {"path and map, seed 1": context.out / f"{stem}_map.png",
                "SLAM and dead reckoning, seed 1": context.out / f"{stem}_trajectory.png"}
    paths = list(pictures.values())
    if run.landmarks is not None:
        plot_map(run, result, paths[0])
    plot_trajectory(run, result, paths[1])
    if len(rows) > 1 and None not in [error for row in rows for error in (row[1], row[3])]:
        pictures["trajectory error by seed"] = context.out / f"{stem}_seeds.png"
        plot_seeds({"SLAM": [row[1] for row in rows], "dead reckoning": [row[3] for row in rows]},
                   goals[0].limit if goals else None,
                   pictures["trajectory error by seed"])
    return {caption: path for caption, path in pictures.items() if path.exists()}


def measure(context):
    """The section of this benchmark."""
    options, remaining = context.options, RemainingTime(context.options.seeds)
    stem = pathlib.Path(options.world).stem
    runs = [run_seed(context, seed, remaining) for seed in range(1, options.seeds + 1)]
    goals = goals_of(stem, options.product)
    rows = [values(seed, *run) for seed, run in enumerate(runs, start=1)]
    mean, worst = mean_row("mean", rows), worst_row(rows)
    detector = f" with {options.detector}" if options.detector else ""
    section = Section(f"{options.product}{detector} in the world {stem}")
    section.paragraphs += [table(HEADER, lines_of([*rows, mean, worst], FORMS)),
                           verdicts(goals, mean, worst, twin_of(options.product)) or "No goals.",
                           "Errors after a rigid alignment. NEES 3 and NIS/dof 1 are expected. "
                           "Worst: the largest error, the fewest markers, the least drift of dead "
                           "reckoning. Twin: the error of the product that this one is compared "
                           "with. Wall and CPU time of the product, detection included."]
    section.pictures.update(_pictures(context, stem, runs, rows, goals))
    return section
