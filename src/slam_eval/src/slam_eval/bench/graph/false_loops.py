# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part false_loops of benchmark graph: graphs with false loops of four kinds, solved as if any loop
may be false."""
import json

from slam_eval.bench.graph.files import truth_of
from slam_eval.bench.graph.solve import last_line, PROGRAM
from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import data_folder, workspace_program
from slam_eval.bench.harness.runs import call
from slam_eval.bench.harness.table import lines_of, Section, table, verdict

KINDS = ("random", "local", "random_groups", "local_groups")
GRAPH, RING = "manhattan3500", "ring"
POSES, FALSE_LOOPS = 3500, 1000  # of a city that is made; of each run

HEADER = ["kind", "runs", "error [m]", "at worst [m]", "over clean, at worst", "within",
          "false believed", "true waiting", "CPU [s]"]
FORMS = ["d", ".3f", ".3f", ".3f", "d", "d", "d", ".2f"]
MOST_ERROR = 1.05  # over that without false loops

REMARK = ("{loops} true loops and {false} false ones of each kind (Suenderhauf and Protzel 2012); "
          "errors of the positions after a rigid alignment with the truth. Within: runs whose error "
          "is at most {most:g} times that of the clean graph. False loops that are believed and "
          "true ones that wait at the end are counted over all runs.")

_NUMBERS = ("error_m", "loops", "false_loops", "true_loops_rejected", "false_loops_believed", "cpu_s")


def parse_report(text):
    """The program's JSON of a robust run. Raises BenchError."""
    try:
        report = json.loads(text)
        if all(isinstance(report[key], (int, float)) for key in _NUMBERS):
            return report
    except (json.JSONDecodeError, KeyError, TypeError):
        pass
    raise BenchError(f"{PROGRAM} printed no JSON of a robust run; build it again")


def solve(context, name, arguments, label):
    """What the program printed of a graph whose loops may be false."""
    log = context.work / f"robust_{name}.json"
    errors = log.with_name(log.name + ".err")
    command = [workspace_program("slam_eval", PROGRAM), *arguments, "--robust"]
    call(context, label, command, log, state=lambda: last_line(errors))
    return parse_report(log.read_text(encoding="utf-8"))


def _in_file(name, folder):
    """Arguments for a graph of the folder with its truth, or None where it is not there."""
    path = folder / f"{name}.g2o"
    truth = truth_of(path)
    return ["--g2o", path, "--truth", truth] if path.is_file() and truth else None


def row(kind, reports, clean):
    """The numbers of a line: some runs with false loops beside the one without."""
    errors = [report["error_m"] for report in reports]
    within = sum(error <= MOST_ERROR * clean["error_m"] for error in errors)
    return [kind, len(reports), sum(errors) / len(errors), max(errors),
            max(errors) / clean["error_m"], within,
            sum(report["false_loops_believed"] for report in reports),
            sum(report["true_loops_rejected"] for report in reports),
            sum(report["cpu_s"] for report in reports) / len(reports)]


def clean_row(report):
    """The line of the graph without false loops."""
    return ["none", 1, report["error_m"], report["error_m"], None, None, 0,
            report["true_loops_rejected"], report["cpu_s"]]


def describe(clean, reports_by_kind):
    """The table and its verdict, as paragraphs."""
    rows = [row(kind, reports, clean) for kind, reports in reports_by_kind.items()]
    runs, within = (sum(line[HEADER.index(name)] for line in rows) for name in ("runs", "within"))
    return [table(HEADER, lines_of([clean_row(clean), *rows], FORMS)),
            f"- runs within {MOST_ERROR:g} times the clean error {within} "
            f"({verdict(within, runs, False)})",
            REMARK.format(loops=clean["loops"], false=FALSE_LOOPS, most=MOST_ERROR)]


def _measure_ring(context, folder, label):
    """A sentence on the graph whose odometry has drifted far when its loops come."""
    source = _in_file(RING, folder)
    if source is None:
        return f"{RING} is left out: it is not in {folder} with its truth."
    report = solve(context, RING, source, f"{label}, {RING}")
    waiting = report["true_loops_rejected"]
    return (f"- {RING}, {report['loops']} loops, none of them false: true ones that wait {waiting} "
            f"({verdict(waiting, 0, True)})")


def measure(context):
    """The section of this part."""
    folder, seeds = context.options.graphs or data_folder("graphs"), context.options.seeds
    city = ["--world", context.options.seed, "--poses", POSES]
    in_file = _in_file(GRAPH, folder)
    source, count = in_file or city, len(KINDS) * seeds + 2
    section = Section(f"False loops in {GRAPH}" if in_file else
                      f"False loops in a simulated city of {POSES} poses")
    clean = solve(context, "clean", source, f"false loops, run 1 of {count}, without any")
    made = {kind: [] for kind in KINDS}
    for i, (kind, seed) in enumerate((kind, seed) for kind in KINDS
                                     for seed in range(1, seeds + 1)):
        made[kind].append(solve(
            context, f"{kind}_{seed}",
            [*source, "--false-loops", FALSE_LOOPS, "--kind", kind, "--seed", seed],
            f"false loops, run {i + 2} of {count}, {kind}"))
    ring = _measure_ring(context, folder, f"false loops, run {count} of {count}")
    section.paragraphs += [*describe(clean, made), ring]
    return section
