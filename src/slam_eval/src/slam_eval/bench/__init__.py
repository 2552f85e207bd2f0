# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The benchmarks behind slam_bench: a module or a folder each, a function `measure` for each part.

`bench/ekf/mrclam.py` is the part mrclam of `slam_bench ekf`. Benchmarks do not import one another:
what several of them need belongs in harness, what concerns another program in peers."""
