# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a camera says: its calibration, and measures of some of its images."""
import dataclasses
import io

import numpy as np

from slam_doctor.record.thinned import Thinned

SATURATED, BLACK = 250, 5  # grey values from which, and up to which, an image shows nothing
MEASURED, KEPT = 64, 48    # images, at most
MEMORY, LEAST = 64e6, 12   # what kept images may take [bytes], but so many are kept
THUMBNAIL = (16, 12)       # columns and rows
# How many bytes a pixel has, and which of them are its brightness.
ENCODINGS = {"mono8": (1, [0]), "8UC1": (1, [0]), "rgb8": (3, [0, 1, 2]), "bgr8": (3, [0, 1, 2]),
             "8UC3": (3, [0, 1, 2]), "rgba8": (4, [0, 1, 2]), "bgra8": (4, [0, 1, 2]),
             "mono16": (2, [1]), "yuv422": (2, [1]), "yuv422_yuy2": (2, [0]),
             **{f"bayer_{order}8": (1, [0]) for order in ("rggb", "bggr", "gbrg", "grbg")},
             **{f"bayer_{order}16": (2, [1]) for order in ("rggb", "bggr", "gbrg", "grbg")}}


class ImageFault(Exception):
    """An image that cannot be used; the message says why."""


def grey(message, is_compressed):
    """The picture of a message as an array of bytes, rows x columns. Raises ImageFault."""
    return decoded(message.data) if is_compressed else unpacked(message)


def decoded(data):
    """The picture of a JPEG or PNG."""
    from PIL import Image  # only where images come compressed
    try:
        return np.array(Image.open(io.BytesIO(data)).convert("L"))
    except Exception as fault:  # of damaged data Pillow raises whatever it stumbles over
        raise ImageFault("damaged data") from fault


def unpacked(message):
    """The picture of an uncompressed image."""
    if message.encoding not in ENCODINGS:
        raise ImageFault(f"encoding {message.encoding or '(empty)'}")
    size, channels = ENCODINGS[message.encoding]
    if message.is_bigendian and channels == [1] and not message.encoding.startswith("yuv"):
        channels = [0]
    row = message.width * size
    if message.step < row or len(message.data) < message.height * message.step or not row:
        raise ImageFault("fewer bytes than the size needs")
    rows = np.frombuffer(message.data, np.uint8)[:message.height * message.step]
    pixels = rows.reshape(message.height, message.step)[:, :row].reshape(message.height, -1, size)
    return pixels[:, :, channels].mean(axis=-1).astype(np.uint8)


@dataclasses.dataclass(frozen=True)
class Measure:
    """What is measured of one image."""

    stamp: float         # [s]
    sharpness: float     # standard deviation of the Laplacian over the mean brightness [1]
    mean: float          # brightness, of 255
    saturated: float     # share of the pixels
    black: float         # share of the pixels
    thumbnail: np.ndarray


def thumbnail(picture):
    """The picture in few pixels, each the mean of its area."""
    columns, rows = THUMBNAIL
    height, width = picture.shape[0] // rows * rows, picture.shape[1] // columns * columns
    if not height or not width:
        return np.zeros((rows, columns))
    areas = picture[:height, :width].reshape(rows, height // rows, columns, width // columns)
    return areas.mean(axis=(1, 3))


def measure(stamp, picture):
    """The Measure of a picture."""
    values = picture.astype(np.float32)
    laplacian = (values[:-2, 1:-1] + values[2:, 1:-1] + values[1:-1, :-2] + values[1:-1, 2:] -
                 4 * values[1:-1, 1:-1])
    mean = float(values.mean())
    spread = float(laplacian.std()) if laplacian.size else 0.0
    return Measure(stamp, spread / max(mean, 1.0), mean, float((picture >= SATURATED).mean()),
                   float((picture <= BLACK).mean()), thumbnail(picture))


class ImageRecord:
    """The images of one topic."""

    def __init__(self, start, is_compressed):
        self._start, self._is_compressed = start, is_compressed
        self.frames, self.sizes, self.faults = set(), {}, {}
        self.count = self.repeated = 0
        self._last = None
        self.measures = Thinned(MEASURED)
        self.pictures = Thinned(KEPT)

    def take_raw(self, raw, kind):
        """Takes a message that is still packed; most are passed over, as unpacking takes time."""
        self.count += 1
        content = hash(raw[16:])  # behind sequence and stamp
        self.repeated += content == self._last
        self._last = content
        if self.measures.wants_next() or self.pictures.wants_next():
            self._take(kind().deserialize(raw))
        else:
            self.measures.append(None)
            self.pictures.append(None)

    def _take(self, message):
        stamp = (message.header.stamp.to_nsec() - self._start) / 1e9
        self.frames.add(message.header.frame_id.lstrip("/"))
        try:
            picture = grey(message, self._is_compressed)
        except ImageFault as fault:
            self.faults[str(fault)] = self.faults.get(str(fault), 0) + 1
            return
        size = (picture.shape[1], picture.shape[0])
        self.sizes[size] = self.sizes.get(size, 0) + 1
        self.measures.append(measure(stamp, picture))
        self.pictures.append(picture)
        self.pictures.lower(max(LEAST, int(MEMORY // max(1, picture.size))))


class CalibrationRecord:
    """The calibration that a camera_info names first, and how often it changes."""

    def __init__(self):
        self.first, self.count, self.changes = None, 0, 0
        self._last = None

    def take(self, message):
        """Takes a message."""
        self.count += 1
        content = (message.width, message.height, tuple(message.K), tuple(message.D))
        self.first = self.first or message
        self.changes += self._last not in (None, content)
        self._last = content
