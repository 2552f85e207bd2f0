# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Benchmark carried: products in a simulated world from whose drive the robot is carried on in the
middle, while its odometry stands still."""
import math

from slam_eval.bench.harness import bag_edit
from slam_eval.bench.harness.goals import Goal, verdicts
from slam_eval.bench.harness.judge import judge
from slam_eval.bench.harness.products import map_sensors_for
from slam_eval.bench.harness.runs import run_ours, simulate
from slam_eval.bench.harness.table import lines_of, Section, table
from slam_eval.io.run_folder import read_run

FIRST, LAST = 15, 30  # when the robot is lifted, by the seed [s]

HEADER = ["seed", "lifted at [s]", "lost reported after [s]", "lost [s]", "largest error [m]",
          "confidently wrong [%]", "lost before"]
FORMS = [".0f", ".2f", ".1f", ".2f", ".1f", "d"]
GOALS = (Goal("confidently wrong [%]", 1.0), Goal("lost before", 0))
REPORTED = Goal("lost reported after [s]", 5.0)  # of those that are reported lost
REMARK = (
    "The robot is lifted, and goes on where it would have been {:g} s later. Lost before: false "
    "reports. Confidently wrong: share of the time, from 5 s after that, in which the position is more "
    "than 0.3 m off and more than 5 reported sigmas.")


def lifted_at(seed):
    """When the robot of a drive is lifted [s]."""
    return FIRST + (7 * seed) % (LAST - FIRST)


def row(seed, outcome):
    """The line of a drive."""
    return [str(seed), lifted_at(seed), outcome.told, outcome.lost, outcome.largest,
            None if outcome.wrong is None else 100.0 * outcome.wrong, outcome.false]


def section(product, rows, world="office", carried=10.0):
    """The table of a product's drives, and whether the goals are reached."""
    reported = [line for line in rows if line[HEADER.index("lost reported after [s]")] is not None]
    lines = [verdicts(GOALS, HEADER, rows)]
    if reported:
        lines.append(verdicts([REPORTED], HEADER, reported))
    if len(reported) < len(rows):
        lines.append(f"- never reported lost: {len(rows) - len(reported)} of {len(rows)} (MISSED)")
    return Section(f"{product}, carried on in the world {world}",
                   [table(HEADER, lines_of(rows, FORMS)), "\n".join(lines), REMARK.format(carried)])


def _outcome(context, seed):
    options = context.options
    product, label = options.product, f"{options.product}, seed {seed} of {options.seeds}"
    name, begin = f"{options.world}_{seed}", lifted_at(seed)
    whole = simulate(context, name, options.world, seed, map_sensors_for(product), label,
                     options.robot, options.duration)
    bag = context.work / f"{name}_carried.bag"
    carried = bag_edit.Carried(begin, begin + options.carried, math.inf)
    bag_edit.rewrite(whole, bag, carried=carried)
    folder, _ = run_ours(context, f"{product}_{seed}", bag, product=product, label=label)
    if options.keep is None:
        whole.unlink()
        bag.unlink()
    return judge(read_run(folder), begin)


def measure(context):
    """The section of this benchmark."""
    options = context.options
    rows = [row(seed, _outcome(context, seed)) for seed in range(1, options.seeds + 1)]
    return section(options.product, rows, options.world, options.carried)
