# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The doctor: checks a recorded or running robot for what makes SLAM fail."""
