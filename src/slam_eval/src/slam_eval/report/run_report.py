# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""report.html: one file that holds the figures, the pictures and the configuration of a run."""
import html

import numpy as np

from slam_eval.report.metric_table import GROUPS, KEYS, format_value, rows
from slam_eval.report.page import page, picture
from slam_eval.report.run_origin import DATE, origin_rows

MOST_EVENTS = 200  # of those that are listed
CAPTIONS = {
    "map.png": (
        "Path and map",
        "The estimated path and the landmarks with the 95 % ellipses the filter claims, in the map "
        "frame (the thesis's figure 6.2a), over the grid or the points of a laser, where the "
        "product makes such a map. Truth, where there is one, is moved onto the estimate "
        "by the rigid alignment of the trajectory error. Dotted: no pose was written for a while."),
    "trajectory.png": (
        "SLAM and dead reckoning",
        "The estimated path beside that of the odometry alone, which starts at the first pose of "
        "the estimate (the thesis's figure 6.2b)."),
    "odometry.png": (
        "Visual and wheel odometry",
        "The odometry that looks at the ceiling beside that of the wheels, which this run did not "
        "use: both begin at the first pose of the estimate and nothing corrects them (the "
        "thesis's figure 6.6b)."),
    "graph.png": (
        "Graph of poses",
        "The graph at the end of the run: each motion joins two nodes, each loop a node with the "
        "submap in which its scan was recognised. Green loops count in full, orange ones less, "
        "since the rest of the graph does not bear them out; red ones wait, which means that they "
        "are not believed (yet) and move nothing."),
    "landmark_errors.png": (
        "Landmark errors",
        "Red lines point from each landmark to the truth, moved onto the map by the alignment of "
        "the landmark error; 95 of 100 should end inside their ellipses."),
    "relations.png": (
        "Errors of the relations",
        "How far the estimated motion between two poses of the log is from the one that people "
        "read off the scans (Kuemmerle et al. 2009)."),
    "consistency.png": (
        "Consistency",
        "Errors in the map frame, truth moved there by its first pose and not fitted. A consistent "
        "filter keeps 95 of 100 steps inside its bounds; the bounds drawn are those of the most "
        "frequent degrees of freedom, dots are coloured by the bounds of their own."),
    "seen.png": (
        "What was seen",
        "How many features the back-end located in an image, how many features of its map it "
        "searched for there, and how many of these it found in agreement with the pose (matched) "
        "and in contradiction to the others (rejected). For products with landmarks it shows how "
        "many observations were made, used, gated (since they fitted their landmark too badly), "
        "and new to the map. In long runs each point is a mean."),
}


def _metric_rows(metrics, group):
    lines = []
    for key, value in rows(metrics, group):
        spec = KEYS[key]
        lines.append(f'<tr><td class="n">{html.escape(spec.label)}</td>'
                     f'<td class="v">{format_value(key, value)}</td><td class="u">{spec.unit}</td>'
                     f'<td class="m">{html.escape(spec.meaning)}</td></tr>')
    return "".join(lines)


def _metric_section(metrics, notes):
    text = "<section><h2>Figures</h2>"
    text += "".join(f'<p class="note">{html.escape(note)}</p>' for note in notes)
    for group in GROUPS:
        lines = _metric_rows(metrics, group)
        if lines:
            text += f'<h3>{group}</h3><table class="facts">{lines}</table>'
    return text + "</section>"


def _count_section(title, lines):
    """A table of counts: (name, value, meaning) in each line."""
    cells = "".join(f'<tr><td class="n">{name}</td><td class="v">{value}</td><td class="u"></td>'
                    f'<td class="m">{meaning}</td></tr>' for name, value, meaning in lines)
    return f'<section><h2>{title}</h2><table class="facts">{cells}</table></section>'


def _observation_section(updates):
    """What became of the observations, by updates.csv."""
    counts = updates.counts
    seen = sum(counts[name] for name in ("used", "gated", "added", "unknown"))
    steps = len(updates)
    lines = [
        ("Steps", steps, "Arrays of observations that the back-end took a step for."),
        ("Steps with landmarks", int(np.count_nonzero(seen)),
         f"{100.0 * np.count_nonzero(seen) / steps:.1f} % of the steps; the others saw nothing."),
        ("Used", int(np.sum(counts["used"])), "Observations of landmarks that the map held."),
        ("Gated", int(np.sum(counts["gated"])),
         "Observations that fitted their landmark too badly to be used."),
        ("Added", int(np.sum(counts["added"])), "First observations: each made a landmark."),
        ("Unknown", int(np.sum(counts["unknown"])),
         "Observations without an id, or of landmarks that a fixed map has not."),
    ]
    return _count_section("Observations", lines)


