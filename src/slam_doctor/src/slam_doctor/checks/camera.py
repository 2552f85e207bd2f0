# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Are a camera's images usable: size, encoding, sharpness, exposure, calibration?"""
import math

import numpy as np

from slam_doctor.finding import error, judged, ok, warn

SHARP = 0.02          # standard deviation of the Laplacian over the brightness, below: WARN
# An image is blurred below this share of the sharpest tenth; WARN with so many of them.
BLURRED = (0.35, 0.3)
SATURATED = (0.15, 0.5)  # share of the pixels: WARN, ERROR
BLACK = (0.3, 0.8)
DARK = 25.0           # mean brightness of 255, below: WARN
FOCAL = (0.3, 4.0)    # focal length over the width
CENTRE = 0.15         # of the principal point from the image's middle, share of the width
SKEWED = 0.05         # fx and fy differ by this share


def check(case):
    """Findings about all cameras."""
    found = []
    for camera in case.cameras():
        record = camera.topic.record
        found += [usable(camera, record), *looks(camera, record), *repeated(camera, record, case),
                  calibration(camera, record)]
    return found


def usable(camera, record):
    """Size and encoding."""
    name, looked = f"{camera.name}.images", len(record.measures.items)
    if record.faults:
        fault = max(record.faults, key=record.faults.get)
        count = sum(record.faults.values())
        make = error if count > 0.05 * (count + looked) else warn
        return make(name, f"{camera.topic.name}: {count} of {count + looked} images cannot be "
                    f"used: {fault}", "Publish 8 bit grey or colour images, raw or as JPEG or "
                    "PNG.", count,
                    "images")
    sizes = [f"{width} x {height}" for width, height in record.sizes]
    if len(sizes) > 1:
        return error(name, f"{camera.topic.name}: images of several sizes: {', '.join(sizes)}",
                     "Use one resolution; look for two cameras on one topic.", len(sizes), "sizes")
    return ok(name, f"{camera.topic.name}: {', '.join(sizes)} px")


def looks(camera, record):
    """Sharpness and exposure."""
    measures = record.measures.items
    if not measures:
        return []
    return [sharpness(camera, np.array([m.sharpness for m in measures])),
            exposure(camera, measures)]


def sharpness(camera, values):
    """How much fine detail the images have."""
    name, median = f"{camera.name}.sharpness", float(np.median(values))
    text = f"{camera.topic.name}: sharpness {median:.3f} (Laplacian over brightness)"
    if median < SHARP:
        return warn(name, f"{text}: images are blurred, or show nothing", "Focus the lens, clean "
                    "it, and shorten the exposure.", median, "1")
    blurred = float((values < BLURRED[0] * np.quantile(values, 0.9)).mean())
    if blurred > BLURRED[1]:
        return warn(name, f"{text}; {100 * blurred:.0f} % of the images are much less sharp than "
                    "the sharpest", "Shorten the exposure, add light, or turn more slowly.", median,
                    "1")
    return ok(name, text, median, "1")


def exposure(camera, measures):
    """Shares of pixels that show nothing, and brightness."""
    name = f"{camera.name}.exposure"
    mean, saturated, black = (float(np.median([getattr(m, key) for m in measures]))
                              for key in ("mean", "saturated", "black"))
    text = (f"{camera.topic.name}: brightness {mean:.0f} of 255, {100 * saturated:.0f} % "
            f"saturated, {100 * black:.0f} % black")
    if saturated > SATURATED[0]:
        return judged(name, text, "Shorten the exposure or lower the gain.", saturated, SATURATED)
    if black > BLACK[0]:
        return judged(name, text, "Add light, or lengthen the exposure; is the lens "
                      "covered?", black,
                      BLACK)
    if mean < DARK:
        return warn(name, text, "Add light, or raise the gain.", mean, "of 255")
    return ok(name, text, mean, "of 255")


