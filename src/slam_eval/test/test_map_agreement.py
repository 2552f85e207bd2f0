# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Grids and point maps: their files, and how they agree with a world."""
import contextlib
import io
import json
import pathlib
import sys
import tempfile
import types
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))  # nosetests -P does not

import run_maker  # noqa: E402
from slam_eval.geometry import se2  # noqa: E402
from slam_eval.geometry.surfaces import Surfaces  # noqa: E402
from slam_eval.io.errors import InputError  # noqa: E402
from slam_eval.io.grid_map import FREE, GridMap, OCCUPIED, read_grid, UNKNOWN  # noqa: E402
from slam_eval.io.point_cloud import read_points  # noqa: E402
from slam_eval.io.simulated_laser import Laser, read_simulated_laser  # noqa: E402
from slam_eval.io.trajectory import Trajectory  # noqa: E402
from slam_eval.io.world_plan import read_world  # noqa: E402
from slam_eval.metrics import map_agreement as agreement  # noqa: E402
from slam_eval.report.cli import main  # noqa: E402

ROOM = [[0, 0], [4, 0], [4, 3], [0, 3], [0, 0]]
WORLD = ("ceiling: {height: 2.5}\n"
         "walls:\n  - {points: [[0, 0], [4, 0], [4, 3], [0, 3]], closed: true}\n"
         "furniture:\n  - {centre: [1, 1], size: [0.5, 0.4, 0.2]}\n")
SIMULATED = ("robot: ring\nlaser:\n  frame: laser\n  position: [0.1, 0.0, 0.3]\n"
             "  field_of_view: 6.2\n  max_range: 10.0\n")
NO_TURN = np.zeros(3)


def room():
    return Surfaces([[a, b] for a, b in zip(ROOM[:-1], ROOM[1:])])


def raster(points, resolution=0.05):
    """A grid in which the cells of these points are occupied and all others free."""
    origin = np.floor(np.min(points, axis=0) / resolution - 2.0) * resolution
    index = np.floor((points - origin) / resolution).astype(int)
    cells = np.full(tuple(np.max(index, axis=0)[::-1] + 3), FREE, np.int8)
    cells[index[:, 1], index[:, 0]] = OCCUPIED
    return GridMap(cells, resolution, origin)


def around(spacing=0.01, offset=0.0):
    """Points along the room's walls, moved outwards by an offset [m]."""
    x, y = np.arange(0, 4, spacing), np.arange(0, 3, spacing)
    return np.vstack([np.column_stack([x, np.full_like(x, -offset)]),
                      np.column_stack([x, np.full_like(x, 3 + offset)]),
                      np.column_stack([np.full_like(y, -offset), y]),
                      np.column_stack([np.full_like(y, 4 + offset), y])])


def write_grid(folder, grid):
    """map.pgm and map.yaml as a run writes them."""
    grey = np.full(grid.cells.shape, 205, np.uint8)
    grey[grid.cells == FREE], grey[grid.cells == OCCUPIED] = 254, 0
    height, width = grey.shape
    (folder / "map.pgm").write_bytes(b"P5\n# made by a test\n%d %d\n255\n" % (width, height)
                                     + grey[::-1].tobytes())
    (folder / "map.yaml").write_text(
        f"image: map.pgm\nresolution: {grid.resolution}\norigin: [{grid.origin[0]}, "
        f"{grid.origin[1]}, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n")


def pcd(points):
    """Text of a point cloud."""
    return (f"# .PCD v0.7\nVERSION 0.7\nFIELDS x y z intensity\nSIZE 4 4 4 4\nTYPE F F F F\n"
            f"COUNT 1 1 1 1\nWIDTH {len(points)}\nHEIGHT 1\nPOINTS {len(points)}\nDATA ascii\n"
            + "".join("%.6f %.6f 0 1\n" % (x, y) for x, y in points))


