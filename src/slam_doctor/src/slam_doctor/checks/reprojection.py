# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Does a camera's calibration fit the markers that its images show?"""
import numpy as np

from slam_doctor.finding import judged, ok, unknown
from slam_doctor.squares import calibration
from slam_doctor.squares.camera import camera_of

MARKERS, VIEWS = 4, 20    # different ones, at least
SIGNIFICANT = 40.0        # chi-square with 6 degrees of freedom from which a calibration is wrong
OFF = (0.005, 0.03)       # near the border, share of the width: WARN, ERROR
SCATTER = 0.3             # of the corners, at most, for anything to be said [px]
TOO_VAGUE = 0.01          # standard deviation of that, share of the width
AGAIN = ("Calibrate again (camera_calibration), with the board in all corners of the image; is the "
         "camera_info that of this camera, this lens and this resolution?")
MORE = ("Record a drive that sees several markers from near, obliquely, and in all parts of the "
        "image.")


def judge(name, info, sightings):
    """The Finding of that name about a camera_info and the Sightings of markers."""
    camera, sightings = camera_of(info), calibration.usable(sightings)
    markers = {each.id for each in sightings}
    views = len(set(calibration.kinds_of_views(camera, sightings))) if sightings else 0
    if len(markers) < MARKERS or views < VIEWS:
        return unknown(name, f"{len(markers)} markers in {views} different views are too few to "
                       "check the calibration", MORE)
    try:
        fit = calibration.fit(camera, sightings)
    except np.linalg.LinAlgError:
        return unknown(name, "the corners of the markers fit no camera", AGAIN)
    return finding(name, camera, fit, len(sightings))


def finding(name, camera, fit, count):
    """The Finding of a Fit to so many sightings."""
    width = camera.size[0]
    if not fit.corner_sigma < SCATTER:
        return unknown(name, f"the corners of {count} markers scatter by {fit.corner_sigma:.1f} px "
                       "about any calibration", "Are the images sharp, the markers flat, and is "
                       "the distortion model that of the lens?")
    off = f"near the border of the image it is off by {fit.off:.1f} +- {fit.sigma:.1f} px"
    if fit.chi_square > SIGNIFICANT and fit.least_off > OFF[0] * width:
        better = calibration.changed(camera, fit.change)
        (fx, fy), (cx, cy) = better.focal, better.centre
        return judged(name, f"the calibration does not fit the corners of {count} markers: {off}; "
                      f"they show fx {fx:.0f}, fy {fy:.0f}, cx {cx:.0f}, cy {cy:.0f} px", AGAIN,
                      fit.least_off, [share * width for share in OFF], "px")
    if fit.sigma > TOO_VAGUE * width:
        return unknown(name, f"the markers tell the calibration near the border of the image only "
                       f"to {fit.sigma:.0f} px", MORE)
    return ok(name, f"the calibration fits the corners of {count} markers: {off}", fit.off, "px")
