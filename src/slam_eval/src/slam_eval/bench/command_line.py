# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""What `slam_bench` takes from its command line."""
import argparse
import pathlib


def _positive(text):
    value = int(text)
    if value < 1:
        raise ValueError(text)
    return value


def number_list(text):
    """Whole numbers above 0, separated by commas, rising; each once."""
    try:
        return tuple(sorted({_positive(part) for part in text.split(",")}))
    except ValueError:
        raise argparse.ArgumentTypeError(
            f'"{text}" is no list of whole numbers above 0, like 100,300') from None


def count(text):
    """A whole number above 0."""
    try:
        return _positive(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f'"{text}" is no whole number above 0') from None


def part_list(text, known):
    """Names of parts, separated by commas, in the order in which they run."""
    names = text.split(",")
    for name in names:
        if name not in known:
            raise argparse.ArgumentTypeError(
                f'there is no part "{name}"; the parts are {", ".join(known)}')
    return [name for name in known if name in names]


def _folder(text):
    path = pathlib.Path(text)
    if not path.is_dir():
        raise argparse.ArgumentTypeError(f"there is no folder {text}")
    return path.absolute()


def _file(text):
    path = pathlib.Path(text)
    if not path.is_file():
        raise argparse.ArgumentTypeError(f"there is no file {text}")
    return path.absolute()


def _default_out():
    """Beside the front door's other files where called from the clone, else in `bench`."""
    return pathlib.Path(".slam/bench" if pathlib.Path(".slam").is_dir() else "bench")


def _add_mrclam(parser):
    parser.add_argument("--data", metavar="DIR", type=_folder,
                        help="MRCLAM data set (default: mrclam_dataset6 in $SLAM_DATA_DIR, else in "
                        "shared/data beside the repository)")


def _add_circles(parser):
    parser.add_argument("--circles", metavar="FILE", type=_file,
                        help="the DLR data set (default: circles/map.circles in $SLAM_DATA_DIR, "
                        "else in shared/data beside the repository)")


def add_ekf(parser):
    """Options of `slam_bench ekf`."""
    _add_mrclam(parser)
    parser.add_argument("--sizes", metavar="N,...", type=number_list, default=(100, 300, 1000),
                        help="numbers of landmarks of the part landmarks (100,300,1000)")
    parser.add_argument("--seeds", metavar="N", type=count, default=50,
                        help="runs of the part consistency (%(default)s)")
    parser.add_argument("--field", metavar="N", type=count, default=10000,
                        help="landmarks of the part growth (%(default)s)")


def add_pf(parser):
    """Options of `slam_bench pf`."""
    _add_mrclam(parser)
    parser.add_argument("--seeds", metavar="N", type=count, default=5,
                        help="runs a robot of the part mrclam (%(default)s)")
    parser.add_argument("--drives", metavar="N", type=count, default=20,
                        help="simulated drives of the part office (%(default)s)")
    _add_circles(parser)


def add_association(parser):
    """Options of `slam_bench association`."""
    _add_mrclam(parser)
    _add_circles(parser)
    parser.add_argument("--products", metavar="NAME,...", type=lambda text: text.split(","),
                        help="instead of ekf_wheel,pf_wheel,graph_wheel")
    parser.add_argument("--parks", metavar="N", type=count, default=2,
                        help="parks of each density of the part forest (%(default)s)")


def add_grid(parser):
    """Options of `slam_bench grid`."""
    parser.add_argument("--laser", metavar="DIR", type=_folder,
                        help="folder of intel.clf and intel.relations (default: laser in "
                        "$SLAM_DATA_DIR, else in shared/data beside the repository)")
    parser.add_argument("--seeds", metavar="N", type=count, default=3,
                        help="runs of the part intel, with the seeds 1 to N (%(default)s)")
    parser.add_argument("--drives", metavar="N", type=count, default=3,
                        help="simulated drives of the part office (%(default)s)")


def add_graph(parser):
    """Options of `slam_bench graph`."""
    parser.add_argument("--graphs", metavar="DIR", type=_folder,
                        help="folder of g2o files, the truth of NAME.g2o in NAME_truth.txt or "
                        "NAME_truth.dat (default: graphs in $SLAM_DATA_DIR, else in shared/data "
                        "beside the repository)")
    parser.add_argument("--poses", metavar="N,...", type=number_list, default=(1000, 3500, 10000),
                        help="sizes of the cities of the part worlds (1000,3500,10000)")
    parser.add_argument("--seed", metavar="N", type=count, default=1,
                        help="of these cities (%(default)s)")
    parser.add_argument("--seeds", metavar="N", type=count, default=20,
                        help="runs with each kind of false loops, with the seeds 1 to N "
                        "(%(default)s)")


