# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parts office, corridor and repeated: markers with ids that a camera sees, some of them twice."""
import bisect

from slam_eval.bench.harness.process import run
from slam_eval.bench.harness.programs import workspace_program
from slam_eval.bench.harness.runs import simulate
from slam_eval.bench.relocalisation.cases import Cases, map_of
from slam_eval.bench.relocalisation.log import Log, renaming
from slam_eval.bench.relocalisation.starts import Case, SECOND, Start
from slam_eval.io.landmarks import read_landmarks

PRODUCT = "ekf_wheel"
LIMIT = 2.0               # after the second marker [s]
THEN = 4                  # a drive goes on so long after the second marker [s]
LONGEST = 30              # within which a second marker must come into view [s]
REMARK = (f"Time counts from the second marker of the map that comes into view; the aim is {LIMIT:g} s. "
          "Map and starts are of one drive.")


def seen_in(context, name, bag, product):
    """The bag of what a product's detector sees in a bag."""
    out = context.work / f"{name}_observations.bag"
    context.progress.begin(f"observations of {name}")
    run([workspace_program("slam_eval", "slam_eval_observations"), product, bag, out],
        context.work / f"{name}_observations.log")
    return out


def mapped(arrays, ids, in_map):
    """The markers that a map holds, of several with one id the one that was seen first.

    arrays: those of Log.observations(), before the markers got other ids; ids: the new ones by the
    old; in_map: ids of the map.
    """
    first = {}
    for _, seen in arrays:
        for marker in seen:
            first.setdefault(ids.get(marker, marker), marker)
    return {first[i] for i in in_map if i in first}


class SecondMarker:
    """Makes a Start of a stamp: time counts from the second of the map's markers."""

    def __init__(self, log, known):
        arrays = [(stamp, [i for i in ids if i in known]) for stamp, ids in log.observations()]
        self._arrays = [entry for entry in arrays if entry[1]]
        self._stamps = [stamp for stamp, _ in self._arrays]
        self._end = log.end

    def __call__(self, stamp):
        seen = set()
        for when, ids in self._arrays[bisect.bisect_left(self._stamps, stamp):]:
            seen.update(ids)
            if when - stamp > LONGEST * SECOND or when + THEN * SECOND > self._end:
                return None
            if len(seen) > 1:
                return Start(stamp, when, when + THEN * SECOND)
        return None


def _simulated(context, world):
    """The bags of a drive through a world and of the markers that are seen on it."""
    if world not in context.made:
        bag = simulate(context, world, world, context.options.seed, "odom,camera")
        context.made[world] = bag, seen_in(context, world, bag, PRODUCT)
    return context.made[world]


def _case(context, name, bags, ids=None):
    """A case with the map of its own drive, and what makes its starts. ids: new ones by the old."""
    true, log = Log(*bags), Log(*bags, change=renaming(ids or {}))
    whole = log.write(context.work / f"{name}_log.bag".replace(" ", "_"))
    settings = ("detector=none",)
    folder, truth = map_of(context, name.replace(" ", "_"), whole, PRODUCT, settings)
    known = mapped(true.observations(), ids or {}, read_landmarks(folder / "landmarks.yaml").ids)
    case = Case(name, log, folder, truth, PRODUCT, settings, LIMIT)
    return case, SecondMarker(true, known)


def _measure(context, world, title):
    cases = Cases(context, title)
    cases.add(*_case(context, world, _simulated(context, world)), least=1.0)
    return cases.finished(REMARK)


def measure_office(context):
    """The section of part office."""
    return _measure(context, "office", "Office with markers")


def measure_corridor(context):
    """The section of part corridor."""
    return _measure(context, "corridor", "Corridor with markers")


def measure_repeated(context):
    """The section of part repeated."""
    cases = Cases(context, "Markers that are not unique")
    office, corridor = (_simulated(context, world) for world in ("office", "corridor"))
    cases.add(*_case(context, "office repeated", office, {5: 0, 9: 3}), least=1.0)
    twice = {i: (i + 37) % 100 for i in range(0, 100, 5)}
    cases.add(*_case(context, "corridor repeated", corridor, twice), least=1.0)
    case, start_of = _case(context, "corridor halves", corridor)
    case.settings = (*case.settings, "association=jcbb")
    cases.add(case, start_of)
    return cases.finished(
        REMARK, "office repeated: two of twelve markers have ids of others; corridor repeated: 20 of "
        "100. corridor halves: ids are not looked at, and the two halves of the corridor are the same, "
        "so that nobody can know where the robot is.")
