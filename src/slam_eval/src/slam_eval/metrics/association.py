# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""How well a run without ids told which landmark it saw, judged by the ids that it did not use."""
import collections
import dataclasses

UNKNOWN = -1  # an observation that not even its id tells the landmark of


@dataclasses.dataclass(frozen=True)
class Association:
    """Counts of a run. A landmark is that of the observation that it was begun with."""

    observations: int   # with an id, of landmarks that the map has
    paired: int         # of all, those that were taken for a landmark and can be judged
    wrong: int          # of these, for another one than that of the id
    right: int
    begun: int          # landmarks
    ghosts: int         # of those in the map at the end: of no id, or of one that is there already
    wrong_rows: tuple   # numbers of the wrong ones
    unjudged: int       # paired, but neither the observation nor the landmark's first one has an id

    @property
    def precision(self):
        """Share of the pairings that are right; None where there are none."""
        return self.right / self.paired if self.paired else None

    @property
    def recall(self):
        """Share of the observations of mapped landmarks that are paired with theirs."""
        return self.right / self.observations if self.observations else None

    @property
    def wrong_share(self):
        """Share of the pairings that are wrong."""
        return self.wrong / self.paired if self.paired else None


def as_revised(rows):
    """The rows as they stand at the end: what was decided later or taken back replaces what was
    decided at first. Such a row has the stamp of its observation, which is before the last one."""
    revised, newest = [], None
    of = collections.defaultdict(list)  # the numbers of the rows of a stamp and own id
    for row in rows:
        if newest is None or row.stamp >= newest:
            newest = row.stamp
            of[row.stamp, row.own_id].append(len(revised))
            revised.append(row)
            continue
        for number in of[row.stamp, row.own_id]:
            before = revised[number]
            is_taken_back = before.taken_for == "landmark" and before.landmark == row.landmark
            if is_taken_back if row.taken_for == "taken_back" else before.taken_for != "landmark":
                revised[number] = row
                break
    return revised


def judge(rows, final_ids=None, before=None):
    """The Association of rows (io.associations), in the order of their stamps.

    final_ids: the landmarks of the map at the end; default: all that were begun.
    before: only observations before this stamp count.
    """
    rows = [row for row in rows if before is None or row.stamp < before]
    owner = {row.landmark: row.own_id for row in rows if row.taken_for == "new"}
    known = set()  # ids that the map has
    observations, right, unjudged, wrong = 0, 0, 0, []
    for number, row in enumerate(rows):
        if row.taken_for == "new":
            known.add(row.own_id)
            continue
        observations += row.own_id != UNKNOWN and row.own_id in known
        if row.taken_for != "landmark":
            continue
        if owner.get(row.landmark) == row.own_id:
            right += row.own_id != UNKNOWN
            unjudged += row.own_id == UNKNOWN
        else:
            wrong.append(number)
    return Association(observations, right + len(wrong), len(wrong), right, len(owner),
                       _ghosts(owner, final_ids), tuple(wrong), unjudged)


def _ghosts(owner, final_ids):
    there = [owner[landmark] for landmark in sorted(owner)
             if final_ids is None or landmark in final_ids]
    return len(there) - len({own for own in there if own != UNKNOWN})