class Files(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def refuses(self, reader, path, part):
        """The reader refuses the file with one sentence that holds the part."""
        with self.assertRaises(InputError) as caught:
            reader(path)
        self.assertIn(part, str(caught.exception))
        self.assertNotIn("\n", str(caught.exception))

    def test_reads_a_grid_with_its_place(self):
        cells = np.array([[FREE, OCCUPIED, UNKNOWN], [FREE, FREE, OCCUPIED]], np.int8)
        write_grid(self.folder, GridMap(cells, 0.5, np.array([-1.0, 2.0])))
        grid = read_grid(self.folder / "map.yaml")
        np.testing.assert_array_equal(grid.cells, cells)
        np.testing.assert_allclose(grid.centres(OCCUPIED), [[-0.25, 2.25], [0.25, 2.75]])
        self.assertAlmostEqual(grid.known_area, 5 * 0.25)

    def test_refuses_broken_maps(self):
        write_grid(self.folder, raster(around()))
        path, text = self.folder / "map.yaml", (self.folder / "map.yaml").read_text()
        image = (self.folder / "map.pgm").read_bytes()
        for broken in (text.replace("resolution: 0.05", "resolution: 0"), "image: map.pgm\n",
                       text.replace("negate: 0", "negate: maybe"), "just words\n", "[\n"):
            path.write_text(broken)
            self.refuses(read_grid, path, "map.yaml: no map")
        path.write_text(text)
        for broken in (image[:-1], b"P2" + image[2:], b"P5\n3 x\n255\n", b""):
            (self.folder / "map.pgm").write_bytes(broken)
            self.refuses(read_grid, path, "map.pgm")
        (self.folder / "map.pgm").unlink()
        self.refuses(read_grid, path, "map.pgm: the image of the map cannot be read")

    def test_reads_points_and_refuses_a_file_cut_off(self):
        path = self.folder / "points.pcd"
        path.write_text(pcd([[1.0, 2.0], [-3.0, 0.5]]))
        np.testing.assert_allclose(read_points(path), [[1.0, 2.0], [-3.0, 0.5]])
        path.write_text(pcd([]))
        self.assertEqual(len(read_points(path)), 0)
        text = pcd([[1.0, 2.0], [-3.0, 0.5]])
        for broken in (text[:-10], text.replace("0.500000", "x"), text.replace("ascii", "binary"),
                       text.replace("FIELDS x", "FIELDS q"), "words\n"):
            path.write_text(broken)
            self.refuses(read_points, path, "points.pcd")

    def test_knows_the_simulated_robots_laser(self):
        (self.folder / "worlds").mkdir()
        (self.folder / "robots").mkdir()
        (self.folder / "robots" / "a.yaml").write_text(SIMULATED)
        laser = read_simulated_laser(self.folder / "worlds" / "w.yaml", "ring")
        self.assertEqual((laser.height, laser.reach, laser.half_view), (0.3, 10.0, 3.1))
        self.assertIsNone(read_simulated_laser(self.folder / "worlds" / "w.yaml", "other"))
        (self.folder / "robots" / "a.yaml").write_text("robot: ring\n")
        self.refuses(lambda path: read_simulated_laser(path, "ring"),
                     self.folder / "worlds" / "w.yaml", "a.yaml")

    def test_only_what_is_as_high_as_the_laser_is_a_surface(self):
        (self.folder / "w.yaml").write_text(WORLD)
        world = read_world(self.folder / "w.yaml")
        self.assertEqual(len(world.surfaces(0.1).segments), 8)
        self.assertEqual(len(world.surfaces(0.3).segments), 4)


class Grids(unittest.TestCase):

    def test_coarser_keeps_thin_walls(self):
        grid = raster(around())
        coarse = grid.coarser(20)
        self.assertLessEqual(max(coarse.cells.shape), 20)
        found = agreement.walls_found(coarse, around(), NO_TURN)
        self.assertEqual(found, 1.0)
        self.assertIs(grid.coarser(1000), grid)

    def test_known_part_leaves_out_the_margin(self):
        cells = np.full((50, 40), UNKNOWN, np.int8)
        self.assertIsNone(GridMap(cells, 0.1, np.zeros(2)).known_part())
        cells[20, 30], cells[25, 10] = FREE, OCCUPIED
        part = GridMap(cells, 0.1, np.array([1.0, 2.0])).known_part()
        self.assertEqual(part.cells.shape, (6, 21))
        np.testing.assert_allclose(part.origin, [2.0, 4.0])


class Agreement(unittest.TestCase):

    def test_is_full_for_the_true_map_wherever_it_lies(self):
        for T_truth_map in (NO_TURN, np.array([2.0, -1.0, 0.6])):
            points = se2.transform_points(se2.inverse(T_truth_map), around())
            grid = raster(points)
            self.assertEqual(agreement.cells_on_walls(grid, room(), T_truth_map), 1.0)
            self.assertEqual(agreement.walls_found(grid, around(), T_truth_map), 1.0)

    def test_sees_walls_that_are_two_cells_off(self):
        grid = raster(around(offset=0.13))
        self.assertLess(agreement.cells_on_walls(grid, room(), NO_TURN), 0.05)
        self.assertLess(agreement.walls_found(grid, around(), NO_TURN), 0.05)

    def test_counts_what_is_missing_and_what_is_invented(self):
        points = around()
        half = raster(points[points[:, 0] < 2.0])
        self.assertAlmostEqual(agreement.walls_found(half, points, NO_TURN), 0.5, delta=0.02)
        self.assertEqual(agreement.cells_on_walls(half, room(), NO_TURN), 1.0)
        invented = np.column_stack([np.full(300, 2.0), np.arange(0.0, 3.0, 0.01)])
        both = raster(np.vstack([points, invented]))
        share = agreement.cells_on_walls(both, room(), NO_TURN)
        self.assertAlmostEqual(share, 280.0 / 340.0, delta=0.02)
        self.assertEqual(agreement.walls_found(both, points, NO_TURN), 1.0)

    def test_without_occupied_cells_tells_nothing(self):
        empty = GridMap(np.full((3, 3), FREE, np.int8), 0.1, np.zeros(2))
        self.assertIsNone(agreement.cells_on_walls(empty, room(), NO_TURN))
        self.assertEqual(agreement.walls_found(empty, around(), NO_TURN), 0.0)

    def test_measures_the_thickness_of_walls_and_not_their_offset(self):
        random = np.random.default_rng(1)
        points = around()
        spread = random.uniform(-0.05, 0.05, points.shape)
        thickness, error = agreement.wall_thickness(points + spread, room(), NO_TURN)
        self.assertAlmostEqual(thickness, 0.09, delta=0.01)
        self.assertAlmostEqual(error, 0.05 / np.sqrt(3.0), delta=0.005)
        thickness, error = agreement.wall_thickness(around(offset=0.1), room(), NO_TURN)
        self.assertLess(thickness, 0.02)
        self.assertAlmostEqual(error, 0.1, delta=0.01)
        self.assertEqual(agreement.wall_thickness(points + 50.0, room(), NO_TURN), (None, None))


class Alignment(unittest.TestCase):

    def test_is_that_of_the_path_on_which_the_map_was_made(self):
        poses = run_maker.ring(60)
        stamps = np.arange(60, dtype=np.int64) * 100_000_000
        truth = Trajectory(stamps, se2.transform_poses(run_maker.T_WORLD_MAP, poses))
        wrong = Trajectory(stamps, poses + [1.0, 0.0, 0.0])
        run = types.SimpleNamespace(trajectory=wrong, final=Trajectory(stamps, poses), truth=truth)
        np.testing.assert_allclose(agreement.path_alignment(run), run_maker.T_WORLD_MAP, atol=1e-9)
        run.final.poses[0, 2] += 0.5  # one heading that is off turns no wall
        np.testing.assert_allclose(agreement.path_alignment(run), run_maker.T_WORLD_MAP, atol=1e-9)
        run.truth = Trajectory(stamps + 10 ** 12, poses)
        self.assertIsNone(agreement.path_alignment(run))


class Sight(unittest.TestCase):

    def share_of_sides(self, points):
        """How much of each wall [m] was seen: south, east, north, west."""
        x, y = points.T
        sides = (np.abs(y) < 1e-6, np.abs(x - 4) < 1e-6, np.abs(y - 3) < 1e-6, np.abs(x) < 1e-6)
        return [0.01 * np.count_nonzero(side) for side in sides]

    def test_all_around_sees_every_wall(self):
        laser = Laser(NO_TURN, 0.3, np.pi, 10.0)
        seen = room().seen_from([[2.0, 1.5, 0.3]], laser)
        np.testing.assert_allclose(self.share_of_sides(seen), [4.0, 3.0, 4.0, 3.0], atol=0.06)

    def test_ahead_only_sees_what_is_ahead(self):
        laser = Laser(NO_TURN, 0.3, np.pi / 4.0, 10.0)
        seen = room().seen_from([[3.0, 1.5, 0.0]], laser)
        np.testing.assert_allclose(self.share_of_sides(seen), [0.0, 2.0, 0.0, 0.0], atol=0.06)

    def test_sees_no_further_than_its_reach_and_not_through_things(self):
        near = room().seen_from([[2.0, 0.5, 0.0]], Laser(NO_TURN, 0.3, np.pi, 1.0))
        np.testing.assert_allclose(self.share_of_sides(near), [np.sqrt(3.0), 0, 0, 0], atol=0.06)
        screened = Surfaces(list(room().segments) + [[[2.5, 0.0], [2.5, 3.0]]])
        seen = screened.seen_from([[2.0, 1.5, 0.0]], Laser(NO_TURN, 0.3, np.pi, 10.0))
        np.testing.assert_allclose(self.share_of_sides(seen), [2.5, 0.0, 2.5, 3.0], atol=0.06)

    def test_looks_from_where_the_laser_sits(self):
        laser = Laser(np.array([1.0, 0.0, np.pi]), 0.3, np.pi / 4.0, 10.0)
        seen = room().seen_from([[1.0, 1.5, 0.0]], laser)
        np.testing.assert_allclose(self.share_of_sides(seen), [0.5, 0.0, 0.5, 3.0], atol=0.06)


class SlamEval(unittest.TestCase):

    def test_reports_the_map_of_a_simulated_world(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            run, worlds = folder / "run", folder / "worlds"
            run_maker.make_run(run, count=200, landmarks=3, gap=False)
            (run / "landmarks.yaml").unlink()
            start = se2.compose(run_maker.T_WORLD_MAP, run_maker.ring(200)[0])
            walls = around() + start[:2] - [2.0, 1.5]
            points = se2.transform_points(se2.inverse(run_maker.T_WORLD_MAP), walls)
            write_grid(run, raster(points))
            (run / "points.pcd").write_text(pcd(points))
            worlds.mkdir()
            (folder / "robots").mkdir()
            (folder / "robots" / "a.yaml").write_text(SIMULATED)
            corners = (np.array(ROOM) + start[:2] - [2.0, 1.5]).tolist()
            (worlds / "w.yaml").write_text(f"walls:\n  - {{points: {corners}}}\n")
            err = io.StringIO()
            with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(err):
                self.assertEqual(main([str(run), "--world", str(worlds / "w.yaml")]), 0,
                                 err.getvalue())
            metrics = json.loads((run / "metrics.json").read_text())
            self.assertGreater(metrics["map_cells_on_walls_percent"], 95.0)
            self.assertGreater(metrics["map_walls_found_percent"], 95.0)
            self.assertLess(metrics["points_wall_thickness_m"], 0.05)
            self.assertEqual(metrics["points"], len(points))
            self.assertGreater(metrics["map_area_m2"], 12.0)
            report = (run / "report.html").read_text()
            self.assertIn("Occupied cells on walls", report)
            self.assertTrue((run / "map.png").exists())


if __name__ == "__main__":
    unittest.main()
