# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part intel of benchmark grid: the grid product on the standard log."""
from slam_eval.bench.harness.goals import Goal, verdicts
from slam_eval.bench.harness.products import PF_WHEEL_GRID
from slam_eval.bench.harness.programs import data_folder
from slam_eval.bench.harness.runs import import_log, run_ours
from slam_eval.bench.harness.table import lines_of, mean_row, Section, table
from slam_eval.io.run_folder import read_run
from slam_eval.metrics.evaluation import evaluate
from slam_eval.metrics.relations import judge_run
from slam_eval.plot.map import plot_map

PARTICLES = 30

HEADER = ["seed", "relations", "translation [m]", "+-", "rotation [deg]", "CPU [s]",
          "wall [s]", "memory [MB]"]
FORMS = ["g", ".4f", ".4f", ".3f", ".1f", ".1f", ".0f"]
# gmapping with as many particles and its defaults on such a machine, by the same rule; as published
# (Kuemmerle et al. 2009); MRPT's there on a part of the log
GMAPPING = ["gmapping", 2984, 0.067, 0.069, 2.49, 140.0, None, 470.0]
RBPF_SLAM = ["rbpf-slam, 1/5 of the scans, 10 particles", None, None, None, None, 190.0, None, None]
PUBLISHED = ["gmapping, published", None, 0.070, 0.083, None, None, None, None]

GOALS = (Goal("translation [m]", 0.067), Goal("rotation [deg]", 2.5), Goal("CPU [s]", 45.0),
         Goal("memory [MB]", 200.0))


def _seed_line(context, bag, relations, seed, section):
    folder, usage = run_ours(context, f"intel_{seed}", bag, product=PF_WHEEL_GRID,
                             settings=(f"seed={seed}", f"pf.particles={PARTICLES}"))
    run = read_run(folder)
    errors = judge_run(run, relations)
    if seed == 1:
        path = context.out / "intel_map.png"
        plot_map(run, evaluate(run, errors), path)
        section.pictures["map of the Intel Research Lab, seed 1"] = path
    m = errors.metrics
    return [str(seed), m["relations"], m["relations_trans_mean_m"], m["relations_trans_std_m"],
            m["relations_rot_mean_deg"], usage.cpu_s, usage.wall_s, usage.max_rss_mb]


def measure(context):
    """The section of part intel."""
    section = Section("Intel Research Lab")
    folder = context.options.laser or data_folder("laser")
    log, relations = folder / "intel.clf", folder / "intel.relations"
    missing = [path for path in (log, relations) if not path.is_file()]
    if missing:
        section.paragraphs.append(f"Left out: there is no file {missing[0]} (--laser DIR or "
                                  "$SLAM_DATA_DIR name another folder).")
        return section
    bag = import_log(context, "intel", ["carmen", log])
    rows = [_seed_line(context, bag, relations, seed, section)
            for seed in range(1, context.options.seeds + 1)]
    beside = [GMAPPING, PUBLISHED, RBPF_SLAM]
    section.paragraphs += [
        table(HEADER, lines_of([*rows, mean_row("mean", rows), *beside], FORMS)),
        verdicts(GOALS, HEADER, rows),
        f"{PARTICLES} particles; errors of the relations of Kuemmerle et al. 2009. The lines of "
        "others were measured elsewhere, by the same rule, and published."]
    return section
