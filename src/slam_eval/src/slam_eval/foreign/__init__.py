# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Foreign systems under the contract of ours: a bag in, a trajectory and a map out."""