def _view_section(views):
    """What became of the features in the images, by views.csv."""
    totals = {name: int(np.sum(values)) for name, values in views.counts.items()}
    each = max(len(views), 1)
    lines = [("Images", len(views), "That the back-end could use.")]
    for name, label, meaning in (
            ("features", "Features", "Located in the images, whether the map had them or not."),
            ("expected", "Searched for", "Features of the map that were to be seen."),
            ("matched", "Matched", "Of these: found, and in agreement with the pose."),
            ("rejected", "Rejected", "Of these: found, but in contradiction to the others.")):
        lines.append((label, totals[name], f"{totals[name] / each:.1f} an image. {meaning}"))
    return _count_section("Features", lines)


def _event_section(run):
    """What happened, by events.csv."""
    start = run.trajectory.stamps[0]
    head = "".join(f'<td class="v">{name}</td>' for name in ("at [s]", "moved [m]", "turned [deg]"))
    lines = "".join(
        f'<tr><td class="n">{html.escape(event.kind.replace("_", " "))}</td>'
        f'<td class="v">{(event.stamp - start) * 1e-9:.1f}</td>'
        f'<td class="v">{event.distance:.3f}</td><td class="v">{np.degrees(event.turn):.2f}</td>'
        f'<td class="m">{html.escape(event.reason)}</td></tr>'
        for event in run.events[:MOST_EVENTS])
    more = len(run.events) - MOST_EVENTS
    rest = f"<p>{more} more are in events.csv.</p>" if more > 0 else ""
    return ('<section><h2>Events</h2><div class="scroll"><table><tr>'
            f'<td class="n">{len(run.events)} of them</td>{head}'
            f"<td></td></tr>{lines}</table></div>{rest}</section>")


def _relation_section(errors):
    """What the mean alone does not tell of the relations."""
    rotation = np.degrees(errors.rotation)
    head = "".join(f'<td class="v">{name}</td>'
                   for name in ("median", "mean", "spread", "mean square", "largest"))
    lines = ""
    for name, unit, values in (("Translation", "m", errors.translation),
                               ("Rotation", "deg", rotation)):
        figures = (np.median(values), np.mean(values), np.std(values), np.mean(values ** 2),
                   np.max(values))
        cells = "".join(f'<td class="v">{value:.4f}</td>' for value in figures)
        lines += f'<tr><td class="n">{name} [{unit}]</td>{cells}</tr>'
    count = f"{len(errors.translation)} used"
    if errors.missing:
        count += f", {errors.missing} left out for want of a pose"
    return ('<section><h2>Relations</h2><div class="scroll"><table><tr>'
            f'<td class="n">{count}</td>{head}</tr>{lines}'
            "</table></div></section>")


def _origin_section(rows):
    """Bag, date, version and command line of the run."""
    lines = "".join(f'<tr><td class="n">{name}</td><td class="t">{html.escape(text)}</td></tr>'
                    for name, text in rows)
    return f'<section><h2>Origin</h2><table class="facts">{lines}</table></section>'


def _picture_section(path):
    title, caption = CAPTIONS[path.name]
    return f"<section><h2>{title}</h2>{picture(path, title, caption)}</section>"


def render(run, metrics, pictures, notes, relations=None):
    """The report as HTML text. pictures: paths of the PNG files to embed; relations: their errors,
    where the run was held against some."""
    seed = run.config.get("seed")
    facts = [f"{len(run.trajectory)} poses", "%.1f s of data"
             % ((run.trajectory.stamps[-1] - run.trajectory.stamps[0]) * 1e-9)]
    if seed is not None:
        facts.append(f"seed {seed}")
    origin = origin_rows(metrics)
    facts += [text for name, text in origin if name == DATE]
    parts = [_metric_section(metrics, notes)]
    parts += [_picture_section(path) for path in pictures]
    if relations is not None:
        parts.append(_relation_section(relations))
    if run.events:
        parts.append(_event_section(run))
    if run.views is not None:
        parts.append(_view_section(run.views))
    elif run.updates is not None:
        parts.append(_observation_section(run.updates))
    if origin:
        parts.append(_origin_section(origin))
    if run.config_text:
        parts.append("<section><h2>Configuration in force</h2>"
                     f"<pre>{html.escape(run.config_text)}</pre></section>")
    return page(run.title, " · ".join(facts), parts)
