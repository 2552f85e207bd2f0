# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Relations between poses as a reference, and a run's errors against them (Kuemmerle et al. 2009).

A relation says where the robot of one stamp stands in the frame of another; people made them from
scans of the log, so that they judge the trajectory without any global truth.
"""
import dataclasses

import numpy as np

from slam_eval.geometry import se2
from slam_eval.io.errors import InputError
from slam_eval.io.relations import read_relations, read_source_stamps, SourceStamps
from slam_eval.io.trajectory import NANOSECONDS

# Logs round their stamps to 10 ms: a relation's stamp means the nearest scan's within so much.
TOLERANCE = NANOSECONDS // 100
# Where one scan alone lies so near, the stamp can mean no other.
AMBIGUOUS_WITHIN = NANOSECONDS // 100
# Stamps of one log differ from those of its relations by no more [s].
LARGEST_SHIFT = 1.0


@dataclasses.dataclass
class RelationErrors:
    """Absolute errors [m], [rad] of the relations that the run has poses for, and how many not."""

    translation: np.ndarray
    rotation: np.ndarray
    missing: int
    is_unambiguous: np.ndarray  # both stamps can mean one scan only
    is_revisit: np.ndarray      # the two stamps are no neighbours among those of all relations

    @property
    def metrics(self):
        """The keys of metrics.json."""
        return {"relations": len(self.translation),
                "relations_trans_mean_m": float(np.mean(self.translation)),
                "relations_trans_std_m": float(np.std(self.translation)),
                "relations_rot_mean_deg": float(np.degrees(np.mean(self.rotation))),
                **self._part("unambiguous", self.is_unambiguous),
                **self._part("revisit", self.is_revisit)}

    def _part(self, name, chosen):
        """The same keys of some of the relations; none where there are none of them."""
        keys = {f"relations_{name}": int(np.count_nonzero(chosen))}
        if np.any(chosen):
            keys[f"relations_{name}_trans_mean_m"] = float(np.mean(self.translation[chosen]))
            keys[f"relations_{name}_rot_mean_deg"] = float(
                np.degrees(np.mean(self.rotation[chosen])))
        return keys


def nearest_written(table, stamps, tolerance=TOLERANCE):
    """Written stamps of the scans nearest to the given source stamps [ns]: (stamps, valid)."""
    after = np.clip(np.searchsorted(table.source, stamps), 0, len(table.source) - 1)
    before = np.maximum(after - 1, 0)
    nearer = np.abs(table.source[before] - stamps) <= np.abs(table.source[after] - stamps)
    nearest = np.where(nearer, before, after)
    return table.written[nearest], np.abs(table.source[nearest] - stamps) <= tolerance


def means_one_scan(table, stamps):
    """Whether exactly one scan of the log lies near each of the stamps [ns]."""
    before = np.concatenate([[0], np.cumsum(table.scans)])
    first = np.searchsorted(table.source, stamps - AMBIGUOUS_WITHIN, side="left")
    last = np.searchsorted(table.source, stamps + AMBIGUOUS_WITHIN, side="right")
    return before[last] - before[first] == 1


def _joins_no_neighbours(pairs):
    """Whether between the two stamps of a relation lies a stamp of another one."""
    index = np.searchsorted(np.unique(pairs), pairs)
    return np.abs(index[:, 1] - index[:, 0]) > 1


def _index(trajectory, stamps):
    """Index of each stamp in a trajectory, and whether it is there."""
    index = np.clip(np.searchsorted(trajectory.stamps, stamps), 0, len(trajectory) - 1)
    return index, trajectory.stamps[index] == stamps


def poses_at(final, odometry, stamps):
    """Poses (N x 3) at the stamps [ns], and whether there are any: those of the trajectory, carried
    on by the odometry where the stamp lies between two of them."""
    base = np.searchsorted(final.stamps, stamps, side="right") - 1
    valid = base >= 0
    poses = final.poses[np.maximum(base, 0)].copy()
    between = valid & (final.stamps[np.maximum(base, 0)] != stamps)
    if odometry is None:
        return poses, valid & ~between
    start, has_start = _index(odometry, final.stamps[np.maximum(base, 0)])
    end, has_end = _index(odometry, stamps)
    for i in np.flatnonzero(between & has_start & has_end):
        moved = se2.compose(se2.inverse(odometry.poses[start[i]]), odometry.poses[end[i]])
        poses[i] = se2.compose(poses[i], moved)
    return poses, valid & (~between | (has_start & has_end))


def relation_errors(relations, final, odometry, table=None, tolerance=TOLERANCE):
    """Errors of a final trajectory. table: SourceStamps, where the bag's are not the log's;
    tolerance [ns] between a relation's stamp and its scan's.

    None where the run has poses for no relation.
    """
    stamps = relations.stamps.ravel()
    if table is None:
        own = final.stamps if odometry is None else np.union1d(final.stamps, odometry.stamps)
        table = SourceStamps(own, own)
    written, known = nearest_written(table, stamps, tolerance)
    poses, valid = poses_at(final, odometry, written)
    valid = (known & valid).reshape(-1, 2).all(axis=1)
    if not np.any(valid):
        return None
    pairs = poses.reshape(-1, 2, 3)[valid]
    errors = se2.relative(relations.deltas[valid], se2.relative(pairs[:, 0], pairs[:, 1]))
    is_unambiguous = means_one_scan(table, stamps).reshape(-1, 2).all(axis=1)
    return RelationErrors(np.linalg.norm(errors[:, :2], axis=1), np.abs(errors[:, 2]),
                          int(np.count_nonzero(~valid)), is_unambiguous[valid],
                          _joins_no_neighbours(relations.stamps)[valid])


def _remedy(relations, table):
    """What to do where no scan has a relation's stamp."""
    if table is None:
        return (" and no stamps.csv of its log: import the log anew, or give the table with "
                "--stamps")
    stamps = relations.stamps.ravel()
    nearest, _ = nearest_written(SourceStamps(table.source, table.source), stamps)
    gap = np.max(np.abs(nearest - stamps)) / NANOSECONDS
    if gap > LARGEST_SHIFT:
        return "; is it of another log?"
    return (f"; the scans nearest to them are stamped up to {gap:.2f} s apart: "
            f"--tolerance {gap + 0.1:.1f} takes them")


def judge_run(run, relations_path, stamps_path=None, tolerance=TOLERANCE):
    """RelationErrors of a run. Raises InputError, also where no relation fits."""
    relations = read_relations(relations_path)
    if run.final is None:
        raise InputError(f"{run.path}: holds no trajectory_final.tum, which relations are held "
                         "against; run the product again")
    beside = run.path / "stamps.csv"
    stamps_path = stamps_path or (beside if beside.exists() else None)
    table = read_source_stamps(stamps_path) if stamps_path else None
    errors = relation_errors(relations, run.final, run.odometry, table, tolerance)
    if errors is None:
        raise InputError(f"{relations_path}: the run has poses for none of its {len(relations)} "
                         f"relations{_remedy(relations, table)}")
    return errors
