# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What came out of a campaign: a line for each run, medians and quartiles for each product and bag,
and both as CSV."""
import csv
import dataclasses
import io
from typing import Optional

from slam_eval.campaign.campaign_file import COSTS
from slam_eval.campaign.plan import read_result
from slam_eval.io.run_folder import read_metrics
from slam_eval.metrics.paired_test import compare_all, quartiles
from slam_eval.report.metric_table import KEYS

DONE, FAILED, MISSING = "done", "failed", "missing"
NOT_RUN = "it was ended from outside, or not begun; call the campaign again"
FIGURES = tuple(key for key in KEYS if key not in COSTS)


@dataclasses.dataclass(frozen=True)
class Line:
    """A run: names of bag and product, seed, the run's own name, what became of it, its figures,
    and the SHA-256 of its bag."""

    bag: str
    product: str
    seed: int
    run: Optional[str]
    outcome: str
    why: str
    metrics: dict
    drive: Optional[str] = None


@dataclasses.dataclass(frozen=True)
class Cell:
    """A metric of a product on a bag over the seeds: how many have it, how many runs have none
    because they failed or are missing, and (median, first and third quartile) or None."""

    count: int
    failed: int
    quartiles: Optional[tuple]


def _line(folder, row):
    if row.run is None:
        return Line(row.bag, row.product, row.seed, None, FAILED, row.failure, {})
    path = folder.result(row.run)
    if not path.exists():
        return Line(row.bag, row.product, row.seed, row.run, MISSING, NOT_RUN, {})
    failure = read_result(path).get("failure")
    metrics = {} if failure else read_metrics(folder.run(row.run) / "metrics.json")
    return Line(row.bag, row.product, row.seed, row.run, FAILED if failure else DONE, failure or "",
                metrics, row.drive)


def read_lines(folder, rows):
    """The lines of a plan's rows, in their order."""
    return [_line(folder, row) for row in rows]


def _csv(header, rows):
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(header)
    writer.writerows(rows)
    return text.getvalue()


def _figures(line, keys):
    return [line.metrics.get(key, "") for key in keys]


def runs_csv(lines):
    """A line for each run: everything that is the same on every host."""
    return _csv(["bag", "product", "seed", "run", "outcome", "why", *FIGURES],
                [[line.bag, line.product, line.seed, line.run or "", line.outcome, line.why,
                  *_figures(line, FIGURES)] for line in lines])


def costs_csv(lines):
    """Time and memory of each run, on whatever host it was."""
    return _csv(["bag", "product", "seed", "run", *COSTS],
                [[line.bag, line.product, line.seed, line.run or "", *_figures(line, COSTS)]
                 for line in lines])


def cell(lines, bag, product, metric):
    """The cell of a metric."""
    here = [line for line in lines if (line.bag, line.product) == (bag, product)]
    values = [line.metrics[metric] for line in here if metric in line.metrics]
    return Cell(len(values), sum(line.outcome != DONE for line in here),
                quartiles(values) if values else None)


class Tables:
    """All that is reckoned of the lines."""

    def __init__(self, campaign, lines):
        self.lines = lines
        self._drives = {(line.bag, line.seed): line.drive for line in lines if line.drive}
        self.bags = [bag.name for bag in campaign.bags]
        self.products = [row.name for row in campaign.products]
        self.seeds = list(campaign.seeds)
        self.metrics = [metric for metric in campaign.metrics
                        if any(metric in line.metrics for line in lines)]
        self.cells = {(metric, product, bag): cell(lines, bag, product, metric)
                      for metric in self.metrics for product in self.products for bag in self.bags}
        self.comparisons = {metric: self._compared(metric) for metric in self.metrics}

    def values(self, metric):
        """By product the values of a metric by (bag, seed)."""
        found = {product: {} for product in self.products}
        for line in self.lines:
            if metric in line.metrics:
                found[line.product][line.bag, line.seed] = line.metrics[metric]
        return found

    def _compared(self, metric):
        return compare_all(self.values(metric), self._drives)

    def count(self, outcome):
        """How many runs came out so."""
        return sum(line.outcome == outcome for line in self.lines)

    def table_csv(self):
        """A line for each metric, product and bag."""
        rows = []
        for (metric, product, bag), made in self.cells.items():
            middle = made.quartiles or ("", "", "")
            rows.append([metric, product, bag, made.count, made.failed, *middle])
        return _csv(["metric", "product", "bag", "runs", "failed", "median", "quartile_1",
                     "quartile_3"], rows)

    def tests_csv(self):
        """A line for each metric and pair of products."""
        rows = [[metric, c.first, c.second, c.smaller, c.larger, c.same, c.ratio, c.p, c.p_holm]
                for metric, found in self.comparisons.items() for c in found]
        return _csv(["metric", "first", "second", "smaller", "larger", "same", "median_ratio", "p",
                     "p_holm"], rows)
