# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a campaign file says: bags or drives to simulate, products, seeds, metrics."""
import dataclasses
import itertools
import os
import pathlib
import re
from typing import Optional

from slam_eval.io.errors import did_you_mean, UsageError
from slam_eval.io.strict_yaml import is_path, load, Reader
from slam_eval.report.metric_table import KEYS

VERSION = 1
MOST_RUNS = 100_000
TIME_LIMIT = 3600  # [s] of a run
METRICS = ("ate_rmse_m", "landmark_rmse_m", "nees_mean")
# of a run's own time and memory, which differ from host to host
COSTS = tuple(key for key, spec in KEYS.items()
              if spec.group == "Cost" and key not in ("updates", "dropped_messages"))
VARIABLE = re.compile(r"\$(\w+)")
NAME = re.compile(r"[\w.+=,:@ -]+")
_CAMPAIGN_KEYS = ("version", "campaign", "bags", "products", "seeds", "metrics", "time_limit")
_DRIVE_KEYS = ("name", "world", "robot", "seed", "duration", "only")
_BAG_KEYS = ("name", "bag", "robot", "remap", "relations")
_PRODUCT_KEYS = ("name", "product", "foreign", "set", "vary")
SENSORS = ("odom", "scan", "rear_scan", "imu", "commands", "camera", "rear_camera",
           "ceiling_camera")  # of any simulated robot


@dataclasses.dataclass(frozen=True)
class Bag:
    """A bag of the campaign: recorded (path) or, for each seed, a simulated drive (world). robot:
    of a recorded bag a robot file instead of the one that it names, of a drive the simulated
    robot."""

    name: str
    path: Optional[pathlib.Path] = None
    world: Optional[str] = None
    robot: Optional[str] = None
    seed: Optional[int] = None  # of the drive, where it is not the run's
    duration: Optional[float] = None  # [s]
    only: tuple = ()
    remap: tuple = ()
    relations: Optional[pathlib.Path] = None

    def drive_seed(self, seed):
        """The seed that a drive is simulated with for a run of this seed."""
        return seed if self.seed is None else self.seed


@dataclasses.dataclass(frozen=True)
class Product:
    """A row of the table: a product, or a foreign system, with what is set (section.key=value)."""

    name: str
    product: str
    is_foreign: bool = False
    settings: tuple = ()


@dataclasses.dataclass(frozen=True)
class Campaign:
    """A campaign file, checked as far as it can be without the programs."""

    path: pathlib.Path
    name: str
    bags: list
    products: list
    seeds: list
    metrics: list
    time_limit: float  # [s]

    @property
    def size(self):
        return len(self.bags) * len(self.products) * len(self.seeds)


def _require_names(where, what, names):
    """Refuses a name that stands twice or could not be shown."""
    for name in names:
        if not NAME.fullmatch(name):
            raise UsageError(f"{where}: '{name}' is no name of a {what}: letters, digits, spaces "
                                "and _.+=,:@- only")
        if names.count(name) > 1:
            raise UsageError(f"{where}: two {what}s are called '{name}'; give one of them another "
                                "name")


def _path(folder, text):
    """A file's path; a relative one is relative to the campaign's file."""
    return folder / pathlib.Path(text).expanduser()


def _file_or_name(folder, text):
    return str(_path(folder, text)) if text and is_path(text) else text


def _scalar(value):
    """A value as ./slam run --set takes it."""
    if isinstance(value, bool):
        return str(value).lower()
    return str(value)


def _settings(reader, key):
    values = reader.map(key)
    for name, value in values.items():
        if isinstance(value, dict) or key == "set" and isinstance(value, list):
            raise reader.error(f"{key}: {name} is a {type(value).__name__}, where one value "
                               "belongs; write SECTION.KEY: VALUE")
        if value == []:
            raise reader.error(f"{key}: {name} is an empty list; give one value at least")
    return values


def _combinations(choices):
    """All maps that take one value of each list."""
    return [dict(zip(choices, values)) for values in itertools.product(*choices.values())]


def _bag_path(folder, reader):
    """A bag's path. $NAME stands for the value of an environment variable, the folder of data that a
    file cannot bring; such a path is relative to where the command is called."""
    text = reader.text("bag")
    for name in VARIABLE.findall(text):
        if not os.environ.get(name):
            raise reader.error(f"the bag {text} is in a folder that the environment variable {name} "
                               f"names, which is not set; call the command with {name}=FOLDER in "
                               "front")
    found = VARIABLE.sub(lambda match: os.environ[match.group(1)], text)
    return _path(folder, found) if found == text else pathlib.Path(found).expanduser().absolute()


def _recorded(folder, reader):
    path = _bag_path(folder, reader)
    if not path.is_file():
        raise reader.error(f"there is no bag {path}; check the path, which is relative to the "
                           "campaign's file")
    relations = reader.text("relations")
    return [Bag(reader.text("name", path.stem), path,
                robot=_file_or_name(folder, reader.text("robot")),
                remap=tuple(map(str, reader.many("remap"))),
                relations=_path(folder, relations) if relations else None)]


def _whole_number(reader, key, value):
    if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value < 2 ** 63:
        raise reader.error(f"{key} is '{value}', which is no whole number from 0 on")
    return value


