# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part mrclam: the five robots of a MRCLAM set, their bar codes not looked at."""
from slam_eval.bench.association.policies import DEFINITIONS, run_all, table_of
from slam_eval.bench.harness.mrclam import find_data, import_robot, ROBOTS
from slam_eval.bench.harness.table import Section

LARGEST_RATIO, LARGEST_WRONG = 1.05, 0.005  # of the ATE with ids; of the pairings


def _verdict(lines):
    ekf = {policy: [line for line in lines if line[1:3] == ["ekf_wheel", policy]]
           for policy in ("known_ids", "jcbb")}
    if not all(ekf.values()):
        return []
    with_ids, without = (sum(line[3] for line in ekf[p]) for p in ("known_ids", "jcbb"))
    paired = sum(line[4] for line in ekf["jcbb"])
    wrong = sum(line[4] * line[7] for line in ekf["jcbb"] if line[4])
    return [f"EKF with jcbb: {without / with_ids:.2f} times the ATE with ids (at most "
            f"{LARGEST_RATIO}), {wrong / max(1, paired):.2%} wrong (at most {LARGEST_WRONG:.1%})."]


def measure(context):
    """The section of this part."""
    section = Section("MRCLAM, ids withheld")
    data = find_data(context.options, section)
    if data is None:
        return section
    lines = [line for robot in ROBOTS
             for line in run_all(context, f"robot{robot}", import_robot(context, data, robot),
                                 section, "mrclam")]
    section.paragraphs += [table_of(lines), DEFINITIONS, *_verdict(lines)]
    return section
