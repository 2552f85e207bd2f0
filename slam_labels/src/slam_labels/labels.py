# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which landmark has which label, while the map changes."""
import dataclasses
import math
from typing import Optional


class LabelError(Exception):
    """One sentence: what is wrong, where, and what to do."""


@dataclasses.dataclass
class Label:
    """A label and the landmark that it belongs to."""

    text: str
    id: Optional[int] = None       # of the landmark; None: known by its place alone so far
    place: Optional[tuple] = None  # (x, y) where the landmark was last [m]; None: never seen
    is_bound: bool = False         # the landmark is in the map


class Labels:
    """The labels of one map.

    A label goes with its landmark's id while that is in the map. When the id has gone, as where two
    landmarks were merged, it goes to the landmark nearest to its last place, within a radius [m]; so
    does a label that was given by a position. Where none is there the one waits for its id to come
    back, the other for a landmark at its position.
    """

    def __init__(self, labels=(), radius=1.0):
        self.all = list(labels)
        self.radius = radius

    def update(self, landmarks):
        """Takes the map, {id: (x, y)}; returns sentences on labels that cannot be kept."""
        homeless, sentences = [], []
        for label in self.all:
            was_bound, label.is_bound = label.is_bound, label.id in landmarks
            if label.is_bound:
                if not was_bound:
                    sentences += self._far_from_file(label, landmarks[label.id])
                label.place = landmarks[label.id]
            elif label.place is not None and (was_bound or label.id is None):
                homeless.append(label)
        return sentences + self._bind_by_place(homeless, landmarks)

    def _far_from_file(self, label, place):
        """Ids that are numbers of a run's own mean other landmarks in another one."""
        if label.place is None or math.dist(label.place, place) <= self.radius:
            return []
        return [f"the label '{label.text}' goes with landmark {label.id}, which is "
                f"{math.dist(label.place, place):.1f} m from the label's last place: if this is "
                "another landmark, take the ids out of the file"]

    def _bind_by_place(self, homeless, landmarks):
        """The nearest pairs come first; a landmark has one label."""
        taken = {label.id: label for label in self.all if label.is_bound}
        pairs = sorted((math.dist(label.place, place), number, identity)
                       for number, label in enumerate(homeless)
                       for identity, place in landmarks.items()
                       if math.dist(label.place, place) <= self.radius)
        sentences = {}
        for _, number, identity in pairs:
            label = homeless[number]
            if label.is_bound:
                continue
            if identity in taken:
                sentences[number] = (f"the label '{label.text}' has no landmark: landmark {identity}, "
                                     f"which is there, is called '{taken[identity].text}'")
                continue
            label.id, label.place, label.is_bound = identity, landmarks[identity], True
            taken[identity] = label
            sentences.pop(number, None)
        return list(sentences.values())

    def of_map(self):
        """{id: text} of the landmarks that are in the map, sorted by id."""
        return dict(sorted((label.id, label.text) for label in self.all if label.is_bound))

    def give(self, identity, text, landmarks):
        """Gives a landmark of the map a label; an empty one takes its label away. Returns what was
        done. Raises LabelError."""
        if identity not in landmarks:
            known = ", ".join(map(str, sorted(landmarks)[:20])) or "none yet"
            raise LabelError(f"there is no landmark {identity} in the map; there are: {known}")
        text = " ".join(text.split())
        former = next((label for label in self.all if label.id == identity), None)
        if not text:
            return self._take_away(identity, former)
        if former and former.text != text:
            raise LabelError(f"landmark {identity} is called '{former.text}' already; take that label "
                             "away first, by an empty one")
        if not former:
            self.all.append(Label(text, identity, landmarks[identity], True))
        return f"landmark {identity} is called '{text}'"

    def _take_away(self, identity, former):
        if former is None:
            raise LabelError(f"landmark {identity} has no label that could be taken away")
        self.all.remove(former)
        return f"landmark {identity} is no longer called '{former.text}'"