def _seconds(text):
    value = float(text)
    if not 0.0 <= value < float("inf"):
        raise ValueError(text)
    return value


def add_laser(parser):
    """Options of `slam_bench laser`."""
    parser.add_argument("logs", metavar="LOG", type=_file, nargs="*",
                        help="CARMEN logs (.clf, .log), rawlogs or bags; relations are those of the "
                        "file with .relations instead (default: laser/*.clf in $SLAM_DATA_DIR, else "
                        "in shared/data beside the repository)")
    parser.add_argument("--seeds", metavar="N", type=count, default=3,
                        help="runs of each product that draws random numbers, with the seeds 1 to N "
                        "(%(default)s)")
    parser.add_argument("--products", metavar="NAME,...", type=lambda text: text.split(","),
                        help="instead of all whose map is a grid and whose odometry a log can have")
    parser.add_argument("--robot", metavar="NAME",
                        help="robot file (default: the one that the log names; of CARMEN logs "
                        "carmen)")
    parser.add_argument("--tolerance", metavar="S", type=_seconds, default=0.2,
                        help="how far a relation's stamp may be from that of the nearest scan [s] "
                        "(%(default)s)")


def add_pointmap(parser):
    """Options of `slam_bench pointmap`."""
    parser.add_argument("--seeds", metavar="N", type=count, default=3,
                        help="simulated drives of the part office (%(default)s)")


def _add_product(parser):
    parser.add_argument("--product", metavar="NAME", default="ekf_wheel",
                        help="what is measured (%(default)s)")
    parser.add_argument("--detector", metavar="NAME",
                        help="instead of the product's, like aruco")
    parser.add_argument("--world", metavar="NAME", default="office",
                        help="world of the simulation: a name or a file (%(default)s)")


def add_office(parser):
    """Options of `slam_bench office`."""
    _add_product(parser)
    parser.add_argument("--seeds", metavar="N", type=count, default=20,
                        help="runs, with the seeds 1 to N (%(default)s)")


def add_carried(parser):
    """Options of `slam_bench carried`."""
    parser.add_argument("--product", metavar="NAME", default="ekf_ceiling",
                        help="what is measured (%(default)s)")
    parser.add_argument("--world", metavar="NAME", default="office",
                        help="world of the simulation (%(default)s)")
    parser.add_argument("--robot", metavar="NAME", default="segway",
                        help="robot of the simulation, like car for the forest (%(default)s)")
    parser.add_argument("--duration", metavar="S", type=_seconds,
                        help="of a drive (default: all of the world's path)")
    parser.add_argument("--carried", metavar="S", type=_seconds, default=10.0,
                        help="so much of the drive is left out (%(default)g)")
    parser.add_argument("--seeds", metavar="N", type=count, default=20,
                        help="drives, with the seeds 1 to N (%(default)s)")


def add_fiducial(parser):
    """Options of `slam_bench fiducial`."""
    parser.add_argument("--image", metavar="FILE", type=_file,
                        help="photograph to measure the time on as well")


def add_imu(parser):
    """Options of `slam_bench imu`."""
    parser.add_argument("--seeds", metavar="N", type=count, default=5,
                        help="drives in each world, with the seeds 1 to N (%(default)s)")


def add_vo(parser):
    """Options of `slam_bench vo`."""
    parser.add_argument("--world", metavar="FILE", type=_file,
                        help="world file of slam_sim (default: the office's)")
    parser.add_argument("--robot", metavar="FILE", type=_file,
                        help="robot file of slam_sim (default: the segway's)")
    parser.add_argument("--seeds", metavar="N", type=count, default=20,
                        help="drives, with the seeds 1 to N (%(default)s)")


def add_online(parser):
    """Options of `slam_bench online`."""
    _add_product(parser)
    parser.add_argument("--bag", metavar="FILE", type=_file,
                        help="log to replay instead of a simulated one")
    parser.add_argument("--composition", choices=["pubsub", "inprocess"], default="pubsub",
                        help="a nodelet a component or one for all (%(default)s)")


