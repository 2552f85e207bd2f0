# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What runs a foreign system on a bag."""
import dataclasses
import math
import pathlib
from typing import Callable, Optional

from slam_eval.bench.harness.error import BenchError


@dataclasses.dataclass(frozen=True)
class Job:
    """What a driver gets: the bag, the folder that takes the results, the seed, a robot file where
    the bag's own does not count, what is set (KEY=VALUE).

    call(command, log) runs a program to its end and returns its Usage; it raises BenchError with
    what the program said, and ends it where the campaign's time is over.
    """

    bag: pathlib.Path
    folder: pathlib.Path
    seed: int
    robot: Optional[str]
    settings: tuple
    call: Callable


class Driver:
    """Runs a foreign system. A class derived from it brings programs() and run().

    The system's file names the class and gives the defaults of its parameters.
    """

    required = ()      # the parameters that need a value
    numbers = ()       # those that are numbers
    not_negative = ()  # those that are numbers, 0 or above
    positive = ()      # those that are numbers above 0
    counts = ()        # those that are whole numbers above 0
    optional = ()      # of all these, those that need no value

    def __init__(self, parameters):
        """parameters: those of the system's file, with the values that the campaign sets, and
        'folder', where that file is."""
        self.parameters = parameters

    def number(self, name):
        """A parameter as a number. Raises BenchError."""
        value = self.parameters.get(name)
        try:
            number = float(value)
        except (TypeError, ValueError):
            number = math.nan
        if not math.isfinite(number):
            raise BenchError(f"the parameter {name} is '{value}', which is no number")
        return number

    def check(self):
        """Refuses parameters before anything starts. Raises BenchError."""
        for name in self.required:
            if self.parameters.get(name) is None:
                raise BenchError(f"the parameter {name} has no value; give it one under "
                                 "'parameters' in the system's file")
        for names, is_right, words in (
                (self.numbers, lambda value: True, "a number"),
                (self.not_negative, lambda value: value >= 0.0, "0 or above"),
                (self.positive, lambda value: value > 0.0, "above 0"),
                (self.counts, lambda value: value > 0.0 and value.is_integer(),
                 "a whole number above 0")):
            for name in names:
                is_needed = name not in self.optional or self.parameters.get(name) is not None
                if is_needed and not is_right(self.number(name)):
                    raise BenchError(f"the parameter {name} is '{self.parameters[name]}'; it has "
                                     f"to be {words}")

    def programs(self):
        """The files (paths) whose content the result depends on, beside the driver. Raises
        BenchError where one is missing, with the package that brings it."""
        raise NotImplementedError

    def run(self, job):
        """Runs the system on job.bag and leaves in job.folder what an own product would:
        trajectory.tum (needed), and of trajectory_final.tum, odometry.tum, landmarks.yaml, map.yaml
        with map.pgm what there is. Returns the Usage of the system alone. Raises BenchError.
        """
        raise NotImplementedError
