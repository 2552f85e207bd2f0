# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part files of benchmark graph: graphs in g2o files, with their truth where it stands beside."""
from slam_eval.bench.graph.figures import describe
from slam_eval.bench.graph.solve import draw, solve
from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import data_folder
from slam_eval.bench.harness.table import Section

TRUTHS = ("_truth.txt", "_truth.dat")  # behind the graph's name


def truth_of(path):
    """The file with the true poses of a graph, or None."""
    for end in TRUTHS:
        truth = path.with_name(path.stem + end)
        if truth.is_file():
            return truth
    return None


def _solve_file(context, path, label):
    truth = truth_of(path)
    arguments = ["--g2o", path, *(["--truth", truth] if truth else [])]
    return solve(context, path.stem, arguments, label)


def measure(context):
    """The section of this part. A graph that cannot be read is reported, the others are solved."""
    folder = context.options.graphs or data_folder("graphs")
    paths, section, reports = sorted(folder.glob("*.g2o")), Section("Graphs in files"), []
    if not paths:
        section.paragraphs.append(f"Left out: there is no g2o file in {folder} (--graphs DIR or "
                                  "$SLAM_DATA_DIR name another folder).")
        return section
    for i, path in enumerate(paths):
        try:
            report = _solve_file(context, path, f"graph {i + 1} of {len(paths)}, {path.stem}")
        except BenchError as error:
            section.failures.append(f"{path.stem}: {error}")
            continue
        draw(context, path.stem, report, section)
        reports.append(report)
    section.paragraphs += describe(reports) if reports else []
    return section
