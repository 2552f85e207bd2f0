# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files as data: what a run, MRPT or a simulation wrote, read, checked and held in data classes.

A reader, the data class it returns and what concerns that data alone belong here, and the one error
of a file that cannot be used. Nothing here judges a run."""
