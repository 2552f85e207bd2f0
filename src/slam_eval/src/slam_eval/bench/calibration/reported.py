# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a run prints of its calibration."""
import dataclasses
import re

_LINE = re.compile(r"^calibrated (\w+): (\S+) with a standard deviation of (\S+) \[[^]]*\], "
                   r"([^\s;]+) before", re.MULTILINE)


@dataclasses.dataclass(frozen=True)
class Reported:
    """A parameter as a run reported it, with its standard deviation after and before the drive."""

    value: float
    sigma: float
    before: float


def reported(text):
    """{parameter: Reported} of what a run has printed."""
    return {name: Reported(float(value), float(sigma), float(before))
            for name, value, sigma, before in _LINE.findall(text)}


@dataclasses.dataclass(frozen=True)
class Estimate:
    """A parameter beside what a calibration should find."""

    reported: Reported
    true: float

    @property
    def sigmas(self):
        """The error in standard deviations as reported."""
        return (self.reported.value - self.true) / self.reported.sigma


def estimates(text, true_values):
    """{parameter: Estimate} of what a run has printed; true_values: {parameter: value}."""
    return {name: Estimate(known, true_values[name]) for name, known in reported(text).items()}
