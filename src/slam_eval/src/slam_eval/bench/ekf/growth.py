# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part growth: what a step of the sparse information filter costs while its map grows."""
from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import workspace_program
from slam_eval.bench.harness.runs import call
from slam_eval.bench.harness.table import Section, number, table, verdict

BACKEND = "seif"
LARGEST_GROWTH = 1.0  # of the mean step from a tenth of the map to the whole map
COLUMNS = (("steps", "d", int), ("step, mean [ms]", ".2f", float), ("median [ms]", ".2f", float),
           ("99 % [ms]", ".1f", float), ("worst [ms]", ".0f", float), ("error [m]", ".2f", float),
           ("NEES", ".2f", float))
MEAN_STEP, MEDIAN_STEP = 2, 3  # in a row


def rows(text, landmarks):
    """Returns the rows (landmarks, steps, ...) of the table that slam_eval_growing_map has printed, without
    the one of the steps after the last landmark."""
    found = []
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) == len(COLUMNS) + 1 and cells[0].isdigit():
            found.append([int(cells[0]), *(read(cell) for cell, (_, _, read)
                                           in zip(cells[1:], COLUMNS))])
    found = [row for row in found if row[0] <= landmarks + landmarks // 20]
    if len(found) < 2:
        raise BenchError("slam_eval_growing_map has printed no two sizes of the map; build it again")
    return found


def remark(found):
    """Says by how much a step takes longer with the whole map than with a tenth of it."""
    first, last = found[0], found[-1]
    growth = last[MEAN_STEP] / first[MEAN_STEP]
    return (f"From {first[0]} to {last[0]} landmarks the mean step takes {growth:.2f} times as long "
            f"({verdict(growth, LARGEST_GROWTH, True)}), the median "
            f"{last[MEDIAN_STEP] / first[MEDIAN_STEP]:.2f} times.")


def measure(context):
    """The section of this part."""
    landmarks = context.options.field
    log = context.work / "growth.txt"
    command = [workspace_program("slam_eval", "slam_eval_growing_map"), "--backend", BACKEND,
               "--landmarks", str(landmarks)]
    call(context, f"a map that grows to {landmarks} landmarks", command, log)
    found = rows(log.read_text(encoding="utf-8"), landmarks)
    lines = [[str(row[0]), *(number(value, form) for value, (_, form, _)
                             in zip(row[1:], COLUMNS))] for row in found]
    return Section("A map that grows: the back-end seif", [
        table(["landmarks", *(name for name, _, _ in COLUMNS)], lines), remark(found),
        "A field of landmarks 3 m apart, driven over in lanes 6 m apart; CPU time of a step with the "
        "reported pose, for each tenth of the map."])