def _drives(folder, reader):
    """The drives of an entry: one for each combination of worlds, robots, seeds and durations."""
    only = tuple(map(str, reader.many("only")))
    for sensor in only:
        if sensor not in SENSORS:
            raise reader.error(f"there is no sensor '{sensor}'{did_you_mean(sensor, SENSORS)}; "
                               f"there are: {', '.join(SENSORS)}")
    choices = {key: reader.many(key, [default]) for key, default in (
        ("world", None), ("robot", "segway"), ("seed", None), ("duration", None))}
    varied = [key for key, values in choices.items() if len(values) > 1]
    name = reader.text("name", "" if "world" in varied else pathlib.Path(
        str(choices["world"][0])).stem)
    drives = []
    for chosen in _combinations(choices):
        duration = Reader(reader.where, chosen, chosen).number("duration")
        seed = chosen["seed"]
        drives.append(Bag(
            " ".join(filter(None, [name, *(pathlib.Path(str(chosen[key])).stem if key != "duration"
                                           else f"{duration:g}" for key in varied)])),
            world=_file_or_name(folder, str(chosen["world"])),
            robot=_file_or_name(folder, str(chosen["robot"])),
            seed=None if seed is None else _whole_number(reader, "seed", seed),
            duration=duration, only=only))
    return drives


def _bags(path, entry):
    where = f"{path}: bags"
    if isinstance(entry, str):
        entry = {"bag": entry}
    is_drive = isinstance(entry, dict) and entry.get("world") is not None
    reader = Reader(where, entry, _DRIVE_KEYS if is_drive else _BAG_KEYS + ("world",))
    if is_drive:
        return _drives(path.parent, reader)
    if "bag" not in reader:
        raise reader.error("an entry has neither 'bag', a recorded file, nor 'world', a drive to "
                           "simulate")
    return _recorded(path.parent, reader)


def _products(path, entry):
    """The rows of an entry: one for each combination of the values that vary."""
    if isinstance(entry, str):
        entry = {"product": entry}
    reader = Reader(f"{path}: products", entry, _PRODUCT_KEYS)
    kinds = [key for key in ("product", "foreign") if key in reader]
    if len(kinds) != 1:
        raise reader.error("an entry needs 'product' or 'foreign', one of the two")
    is_foreign = kinds == ["foreign"]
    system = _file_or_name(path.parent, reader.text(kinds[0]))
    name = reader.text("name", pathlib.Path(system).stem)
    fixed, varied = _settings(reader, "set"), _settings(reader, "vary")
    twice = [key for key in varied if key in fixed]
    if twice:
        raise reader.error(f"{twice[0]} stands in 'set' and in 'vary' of {name}; leave one out")
    choices = {key: values if isinstance(values, list) else [values]
               for key, values in varied.items()}
    return [Product(" ".join([name, *(f"{key}={_scalar(value)}" for key, value in chosen.items())]),
                    system, is_foreign,
                    tuple(f"{key}={_scalar(value)}" for key, value in {**fixed, **chosen}.items()))
            for chosen in _combinations(choices)]


def _seeds(reader):
    """Seeds as a list; one number N means 1 to N."""
    given = reader.raw("seeds", 1)
    if isinstance(given, list):
        seeds = [_whole_number(reader, "a seed", value) for value in reader.many("seeds")]
    else:
        if _whole_number(reader, "seeds", given) == 0:
            raise reader.error("seeds is 0; a campaign needs one at least")
        if given > MOST_RUNS:
            raise reader.error(f"seeds is {given}, more than the {MOST_RUNS} runs of a campaign")
        seeds = list(range(1, given + 1))
    if len(set(seeds)) < len(seeds):
        twice = next(seed for seed in seeds if seeds.count(seed) > 1)
        raise reader.error(f"the seed {twice} stands there twice; leave one out")
    return seeds


def _metrics(reader):
    metrics = [str(name) for name in reader.many("metrics", METRICS)]
    known = [key for key in KEYS if key not in COSTS]
    for name in metrics:
        if name in COSTS:
            raise reader.error(f"the metric {name} is a cost, which differs from host to host; "
                               "costs.csv holds it")
        if name not in known:
            raise reader.error(f"there is no metric '{name}'{did_you_mean(name, known)}; "
                               f"src/slam_eval/README.md lists them")
    return list(dict.fromkeys(metrics))


def _require_topics(reader, bags, products):
    """Refuses topics of other names where a foreign system is to read them."""
    bag = next((bag for bag in bags if bag.remap), None)
    row = next((row for row in products if row.is_foreign), None)
    if bag and row:
        raise reader.error(f"the bag {bag.name} has 'remap', which the foreign system {row.name} "
                           "does not take; give it a bag whose topics have the usual names, or "
                           "make two campaigns of it")


def read_campaign(path):
    """The campaign of a file. Raises UsageError."""
    path = pathlib.Path(path).absolute()
    reader = Reader(path, load(path), _CAMPAIGN_KEYS)
    if reader.raw("version") != VERSION:
        raise reader.error(f"the version is {reader.raw('version', 'not given')}, this program "
                           f"reads 'version: {VERSION}'")
    for key in ("campaign", "bags", "products"):
        if key not in reader:
            raise reader.error(f"the key '{key}' is missing")
    bags = [bag for entry in reader.many("bags") for bag in _bags(path, entry)]
    products = [row for entry in reader.many("products") for row in _products(path, entry)]
    name = reader.text("campaign")
    _require_names(path, "campaign", [name])
    _require_names(path, "bag", [bag.name for bag in bags])
    _require_names(path, "product", [row.name for row in products])
    _require_topics(reader, bags, products)
    campaign = Campaign(path, name, bags, products, _seeds(reader), _metrics(reader),
                        reader.number("time_limit", TIME_LIMIT))
    if campaign.size > MOST_RUNS:
        raise reader.error(f"it has {campaign.size} runs, which is more than {MOST_RUNS}; make "
                           "several campaigns of it")
    return campaign
