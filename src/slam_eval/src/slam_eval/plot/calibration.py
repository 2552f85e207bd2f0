# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of the benchmark calibration."""
import numpy as np

from slam_eval.plot import style as look

SIGMAS, WIDEST = 3.0, 6.0  # the shaded band; errors beyond the axis are drawn at its end


def _rows(keys):
    """{(case, parameter): row}, with a gap between the cases."""
    rows, at, last = {}, 0.0, None
    for key in keys:
        at += 1.0 if last in (None, key[0]) else 1.6
        rows[key], last = at, key[0]
    return rows


def _page(rows):
    """Figure and axes for so many rows, with room for names on both sides."""
    width, left, right, below, above = 7.6, 1.15, 1.15, 0.55, 0.35  # [inch]
    height = below + above + 0.26 * rows
    figure = look.plt.figure(figsize=(width, height))
    axes = figure.add_axes([left / width, below / height, 1.0 - (left + right) / width,
                            1.0 - (below + above) / height])
    return figure, axes


def _draw(axes, row, errors):
    values = np.array([error for error, _ in errors])
    rows = row + np.linspace(-0.25, 0.25, len(values)) if len(values) > 1 else np.array([row])
    shown, inside = np.clip(values, -WIDEST, WIDEST), np.abs(values) <= SIGMAS
    axes.plot(shown[inside], rows[inside], "o", markersize=3.6, color=look.ESTIMATE, alpha=0.75,
              markeredgewidth=0.0)
    for side, marker in ((-1.0, "<"), (1.0, ">")):
        beyond = side * values > WIDEST
        near = ~inside & ~beyond & (side * values > 0.0)
        axes.plot(shown[near], rows[near], "o", markersize=4.2, color=look.ERROR,
                  markeredgewidth=0.0)
        axes.plot(shown[beyond], rows[beyond], marker, markersize=5.0, color=look.ERROR,
                  markeredgewidth=0.0, clip_on=False)


def plot_errors(errors, path):
    """Dots of the error of each parameter in reported standard deviations, a row for each parameter
    of each case, from the first seed above to the last one below. errors: {(case, parameter):
    [(error, seed)]}."""
    rows = _rows(errors)
    cases = list(dict.fromkeys(case for case, _ in errors))
    with look.style():
        figure, axes = _page(1.0 + max(rows.values()))
        axes.axvspan(-SIGMAS, SIGMAS, color=look.BAND, alpha=0.10, linewidth=0.0)
        axes.axvline(0.0, color=look.MUTED, linewidth=0.8)
        for key, row in rows.items():
            _draw(axes, row, errors[key])
        axes.set_xlim(-WIDEST - 0.2, WIDEST + 0.2)
        axes.set_ylim(max(rows.values()) + 0.8, 0.2)
        axes.set_yticks(list(rows.values()), [parameter for _, parameter in rows])
        for case in cases:
            mine = [row for (name, _), row in rows.items() if name == case]
            axes.annotate(case, (1.0, np.mean(mine)), xycoords=("axes fraction", "data"),
                          xytext=(8, 0), textcoords="offset points", va="center", fontsize=9,
                          color=look.TRUTH)
        axes.set_xlabel(
            "error of the parameter [reported standard deviations], a dot for each seed")
        axes.set_title("What a calibration found against what was wrong")
        look.plain(axes)
        look.save(figure, path)
