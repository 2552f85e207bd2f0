# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Benchmark carried: products in the simulated office from which the robot is carried on in the middle
of the drive, while its odometry stands still."""
import math

from slam_eval.bench.harness import bag_edit
from slam_eval.bench.harness.goals import Goal, verdicts
from slam_eval.bench.harness.judge import judge
from slam_eval.bench.harness.products import sensors_for
from slam_eval.bench.harness.runs import run_ours, simulate
from slam_eval.bench.harness.table import lines_of, Section, table
from slam_eval.io.run_folder import read_run

FIRST, LAST = 15, 30  # when the robot is lifted, by the seed [s]
CARRIED = 10.0        # of the drive that is left out [s]

HEADER = ["seed", "lifted at [s]", "lost reported after [s]", "lost [s]", "largest error [m]",
          "confidently wrong [%]", "lost before"]
FORMS = [".0f", ".2f", ".1f", ".2f", ".1f", "d"]
GOALS = (Goal("confidently wrong [%]", 1.0), Goal("lost before", 0))
REPORTED = Goal("lost reported after [s]", 5.0)  # of those that are reported lost
REMARK = (
    f"The robot is lifted, and goes on where it would have been {CARRIED:g} s later. Lost before: "
    "false reports. Confidently wrong: share of the time, from 5 s after that, in which the position "
    "is more than 0.3 m off and more than 5 reported sigmas.")


def lifted_at(seed):
    """When the robot of a drive is lifted [s]."""
    return FIRST + (7 * seed) % (LAST - FIRST)


def row(seed, outcome):
    """The line of a drive."""
    return [str(seed), lifted_at(seed), outcome.told, outcome.lost, outcome.largest,
            None if outcome.wrong is None else 100.0 * outcome.wrong, outcome.false]


def section(product, rows):
    """The table of a product's drives, and whether the goals are reached."""
    reported = [line for line in rows if line[HEADER.index("lost reported after [s]")] is not None]
    lines = [verdicts(GOALS, HEADER, rows)]
    if reported:
        lines.append(verdicts([REPORTED], HEADER, reported))
    if len(reported) < len(rows):
        lines.append(f"- never reported lost: {len(rows) - len(reported)} of {len(rows)} (MISSED)")
    return Section(f"{product} in the office, carried on",
                   [table(HEADER, lines_of(rows, FORMS)), "\n".join(lines), REMARK])


def _outcome(context, product, seed):
    label = f"{product}, seed {seed} of {context.options.seeds}"
    whole = simulate(context, f"office_{seed}", "office", seed, sensors_for(product), label)
    bag, begin = context.work / f"office_{seed}_carried.bag", lifted_at(seed)
    bag_edit.rewrite(whole, bag, carried=bag_edit.Carried(begin, begin + CARRIED, math.inf))
    folder, _ = run_ours(context, f"{product}_{seed}", bag, product=product, label=label)
    if context.options.keep is None:
        whole.unlink()
        bag.unlink()
    return judge(read_run(folder), begin)


def measure(context):
    """The section of this benchmark."""
    product, seeds = context.options.product, range(1, context.options.seeds + 1)
    return section(product, [row(seed, _outcome(context, product, seed)) for seed in seeds])
