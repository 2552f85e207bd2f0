# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part forest: parks drawn at random, whose trees a laser sees."""
import numpy as np

from slam_eval.bench.association.parks import park
from slam_eval.bench.association.policies import PRODUCTS
from slam_eval.bench.harness.runs import run_ours, simulate
from slam_eval.bench.harness.table import lines_of, Section, table
from slam_eval.geometry import se2
from slam_eval.io.run_folder import read_run
from slam_eval.io.world_plan import read_world
from slam_eval.metrics.evaluation import evaluate
from slam_eval.plot.map import plot_map

POLICIES = ("jcbb", "descriptor")
DENSITIES = (10, 20, 40)  # trees per hectare
REACH = 0.5               # of a landmark from the tree that it is [m]
HEADER = ["trees per ha, seed", "product", "association", "ATE [m]", "largest error [m]",
          "dead reckoning [m]", "NEES", "landmarks", "ghosts", "doubles", "CPU [s]"]
FORMS = ["s", "s", ".3f", ".3f", ".1f", ".2f", "d", "d", "d", ".1f"]


def places_of(run, result):
    """The landmarks of a run in the frame of the truth."""
    return se2.transform_points(result.ate.T_truth_map, run.landmarks.positions)


def strays(places, trees):
    """How many landmarks are no tree, and how many are one that another landmark is."""
    distances = np.linalg.norm(places[:, None, :] - trees[None, :, :2], axis=2)
    nearest, is_tree = distances.argmin(axis=1), distances.min(axis=1) < REACH
    return int(np.sum(~is_tree)), int(np.sum(is_tree) - len(set(nearest[is_tree])))


def run_park(context, name, bag, trees, product, policy):
    """Run a product in a park; its line of the table, its run and its evaluation."""
    folder, usage = run_ours(context, f"{name}_{product}_{policy}", bag, "sim_car", product,
                             ["detector=laser_trunks", f"association={policy}"], label=name)
    run = read_run(folder)
    result = evaluate(run)
    m = result.metrics
    ghosts, doubles = strays(places_of(run, result), trees)
    return [name, product, policy, m.get("ate_rmse_m"), m.get("ate_max_m"),
            m.get("odometry_ate_rmse_m"), m.get("nees_mean"), len(run.landmarks), ghosts, doubles,
            usage.cpu_s], run, result


def measure(context):
    """The section of this part."""
    section = Section("Random parks, trees seen by a laser")
    lines = []
    for density in DENSITIES:
        for seed in range(1, context.options.parks + 1):
            name = f"{density}, {seed}"
            world = context.work / f"park_{density}_{seed}.yaml"
            drawn = park(seed, density)
            drawn.write(world)
            bag = simulate(context, world.stem, world, seed, "odom,scan", name, robot="car")
            for product in context.options.products or PRODUCTS:
                for policy in POLICIES:
                    line, run, result = run_park(context, name, bag, np.array(drawn.trees),
                                                 product, policy)
                    lines.append(line)
                    if seed == 1 and policy == POLICIES[0]:
                        path = context.out / f"association_{world.stem}_{product}.png"
                        plot_map(run, result, path, world=read_world(world))
                        section.pictures[f"{name}: {product}"] = path
            bag.unlink()
    section.paragraphs += [
        table(HEADER, lines_of(lines, FORMS)),
        "Parks of 240 m x 170 m, two rounds of about 480 m. Errors after a rigid alignment; NEES 3 "
        f"is expected. Ghosts: landmarks of which no tree is within {REACH} m. Doubles: landmarks "
        "of a tree that another landmark is."]
    return section
