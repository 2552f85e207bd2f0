# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where the robot was at one scan, seen from another: how scans are held against odometry."""
