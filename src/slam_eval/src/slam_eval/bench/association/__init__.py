# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Benchmark association: landmarks told apart by their places, judged by ids that are withheld."""