def repeated(camera, record, case):
    """Images that are the same to the bit."""
    share = record.repeated / max(1, record.count - 1)
    if share < 0.1 or record.count < 5:
        return []
    moves = case.path is not None and np.ptp(case.path.x) + np.ptp(case.path.y) > 0.3
    make = error if moves and share > 0.5 else warn
    return [make(f"{camera.name}.frozen", f"{camera.topic.name}: {100 * share:.0f} % of the images "
                 "are those before, to the bit", "The driver repeats frames: look at its cable and "
                 "at the frame rate.", 100 * share, "%")]


def calibration(camera, record):
    """Whether there is a calibration that can be."""
    name = f"{camera.name}.calibration"
    told = camera.calibration.record if camera.calibration else None
    if told is None or told.first is None:
        return error(name, f"no camera_info comes beside {camera.topic.name}",
                     "Calibrate the camera (camera_calibration) and let its driver publish "
                     "camera_info.")
    info = told.first
    sizes = list(record.sizes)
    if len(sizes) == 1 and sizes[0] != (info.width, info.height):
        return error(name, f"camera_info is for {info.width} x {info.height} px, images have "
                     f"{sizes[0][0]} x {sizes[0][1]}", "Calibrate at the resolution that is used.")
    fault = fault_of(info)
    if fault:
        make, text, advice = fault
        return make(name, f"{camera.calibration.name}: {text}", advice)
    if told.changes:
        return warn(name, f"{camera.calibration.name}: the calibration changes {told.changes} "
                    "times",
                    "Look for two publishers; SLAM takes one calibration.", told.changes, "times")
    fx, fy, cx, cy = info.K[0], info.K[4], info.K[2], info.K[5]
    view = math.degrees(2 * math.atan(info.width / (2 * fx)))
    return ok(name, f"{camera.calibration.name}: fx {fx:.0f}, fy {fy:.0f}, cx {cx:.0f}, cy "
              f"{cy:.0f} px, {view:.0f} deg wide, {info.distortion_model or 'no distortion'}", fx,
              "px")


def fault_of(info):
    """(kind of Finding, text, advice) of a calibration that cannot be; None of one that can."""
    again = "Calibrate again (camera_calibration), with the board in all corners of the image."
    fx, fy, cx, cy = info.K[0], info.K[4], info.K[2], info.K[5]
    if not all(map(math.isfinite, [*info.K, *info.D])):
        return error, "the calibration holds NaN or infinity", again
    if not info.width or not info.height:
        return error, "the calibration names no size of the image", again
    if fx <= 0 or fy <= 0:
        return error, "the camera is not calibrated (focal length 0)", again
    if not FOCAL[0] < fx / info.width < FOCAL[1]:
        return warn, f"a focal length of {fx:.0f} px for {info.width} px is unusual", again
    if abs(fx / fy - 1.0) > SKEWED:
        return warn, f"fx {fx:.0f} and fy {fy:.0f} px differ", again
    off = math.hypot(cx - info.width / 2, cy - info.height / 2) / info.width
    if off > CENTRE:
        return warn, f"the principal point ({cx:.0f}, {cy:.0f}) is far from the image's "
        "middle", again
    if info.distortion_model in ("plumb_bob", "rational_polynomial") and folds(info):
        return warn, "the distortion folds the image back before its corners", again
    return None


def folds(info):
    """Whether the distorted radius stops growing with the true one within the image."""
    d = [*info.D, *[0.0] * 8]
    corner = math.hypot(max(info.K[2], info.width - info.K[2]) / info.K[0],
                        max(info.K[5], info.height - info.K[5]) / info.K[4])
    s = np.linspace(0.0, corner, 100) ** 2
    factor = (1 + s * (d[0] + s * (d[1] + s * d[4]))) / (1 + s * (d[5] + s * (d[6] + s * d[7])))
    return bool((np.diff(np.sqrt(s) * factor) <= 0).any())
