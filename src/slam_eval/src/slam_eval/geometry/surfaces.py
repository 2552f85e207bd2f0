# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a laser can see of a simulated world: vertical faces, from above line segments."""
import numpy as np

_SPACING = 0.01  # of the samples along a face [m]


class Surfaces:
    """Line segments (N x 2 x 2) [m] in the frame of the truth."""

    def __init__(self, segments):
        self.segments = np.asarray(segments, dtype=float).reshape(-1, 2, 2)
        self.along = self.segments[:, 1] - self.segments[:, 0]
        self.lengths = np.linalg.norm(self.along, axis=1)

    def nearest(self, points):
        """(index of the nearest segment, signed distance to it, left of it positive) of points."""
        best = np.full(len(points), np.inf)
        index, signed = np.zeros(len(points), int), np.zeros(len(points))
        for i, ((start, _), along, length) in enumerate(
                zip(self.segments, self.along, self.lengths)):
            offset = points - start
            share = np.clip(offset @ along / length ** 2, 0.0, 1.0)
            away = offset - share[:, None] * along
            distance = np.linalg.norm(away, axis=1)
            nearer = distance < best
            best[nearer], index[nearer] = distance[nearer], i
            side = np.sign(along[0] * offset[:, 1] - along[1] * offset[:, 0])
            signed[nearer] = (side * distance)[nearer]
        return index, signed

    def cast(self, origin, angles):
        """(index of the segment hit, distance) of rays; infinity where there is none."""
        direction = np.column_stack([np.cos(angles), np.sin(angles)])
        best = np.full(len(angles), np.inf)
        index = np.zeros(len(angles), int)
        for i, ((start, _), along) in enumerate(zip(self.segments, self.along)):
            denominator = direction[:, 0] * along[1] - direction[:, 1] * along[0]
            offset = start - origin
            with np.errstate(divide="ignore", invalid="ignore"):
                t = (offset[0] * along[1] - offset[1] * along[0]) / denominator
                u = (offset[0] * direction[:, 1] - offset[1] * direction[:, 0]) / denominator
            hit = (denominator != 0.0) & (t >= 0.0) & (u >= 0.0) & (u <= 1.0) & (t < best)
            best[hit], index[hit] = t[hit], i
        return index, best

    def seen_from(self, poses, laser, beams=721):
        """Points (N x 2) along the parts of the segments that a laser sees from robot poses."""
        seen = [np.zeros(max(int(length / _SPACING), 1), bool) for length in self.lengths]
        angles = np.linspace(-laser.half_view, laser.half_view, beams)
        for x, y, heading in poses:
            c, s = np.cos(heading), np.sin(heading)
            origin = np.array([x + c * laser.pose[0] - s * laser.pose[1],
                               y + s * laser.pose[0] + c * laser.pose[1]])
            turned = angles + heading + laser.pose[2]
            index, distance = self.cast(origin, turned)
            self._mark(seen, origin, turned, index, np.where(distance <= laser.reach, distance,
                                                             np.inf))
        points = [self.segments[i, 0] + (np.flatnonzero(bins)[:, None] + 0.5) / len(bins)
                  * self.along[i] for i, bins in enumerate(seen)]
        return np.vstack(points)

    def _mark(self, seen, origin, angles, index, distance):
        """Marks what lies between neighbouring beams that hit the same segment."""
        both = np.flatnonzero(np.isfinite(distance[:-1]) & np.isfinite(distance[1:])
                              & (index[:-1] == index[1:]))
        hits = origin + np.where(np.isfinite(distance), distance, 0.0)[:, None] * np.column_stack(
            [np.cos(angles), np.sin(angles)])
        for k in both:
            i = index[k]
            ends = ((hits[[k, k + 1]] - self.segments[i, 0]) @ self.along[i]
                    / self.lengths[i] ** 2 * len(seen[i]))
            low, high = sorted(np.clip(ends, 0, len(seen[i])))
            seen[i][int(np.ceil(low - 0.5)):int(np.floor(high + 0.5))] = True
