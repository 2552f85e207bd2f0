# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The products that are measured, and what a simulated drive has to hold for them."""

EKF_WHEEL = "ekf_wheel"
PF_WHEEL_GRID = "pf_wheel_grid"
SENSORS = "odom,camera"


def sensors_for(product):
    """What a drive for this product has to hold."""
    return f"{SENSORS},ceiling_camera" if twin_of(product) else SENSORS


def twin_of(product):
    """For one of our products that look at the ceiling the one with wheels instead, else None."""
    backend, _, odometry = product.partition("_")
    return f"{backend}_wheel" if odometry in ("visual", "visual_wheel") else None
