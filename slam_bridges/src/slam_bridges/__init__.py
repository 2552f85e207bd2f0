# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Detections of other packages as observations, live (node) and in bags (add_observations)."""
