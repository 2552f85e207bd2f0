# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the parts have in common: each back-end with each policy on a bag, and its line."""
from slam_eval.bench.harness.runs import run_ours
from slam_eval.bench.harness.table import lines_of, table
from slam_eval.io.associations import read_associations
from slam_eval.io.run_folder import read_run
from slam_eval.metrics.association import as_revised, judge
from slam_eval.metrics.evaluation import evaluate
from slam_eval.plot.associations import plot_associations

PRODUCTS = ("ekf_wheel", "pf_wheel", "graph_wheel")
POLICIES = ("known_ids", "nearest", "jcbb")

HEADER = ["log", "product", "association", "ATE [m]", "pairings", "precision", "recall", "wrong",
          "not judged", "landmarks", "ghosts", "left out", "CPU [s]"]
FORMS = ["s", "s", ".3f", "d", ".2%", ".2%", ".2%", "d", "d", "d", ".1%", ".1f"]

DEFINITIONS = ("A landmark is that of the observation that it was begun with. Precision: share of "
               "the pairings that are right. Recall: share of the observations of landmarks in the "
               "map that are paired with theirs. Not judged: an observation without an id, paired "
               "with a landmark that was begun by one. Ghosts: landmarks in the map at the end "
               "beyond one for each id. Left out: share of all observations, those on trial "
               "included.")


def run_policy(context, log, bag, product, policy, robot=None, before=None,
               detector="none"):
    """Run a product with a policy; its line of the table, the run, its pairings and Association.

    before: only observations before this stamp are judged.
    """
    name = f"{log}_{product}_{policy}"
    settings = [f"detector={detector}", f"association={policy}"]
    folder, usage = run_ours(context, name, bag, robot, product, settings)
    run = read_run(folder)
    metrics = evaluate(run).metrics
    if policy == "known_ids":
        return [log, product, policy, metrics.get("ate_rmse_m"), None, None, None, None, None,
                len(run.landmarks), None, None, usage.cpu_s], run, None, None
    rows = as_revised(read_associations(folder / "associations.csv"))
    a = judge(rows, set(run.landmarks.ids), before)
    left_out = sum(row.taken_for not in ("landmark", "new") for row in rows) / max(1, len(rows))
    return [log, product, policy, metrics.get("ate_rmse_m"), a.paired, a.precision, a.recall,
            a.wrong_share, a.unjudged, len(run.landmarks), a.ghosts, left_out,
            usage.cpu_s], run, rows, a


def run_all(context, log, bag, section, robot=None, before=None, detector="none"):
    """All products with all policies on a bag; the lines. A picture of each is in the section."""
    lines = []
    for product in context.options.products or PRODUCTS:
        for policy in POLICIES:
            line, run, rows, a = run_policy(context, log, bag, product, policy, robot, before,
                                            detector)
            lines.append(line)
            if a is None:
                continue
            path = context.out / f"association_{log}_{product}_{policy}.png"
            plot_associations(run, rows, a.wrong_rows, path)
            section.pictures[f"{log}: {product}, {policy}"] = path
    return lines


def table_of(lines):
    """The lines as a table."""
    return table(HEADER, lines_of(lines, FORMS))
