# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The programs that are measured beside ours, MRPT's: how each is configured, run and read."""
