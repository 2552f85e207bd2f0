# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What benchmarks are made with: programs that are run and timed, logs, tables, goals, progress."""
