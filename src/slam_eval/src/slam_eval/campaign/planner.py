# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes a plan of a campaign: each drive and run is named by the hash of all that its result
depends on."""
import functools

from slam_eval.campaign import inputs
from slam_eval.campaign.plan import Drive, Plan, read_result, Row, Run
from slam_eval.foreign.bag_data import robot_of
from slam_eval.foreign.registry import find_system
from slam_eval.io.errors import InputError
from slam_eval.io.strict_yaml import is_path

NOT_SIMULATED = "its drive was not simulated; call the campaign again"


class Planner:
    """Finds all files that a campaign names, once. Raises UsageError where one is missing or a
    product is none."""

    def __init__(self, campaign, folder):
        self._campaign, self._folder = campaign, folder
        self._where = str(campaign.path)
        self._products = {row.name: self._read_product(row) for row in campaign.products}
        self._judges = inputs.modules(*inputs.JUDGES)
        self._worlds = {bag.name: str(inputs.world_file(bag.world, self._where))
                        for bag in campaign.bags if bag.world}
        self._robots = {bag.name: str(inputs.simulated_robot_file(bag.robot, self._where))
                        for bag in campaign.bags if bag.world}
        for bag in campaign.bags:
            if bag.path and bag.robot:
                inputs.robot_file(bag.robot, self._where)
            if bag.relations:
                inputs.hash_of_file(bag.relations)

    def _read_product(self, row):
        """(what to call, hash of all that it is made of) of a product or foreign system."""
        if row.is_foreign:
            system = find_system(row.product, self._where)
            system.require_settings(row.settings, self._where)
            return str(system.path), inputs.foreign(system.files(row.settings))
        path = inputs.product_file(row.product, self._where)
        inputs.require_product(row.product, row.settings, self._where)
        return row.product, inputs.hash_of(
            [inputs.hash_of_file(path), inputs.estimators(tuple(inputs.libraries_named_by(path)))])

    @functools.cached_property
    def drives(self):
        """The simulated drives by name, and the name of each by (bag, seed)."""
        drives, names = {}, {}
        for bag in self._campaign.bags:
            for seed in self._campaign.seeds if bag.world else ():
                drive = Drive(self._worlds[bag.name], self._robots[bag.name], bag.drive_seed(seed),
                              bag.duration, bag.only)
                name = inputs.hash_of([
                    inputs.simulators(), inputs.hash_of_file(drive.world),
                    inputs.hash_of_file(drive.robot), drive.seed, drive.duration, drive.only])
                drives[name] = drive
                names[bag.name, seed] = name
        return drives, names

    def _bag_of(self, bag, seed):
        """(path, SHA-256, failure) of the bag of a run."""
        if bag.path:
            return str(bag.path), inputs.hash_of_file(bag.path), None
        name = self.drives[1][bag.name, seed]
        if not self._folder.drive_result(name).exists():
            return None, None, NOT_SIMULATED
        result = read_result(self._folder.drive_result(name))
        path = self._folder.drive(name).relative_to(self._folder.path)
        return str(path), result.get("sha256"), result.get("failure")

    @functools.lru_cache(maxsize=None)
    def _robot_content(self, robot, bag_path, sha256):
        """The robot file that counts, by its name, where it has one, and what it holds. It depends
        on the bag's SHA-256 where the bag names it."""
        try:
            name = robot or robot_of(self._folder.path / bag_path)
            content = name and inputs.hash_of_file(inputs.robot_file(name, self._where))
            return ["" if name and is_path(name) else name, content]
        except InputError:
            return [sha256, "unknown"]  # the run says what is wrong

    def _run(self, bag, product, seed, path, sha256):
        system, _ = self._products[product.name]
        robot = bag.robot if bag.path else None
        return Run(system, product.is_foreign, product.settings, seed, path, sha256, robot,
                   bag.remap, self._worlds.get(bag.name),
                   str(bag.relations) if bag.relations else None, self._campaign.time_limit)

    def _name_of(self, run, content):
        """The hash of all that the result of a run depends on; the content of files, not where they
        are."""
        return inputs.hash_of({
            "product": content, "settings": run.settings, "seed": run.seed, "bag": run.bag_sha256,
            "robot": self._robot_content(run.robot, run.bag, run.bag_sha256), "remap": run.remap,
            "world": run.world and inputs.hash_of_file(run.world), "judges": self._judges,
            "relations": run.relations and inputs.hash_of_file(run.relations)})

    def drives_plan(self):
        """What has to be simulated."""
        return Plan(drives=self.drives[0])

    def runs_plan(self):
        """What has to be run, once all drives are there."""
        runs, rows = {}, []
        for bag in self._campaign.bags:
            for product in self._campaign.products:
                for seed in self._campaign.seeds:
                    path, sha256, failure = self._bag_of(bag, seed)
                    name = None
                    if not failure:
                        run = self._run(bag, product, seed, path, sha256)
                        name = self._name_of(run, self._products[product.name][1])
                        runs[name] = run
                    rows.append(Row(bag.name, product.name, seed, name, failure, sha256))
        return Plan(self.drives[0], runs, rows)
