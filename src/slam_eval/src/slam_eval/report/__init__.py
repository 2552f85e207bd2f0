# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is told of a run: the table on a terminal, the HTML page, the files that slam_eval adds.

The names and meanings of the keys of metrics.json, the pages, and the programs that judge a run or
a map belong here."""
