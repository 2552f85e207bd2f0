# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""MRPT's programs, which Debian's mrpt-apps brings."""
from slam_eval.bench.harness.error import BenchError
from slam_eval.bench.harness.programs import system_program


def program(name):
    """The path of a program of MRPT. Raises BenchError."""
    path = system_program(name)
    if path is None:
        raise BenchError(f"the program {name} is not there; install mrpt-apps")
    return path