def add_lost(parser):
    """Options of `slam_bench lost`."""
    parser.add_argument("--product", metavar="NAME", default="scan_grid_wheel",
                        help="what is measured: a product with a grid and wheels (%(default)s)")
    parser.add_argument("--drives", metavar="N", type=count, default=20,
                        help="random buildings, with a drive through each (%(default)s)")
    parser.add_argument("--first", metavar="SEED", type=count, default=1,
                        help="seed of the first building (%(default)s)")


def add_products(parser, default):
    """The option that names the products to be measured."""
    parser.add_argument("--products", metavar="NAME,...", type=lambda text: text.split(","),
                        default=list(default), help=f"instead of {','.join(default)}")


ADVERSE = ("ekf_wheel", "pf_wheel", "graph_wheel", "pf_wheel_grid", "scan_grid_wheel",
           "graph_wheel_grid")


def add_adverse(parser):
    """Options of `slam_bench adverse`."""
    add_products(parser, ADVERSE)
    parser.add_argument("--seeds", metavar="N", type=count, default=2,
                        help="halls, with a drive through each (%(default)s)")


DAYS = ("ekf_wheel", "pf_wheel", "graph_wheel", "scan_grid_wheel", "graph_wheel_grid",
        "pf_wheel_grid")


def add_days(parser):
    """Options of `slam_bench days`."""
    add_products(parser, DAYS)
    parser.add_argument("--hours", metavar="H", type=count, default=24,
                        help="of stamps (%(default)s)")
    parser.add_argument("--interval", metavar="SECONDS", type=float, default=2.0,
                        help="between two messages of a sensor (%(default)s)")


KILLED = ("ekf_wheel", "pf_wheel", "pf_wheel_grid", "scan_grid_wheel", "graph_wheel", "graph_wheel_grid")


def add_kills(parser):
    """Options of `slam_bench kills`."""
    add_products(parser, KILLED)
    parser.add_argument("--kills", metavar="N", type=count, default=200,
                        help="of all products together (%(default)s)")
    parser.add_argument("--seed", metavar="N", type=count, default=1,
                        help="of the drive and of the moments (%(default)s)")
    parser.add_argument("--bag", metavar="FILE", type=_file,
                        help="a drive of one's own, for all products, instead of simulated ones; it "
                        "names its robot")


CALIBRATING = ("ekf_wheel", "graph_wheel")


def add_calibration(parser):
    """Options of `slam_bench calibration`."""
    parser.add_argument("--seeds", metavar="N", type=count, default=10,
                        help="halls, with a drive through each (%(default)s)")
    add_products(parser, CALIBRATING)


def add_relocalisation(parser):
    """Options of `slam_bench relocalisation`."""
    parser.add_argument("--starts", metavar="N", type=count, default=100,
                        help="places at which a robot is switched on, of each case (%(default)s)")
    parser.add_argument("--seed", metavar="N", type=count, default=1,
                        help="of the drives and of the places (%(default)s)")
    parser.add_argument("--bag", metavar="FILE", type=_file, action="append", default=[],
                        help="bag with a laser and odometry, for a case of the part grid in the map "
                        "that is made of it; may be given several times")
    parser.add_argument("--robot", metavar="NAME",
                        help="robot file of these bags (default: the one that the bag names)")


def parse(arguments, benchmarks):
    """The options of the call; benchmarks: Benchmark by name, the first one counts without name."""
    parser = argparse.ArgumentParser(
        prog="slam_bench", description="Accuracy, consistency, time and memory as tables and "
        f"pictures. Without a name: {next(iter(benchmarks))}.")
    names = parser.add_subparsers(dest="benchmark", metavar="NAME", title="benchmarks")
    for name, benchmark in benchmarks.items():
        sub = names.add_parser(name, help=benchmark.summary, description=benchmark.summary)
        benchmark.add_options(sub)
        sub.add_argument("--only", metavar="PART,...", default=list(benchmark.parts),
                         type=lambda text, known=benchmark.parts: part_list(text, known),
                         help=f"only these parts of {', '.join(benchmark.parts)}")
        sub.add_argument("--out", metavar="DIR", type=pathlib.Path, default=_default_out(),
                         help="folder for the page and the pictures (%(default)s)")
        sub.add_argument("--keep", metavar="DIR", type=pathlib.Path,
                         help="keep bags, runs and logs in this folder")
    if not arguments or arguments[0].startswith("-") and arguments[0] not in ("-h", "--help"):
        arguments = [next(iter(benchmarks)), *arguments]
    return parser.parse_args(arguments)
