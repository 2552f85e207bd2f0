# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The table of the benchmark adverse, and which of its cells are above the limit."""
import numpy as np

from slam_eval.bench.harness.error import Failure
from slam_eval.bench.harness.judge import SETTLE
from slam_eval.bench.harness.table import number, table
from slam_eval.metrics.honesty import CONFIDENT, WRONG

MOST_WRONG = 0.01  # share of the time, of each seed

HEADER = ["product", "fault", "ATE [m]", "largest error [m]", "NEES", "wrong [%]", "worst [%]",
          "lost reported", "after [s]", "lost [s]", "reported before", "failed"]
REMARK = (
    "Medians over the seeds, but for the worst. ATE and largest error: of the whole drive, not "
    "aligned. NEES: its median over time; 3 is expected. Wrong: share of the time in which the "
    f"position is more than {WRONG:g} m off and more than {CONFIDENT:g} reported sigmas "
    "(Mahalanobis distance of the 2-d position). NEES and this share count from "
    f"{SETTLE:g} s after the beginning of the fault. Lost reported: in how many of the runs the robot "
    "was reported lost after the fault had begun; after: how long after, median of these; lost: "
    "for how long. Reported before: such reports before the fault, in all runs. Failed: runs that "
    "ended with an error, which count nowhere else.")


def split(outcomes):
    """(those of runs that came to their end, Failures)."""
    return ([o for o in outcomes if not isinstance(o, Failure)],
            [o for o in outcomes if isinstance(o, Failure)])


def _median(values):
    values = [value for value in values if value is not None]
    return float(np.median(values)) if values else None


def worst_share(outcomes):
    """The largest share of time confidently wrong, or None where no run has one."""
    shares = [o.wrong for o in split(outcomes)[0] if o.wrong is not None]
    return max(shares) if shares else None


def median_share(outcomes):
    """The median over the seeds of the share of time confidently wrong, or None."""
    return _median([o.wrong for o in split(outcomes)[0]])


def _percent(share):
    return number(None if share is None else 100.0 * share, ".1f")


def row(product, fault, outcomes):
    """A line of the table."""
    ended, failed = split(outcomes)
    told = [o.told for o in ended if o.told is not None]
    return [product, fault, number(_median([o.ate for o in ended]), ".3f"),
            number(_median([o.largest for o in ended]), ".2f"),
            number(_median([o.nees for o in ended]), ".3g"),
            _percent(median_share(outcomes)), _percent(worst_share(outcomes)),
            f"{len(told)} of {len(ended)}" if ended else number(None, ""),
            number(_median(told), ".1f"), number(_median([o.lost for o in ended]), ".1f"),
            number(sum(o.false for o in ended) if ended else None, "d"),
            number(len(failed) or None, "d")]


def whole_table(results):
    """The table of {(product, fault): [Outcome or Failure of each seed]}."""
    return table(HEADER, [row(*key, outcomes) for key, outcomes in results.items()])


def verdict_lines(results):
    """How many of the cells keep to the limit; a line for each that does not, the worst first, and
    one for each in which runs failed."""
    worst = {key: worst_share(outcomes) for key, outcomes in results.items()}
    missed = sorted((key for key, share in worst.items() if (share or 0.0) > MOST_WRONG),
                    key=lambda key: -worst[key])
    kept = sum(share is not None and share <= MOST_WRONG and not split(results[key])[1]
               for key, share in worst.items())
    word = "reached" if kept == len(results) else "MISSED"
    limit = f"{100 * MOST_WRONG:g} %"
    lines = [f"- confidently wrong at most {limit} of the time with every seed: {kept} of "
             f"{len(results)} cells ({word})"]
    lines += [f"- above {limit}: {product}, {fault}: {_percent(worst[product, fault])} %"
              for product, fault in missed]
    for (product, fault), outcomes in results.items():
        _, failed = split(outcomes)
        if failed:
            lines.append(f"- failed: {product}, {fault}: {len(failed)} of {len(outcomes)} runs: "
                         f"{failed[0].sentence}")
    return "\n".join(lines)
