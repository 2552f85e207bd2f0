# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The data set MRCLAM, which several benchmarks run on."""
from slam_eval.bench.harness.programs import data_folder
from slam_eval.bench.harness.runs import import_log

ROBOTS = (1, 2, 3, 4, 5)


def find_data(options, section):
    """The folder of the data set; None, and the section says so, where there is none."""
    data = options.data or data_folder("mrclam_dataset6")
    if data.is_dir():
        return data
    section.paragraphs.append(f"Left out: there is no folder {data} with a MRCLAM data set "
                              "(--data DIR or $SLAM_DATA_DIR name another one).")
    return None


def import_robot(context, data, robot):
    """The bag of a robot of the data set."""
    return import_log(context, f"robot{robot}", ["mrclam", data, "--robot", str(robot)])
