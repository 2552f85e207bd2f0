# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of the benchmark adverse."""
import numpy as np

from slam_eval.plot import style as look


def _write(axes, place, cell):
    """The text of a cell: median and worst share in percent."""
    median, worst, has_failed = cell
    if median is None:
        text = "failed" if has_failed else ""
    elif f"{100 * median:.0f}" == f"{100 * worst:.0f}":
        text = f"{100 * median:.0f}"
    else:
        text = f"{100 * median:.0f}\n({100 * worst:.0f})"
    is_dark = median is not None and median > 0.55
    axes.text(*place, text + ("*" if has_failed and median is not None else ""), ha="center",
              va="center", fontsize=8.5, color="white" if is_dark else look.TRUTH)


def plot_shares(cells, products, faults, path):
    """A heat map: share of the time for which a product (a row) with a fault (a column) was
    confidently wrong. cells: {(product, fault): (median, worst, whether a run failed)}, shares None
    where there is none."""
    shares = np.full((len(products), len(faults)), np.nan)
    for (product, fault), (median, _, _) in cells.items():
        if median is not None:
            shares[products.index(product), faults.index(fault)] = median
    with look.style():
        figure, axes = look.plt.subplots(constrained_layout=True, figsize=(
            2.6 + 0.72 * len(faults), 2.2 + 0.5 * len(products)))
        axes.imshow(shares, cmap="OrRd", vmin=0.0, vmax=1.0, aspect="auto")
        for (product, fault), cell in cells.items():
            _write(axes, (faults.index(fault), products.index(product)), cell)
        axes.set_xticks(range(len(faults)), [f.replace("_", " ") for f in faults], rotation=40,
                        ha="right", rotation_mode="anchor")
        axes.set_yticks(range(len(products)), [p.rpartition("/")[2] for p in products])
        axes.grid(False)
        axes.set_title("Share of the time confidently wrong [%], median and (worst) of the seeds",
                       fontsize=10)
        look.save(figure, path)
