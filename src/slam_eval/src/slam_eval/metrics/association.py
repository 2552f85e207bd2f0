# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""How well a run without ids told which landmark it saw, judged by the ids that it did not use."""
import dataclasses

UNKNOWN = -1  # an observation that not even its id tells the landmark of


@dataclasses.dataclass(frozen=True)
class Association:
    """Counts of a run. A landmark is that of the observation that it was begun with."""

    observations: int   # with an id, of landmarks that the map has
    paired: int         # of all, those that were taken for a landmark of the map
    wrong: int          # of these, for another one than that of the id
    right: int
    begun: int          # landmarks
    ghosts: int         # of those in the map at the end: of no id, or of one that is there already
    wrong_rows: tuple   # numbers of the wrong ones

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


def judge(rows, final_ids=None, before=None):
    """The Association of rows (io.associations).

    final_ids: the landmarks of the map at the end; default: all that were begun.
    before: only observations before this stamp count.
    """
    owner, known = {}, set()  # the id that a landmark was begun with; ids that the map has
    observations, right, wrong = 0, 0, []
    for number, row in enumerate(rows):
        if before is not None and row.stamp >= before:
            break
        if row.taken_for == "new":
            owner[row.landmark] = row.own_id
            known.add(row.own_id)
            continue
        observations += row.own_id != UNKNOWN and row.own_id in known
        if row.taken_for != "landmark":
            continue
        if row.own_id != UNKNOWN and owner.get(row.landmark) == row.own_id:
            right += 1
        else:
            wrong.append(number)
    return Association(observations, right + len(wrong), len(wrong), right, len(owner),
                       _ghosts(owner, final_ids), tuple(wrong))


def _ghosts(owner, final_ids):
    there = [owner[landmark] for landmark in sorted(owner)
             if final_ids is None or landmark in final_ids]
    return len(there) - len({own for own in there if own != UNKNOWN})
