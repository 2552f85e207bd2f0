# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Benchmark calibration: what back-ends find out about wheels and sensor of a wrong robot file."""
