# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""graph.png: the graph of poses at the end of a run, by what its edges mean."""
from slam_eval.plot import plan
from slam_eval.plot import style as look

DOUBTED = 0.9  # a loop that counts less is drawn as one that the rest does not bear out
SIGHTINGS = {"color": "#5b8def", "linewidth": 0.3, "alpha": 0.5, "zorder": 2}
MOTION = {"color": "#8a8f97", "linewidth": 1.4, "zorder": 4}
LOOPS = {"color": "#1f9d4d", "linewidth": 0.7, "zorder": 3}
MANY = 300  # loops: more of them are drawn the paler, so that what they lie on can be seen
FEW = 50  # loops that are drawn above all else, with their ends: short ones lie on motions
ENDS = {"color": LOOPS["color"], "markersize": 6, "markerfacecolor": "none", "zorder": 9}
DOUBTED_LOOPS = {"color": "#f08c00", "linewidth": 1.1, "alpha": 0.9, "zorder": 5}
WAITING = {"color": look.ERROR, "linewidth": 1.1, "alpha": 0.9, "zorder": 6}


def _draw_edges(axes, edges, label, options):
    if len(edges):
        look.draw_segments(axes, edges[:, 0], edges[:, 1], label=f"{len(edges)} {label}",
                           **options)


def _draw_loops(axes, loops):
    if len(loops) > FEW:
        pale = max(0.12, min(0.8, MANY / len(loops)))
        _draw_edges(axes, loops, "loops", {**LOOPS, "alpha": pale})
    else:
        _draw_edges(axes, loops, "loops", {**LOOPS, "linewidth": 1.4, "zorder": 9})
        axes.plot(*loops.reshape(-1, 2).T, "o", **ENDS)


def _draw_graph(axes, graph):
    nodes, submaps = graph.places["node"], graph.places["submap"]
    loops, is_doubted = graph.edges["loop"], graph.weights["loop"] < DOUBTED
    _draw_edges(axes, graph.edges["sighting"], "sightings of landmarks", SIGHTINGS)
    _draw_edges(axes, graph.edges["motion"], "motions", MOTION)
    _draw_loops(axes, loops[~is_doubted])
    _draw_edges(axes, loops[is_doubted], f"loops that count less than {DOUBTED:g}", DOUBTED_LOOPS)
    _draw_edges(axes, graph.edges["waiting_loop"], "loops that wait (not believed)", WAITING)
    axes.plot(*nodes.T, ".", color=look.TRUTH, markersize=2.2, markeredgewidth=0, zorder=7,
              label=f"{len(nodes)} nodes")
    if len(submaps):
        axes.plot(*submaps.T, "o", color="#7b3fa0", markersize=4.5, markeredgecolor="white",
                  markeredgewidth=0.6, zorder=8, label=f"{len(submaps)} submaps begin here")


def plot_graph(run, _result, path):
    """The nodes, and the edges by kind, over the grid. Returns False where there is no graph."""
    if run.graph is None or not len(run.graph.places["node"]):
        return False
    grid = run.grid and run.grid.known_part()
    ends = [edges.reshape(-1, 2) for edges in run.graph.edges.values() if len(edges)]
    with look.style():
        figure, axes = look.plan_axes(plan.bounds(run.graph.places["node"], *ends))
        plan.draw_grid(axes, grid)
        _draw_graph(axes, run.graph)
        axes.set_title(f"Graph · {run.title}")
        for line in look.legend_below(figure, axes, columns=3).get_lines():
            line.set_alpha(1.0)
        look.save(figure, path)
    return True
