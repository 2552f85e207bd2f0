# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Benchmark relocalisation: robots that are switched on somewhere in a map that they have made."""
