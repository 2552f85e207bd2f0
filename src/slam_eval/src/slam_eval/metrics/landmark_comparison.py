# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Mean landmark error of maps against one truth file, for ours and for MRPT's in the same way."""
import numpy as np

from slam_eval.io.errors import InputError
from slam_eval.metrics.evaluation import landmark_error


def compare(estimate, truth, align=False):
    """Error figures [m] of the landmarks both maps hold, as a dictionary."""
    error = landmark_error(estimate, truth, align)
    if error is None:
        raise InputError("too few landmarks have an id that the truth file has too; "
                         "check that both belong to the same run")
    return {"landmarks": len(estimate), "matched": len(error.ids),
            "mean_m": float(np.mean(error.errors)), "rmse_m": error.rmse,
            "max_m": float(np.max(error.errors))}
