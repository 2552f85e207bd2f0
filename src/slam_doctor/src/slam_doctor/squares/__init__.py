# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Images of square markers, and what they say about the camera: camera <- poses <- calibration."""
