# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Drives through random halls, each with one fault: how long products are confidently wrong."""
import concurrent.futures
import functools
import pathlib
import shutil
import threading
import time

from slam_eval.bench.adverse.faults import BEGIN, FAULTS
from slam_eval.bench.adverse.results import (median_share, REMARK, split, verdict_lines,
                                             whole_table, worst_share)
from slam_eval.bench.harness.error import BenchError, Failure
from slam_eval.bench.harness.hall_drives import Drives, run_product, sensor_of
from slam_eval.bench.harness.judge import judge
from slam_eval.bench.harness.table import Section
from slam_eval.io.errors import InputError
from slam_eval.io.run_folder import read_run
from slam_eval.plot.adverse import plot_shares

WORKERS = 2  # runs at a time


class Case:
    """The runs of all products with one fault: its outcomes by product, in the order of the
    seeds."""

    def __init__(self, context, drives, name):
        self._context, self._drives, self._name = context, drives, name
        self._fault = FAULTS[name]
        self.cpu_s, self._lock = 0.0, threading.Lock()

    def _run(self, product, bag, seed):
        folder = bag.with_name(f"{bag.stem}_{pathlib.Path(product).stem}_run")
        try:
            cpu_s = run_product(folder, product, bag, seed)
            with self._lock:
                self.cpu_s += cpu_s
            return judge(read_run(folder), self._fault.begin)
        except (BenchError, InputError) as error:
            return Failure(str(error))
        finally:
            if self._context.options.keep is None:
                shutil.rmtree(folder, ignore_errors=True)

    def _seed(self, products, seed):
        """{product: outcome} of a seed; products: {name: sensor}."""
        outcomes = {}
        for sensor in dict.fromkeys(products.values()):
            source = self._drives.bag(seed, sensor)
            bag = source.with_name(f"{source.stem}_{self._name}.bag")
            self._fault.put(source, bag, seed)
            of = [product for product, its in products.items() if its == sensor]
            with concurrent.futures.ThreadPoolExecutor(WORKERS) as pool:
                run = functools.partial(self._run, bag=bag, seed=seed)
                outcomes.update(zip(of, pool.map(run, of)))
            if self._context.options.keep is None:
                bag.unlink()
        return outcomes

    def measure(self, products, seeds):
        """{product: [outcome of each seed]} of those products that the fault concerns."""
        concerned = {p: s for p, s in products.items() if s in self._fault.sensors}
        of_seeds = []
        for seed in range(1, seeds + 1 if concerned else 1):
            self._context.progress.begin(f"{self._name}: seed {seed} of {seeds}")
            of_seeds.append(self._seed(concerned, seed))
        return {product: [of[product] for of in of_seeds] for product in concerned}


def _by_product(results, products):
    """The results of one product after the other."""
    return {key: results[key] for product in products for key in results if key[0] == product}


def _section(context, results, cpu_s, seconds):
    options = context.options
    results = _by_product(results, options.products)
    halls = f"{options.seeds} halls" if options.seeds > 1 else "one hall"
    section = Section(f"Confidently wrong or not, {halls}")
    measured = [name for name in options.only if any(name == fault for _, fault in results)]
    faults = "; ".join(f"`{name}`: {FAULTS[name].title}" for name in measured)
    section.paragraphs += [whole_table(results), verdict_lines(results), REMARK,
                           f"Faults, from {BEGIN:g} s on, those of wheels, ranges and bearings "
                           f"from the start: {faults}.",
                           f"CPU time of all runs {cpu_s:.0f} s, wall time {seconds:.0f} s."]
    path = context.out / "adverse_wrong.png"
    cells = {key: (median_share(outcomes), worst_share(outcomes), bool(split(outcomes)[1]))
             for key, outcomes in results.items()}
    plot_shares(cells, options.products, measured, path)
    section.pictures["share of the time confidently wrong"] = path
    return section


def measure(context, name):
    """Nothing but with the last of the faults that were asked for: then the section of all."""
    options = context.options
    products = {product: sensor_of(product) for product in options.products}
    drives = context.made.setdefault("drives", Drives(context))
    results = context.made.setdefault("results", {})
    start = context.made.setdefault("start", time.monotonic())
    case = Case(context, drives, name)
    try:
        for product, outcomes in case.measure(products, options.seeds).items():
            results[product, name] = outcomes
    finally:
        context.made["cpu_s"] = context.made.get("cpu_s", 0.0) + case.cpu_s
    if name == options.only[-1]:
        if not results:
            raise BenchError("none of these faults concerns the sensors of these products")
        return [_section(context, results, context.made["cpu_s"], time.monotonic() - start)]
    return []


PARTS = {name: functools.partial(measure, name=name) for name in FAULTS}
