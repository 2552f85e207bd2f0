# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part logs of benchmark laser: all products that map with a laser on all logs given."""
import types

from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.products import laser_products
from slam_eval.bench.harness.runs import run_ours
from slam_eval.bench.harness.table import Section
from slam_eval.bench.laser.figures import describe, overview, row
from slam_eval.bench.laser.log import default_logs, names_of, open_log
from slam_eval.bench.peers.bag_rawlog import ANGLE, DISTANCE, make_rawlog, read_path
from slam_eval.bench.peers.rbpf_slam import particles_of, run_rbpf_slam
from slam_eval.io.errors import InputError
from slam_eval.io.run_folder import read_run
from slam_eval.plot.benchmarks import plot_maps

PEER = "rbpf-slam"
PEERS_CONFIGURATION = "gridmapping_optimal_sampling.ini"
REMARK = ("Mean errors of the relations beside a log; u.: of those that can mean one scan only, r.: "
          "of revisits. CPU time and memory of the whole run, the bag included. A product whose path "
          "does not depend on the seed has one line.")
PEERS_REMARK = (f"rbpf-slam: MRPT's, with its configuration {PEERS_CONFIGURATION}, one run, a scan "
                f"each {DISTANCE:g} m or {ANGLE:g} rad.")


class LogRuns:
    """All runs on one log: lines of the table, what went wrong, and the runs of the first seed."""

    def __init__(self, context, log, label, unseeded):
        self._context, self._log, self._label, self._unseeded = context, log, label, unseeded
        self.rows, self.failures, self.shown = [], [], {}

    def judge(self, product, seed, trajectory, odometry, usage):
        """Adds the line of a run."""
        tolerance = self._context.options.tolerance
        errors = self._log.judge(trajectory, odometry, tolerance)
        if self._log.relations is not None and errors is None:
            self.failures.append(f"{product} has poses for none of the relations")
        self.rows.append(row(product, seed, errors, usage))

    def _run(self, product, seed):
        """The run of a product, read."""
        options, name = self._context.options, f"{self._log.name}_{product}_{seed}"
        folder, usage = run_ours(self._context, name, self._log.bag, robot=options.robot,
                                 product=product, settings=(f"seed={seed}",),
                                 label=f"{self._label}, seed {seed} of {options.seeds}")
        return read_run(folder), usage

    def run_product(self, product):
        """Runs a product with all seeds; with the first alone where the second changes nothing."""
        seeds = 1 if product in self._unseeded else self._context.options.seeds
        first = None
        for seed in range(1, seeds + 1):
            run, usage = self._run(product, seed)
            path = run.final or run.trajectory
            if first is None:
                first, self.shown[product] = path, run
            elif seed == 2 and is_same(first, path):
                self._unseeded.add(product)
                break
            self.judge(product, seed, path, run.odometry, usage)
        if product in self._unseeded:
            self.rows[-1][1] = None

    def run_peer(self):
        """Runs rbpf-slam; returns a sentence where it cannot be."""
        name = self._log.name
        try:
            rawlog = make_rawlog(self._context, name, self._log.bag)
            done = run_rbpf_slam(self._context, name, PEERS_CONFIGURATION, rawlog.path,
                                 {"localizeLinDistance": 0, "localizeAngDistance_deg": 0})
            if done is None:
                return f"{PEER} is left out: install mrpt-apps."
            folder, usage = done
            path = read_path(folder, rawlog)
        except BenchError as error:
            return f"{PEER} is left out: {error}."
        title = f"{PEER}, {particles_of(folder)} particles"
        self.judge(title, None, path, rawlog.odometry, usage)
        self.shown[title] = types.SimpleNamespace(trajectory=path, final=path, grid=None)
        return None


def is_same(first, second):
    """Whether two paths are the same to the last digit."""
    return len(first) == len(second) and bool((first.poses == second.poses).all())


def _picture(context, log, runs, section):
    if runs.shown:
        path = context.out / f"laser_{log.name}.png"
        plot_maps(runs.shown, path)
        section.pictures["maps and paths, seed 1"] = path


def _measure(context, log, label, unseeded):
    """(section, rows) of a log. unseeded: products that were seen not to depend on the seed; more
    may be added."""
    products = context.options.products or laser_products()
    runs, said = LogRuns(context, log, label, unseeded), []
    if log.relations is None:
        said.append("No relations stand beside this log, so that errors are not known.")
    for product in products:
        try:
            runs.run_product(product)
        except (BenchError, InputError) as error:
            runs.failures.append(f"{product}: {error}")
    said.append(runs.run_peer())
    section = Section(log.name, [*describe(log.name, runs.rows), *filter(None, said)],
                      failures=runs.failures)
    _picture(context, log, runs, section)
    return section, runs.rows


def _on_all(rows):
    """The section behind those of the logs. rows: of each log, by its name."""
    if not rows:
        return Section("No logs", ["Left out: no log was given, and there are none in the shared "
                                   "data ($SLAM_DATA_DIR/laser/*.clf)."])
    return Section("All logs", [*overview(rows), REMARK, PEERS_REMARK])


def measure(context):
    """A section for each log, and one on all of them."""
    paths = context.options.logs or default_logs()
    rows, unseeded = {}, set()
    for i, (name, path) in enumerate(zip(names_of(paths), paths)):
        try:
            log = open_log(context, name, path)
            label = f"log {i + 1} of {len(paths)}, {name}"
            section, rows[name] = _measure(context, log, label, unseeded)
        except (BenchError, InputError) as error:
            yield Section(name, failures=[str(error)])
            continue
        if log.is_imported and context.options.keep is None:
            log.bag.unlink()
        yield section
    if rows or not paths:
        yield _on_all(rows)
