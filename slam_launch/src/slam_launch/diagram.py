# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""A product's component diagram (thesis, Figs. 6.1 to 6.9): its nodelets, the topics between them,
the sensors before and the results behind. Composed in one process (Fig. 4.4) there is one nodelet,
whose meta-coordinator hands the same data from component to component."""

import dataclasses
import functools
import html
import subprocess

from roslaunch.config import load_config_default
import rospkg

from . import ports
from .errors import ProductError

FORMATS = ("svg", "png", "pdf", "dot")
# what a component of the front-end publishes
FRONT_END = {"motion", "observations", "second_observations", "rear_observations",
             "rear_second_observations"}
BACK_END = "pose"
SENSORS = {"odom": "wheel encoders", "cmd_vel_out": "base controller",
           "camera/image_raw": "front camera",
           "rear_camera/image_raw": "rear camera",
           "ceiling_camera/image_raw": "camera that looks up", "scan": "laser",
           "rear_scan": "rear laser", "imu": "IMU",
           "observations": "landmark observations of others", "motion": "motion of others"}
RESULTS = "robot, rviz"
INPROCESS = "slam_launch/launch/inprocess.launch"
END = 'style="rounded,filled", fillcolor="#f4f5f7"'
INK, MUTED, NEW = "#22262b", "#7a7f87", "#c2561a"
FILLS = {"Front-end": "#e8f1ee", "Back-end": "#e6eef8", "Additional modules": "#f1ebf7"}
GRAPH = f"""digraph product {{
  graph [rankdir=LR, fontname="Helvetica", fontsize=12, fontcolor="{MUTED}", nodesep=0.35,
         ranksep=0.75, pad=0.2, bgcolor="white"];
  node [fontname="Helvetica", fontsize=12, fontcolor="{INK}", color="#9aa1aa", shape=box];
  edge [fontname="Helvetica", fontsize=10.5, color="#6b727a", arrowsize=0.7];
"""


@dataclasses.dataclass(frozen=True)
class Component:
    """A nodelet of a product with its data's topics."""

    name: str    # of the node
    plugin: str  # PACKAGE/CLASS
    inputs: tuple
    outputs: tuple
    is_stage: bool = False  # before the back-end, and beside it

    @property
    def group(self):
        if self.is_stage:
            return "Back-end"
        if FRONT_END & set(self.outputs):
            return "Front-end"
        return "Back-end" if BACK_END in self.outputs else "Additional modules"


def components(product, model):
    """Returns the Components of a product: by the ports of its parts, each in the nodelet of the
    launch file that the feature model has for its role. A launch file beyond them takes and makes
    nothing that the parts say."""
    launches = model.launches(product.features)
    wired = ports.of_product(product)
    drawn = [component(part, taken(launches, part), wired) for part in wired.components]
    return drawn + [Component(*nodelet(launch), (), ()) for launch in launches]


def taken(launches, part):
    """Takes the launch file of a part out of {PACKAGE/FILE: keys of the features it is for}."""
    for launch, keys in launches.items():
        if set(part.features) <= keys:
            del launches[launch]
            return launch
    raise ProductError(f"the feature model: no LAUNCH_... starts the {part.role} '{part.name}', "
                       f"which {' and '.join(part.features)} names")


def component(part, launch, wired):
    inputs = [port.topic for taken in part.inputs if taken.time != ports.LATCHED
              for port in ports.before_gates(taken, wired)]
    outputs = [port.topic for port in part.outputs]
    return Component(*nodelet(launch), tuple(dict.fromkeys(inputs)), tuple(dict.fromkeys(outputs)),
                     part.role == "stage")


@functools.lru_cache(maxsize=None)
def nodelet(launch):
    """Returns the name and the plugin of the nodelet that PACKAGE/FILE starts."""
    package, _, file = launch.partition("/")
    try:
        path = rospkg.RosPack().get_path(package) + "/" + file
        config = load_config_default([(path, ["manager:=manager"])], None, verbose=False,
                                     assign_machines=False)
        return next((node.name, node.args.split()[1]) for node in config.nodes
                    if node.args.startswith("load "))
    except rospkg.ResourceNotFound:
        raise ProductError(f"the feature model names {launch}, but there is no package "
                           f"{package}") from None
    except StopIteration:
        raise ProductError(f"{launch} loads no nodelet") from None
    except Exception as error:  # roslaunch raises what it finds
        raise ProductError(f"{launch}: {error}") from error


def edges(parts):
    """Returns each (from, topic, to) between sensors, components and who uses the results."""
    made = {topic: part.name for part in parts for topic in part.outputs}
    taken = [(made.get(topic, f"sensor {topic}"), topic, part.name)
             for part in parts for topic in part.inputs]
    used = {topic for _, topic, _ in taken}
    results = [(part.name, topic, RESULTS) for part in parts for topic in part.outputs
               if topic == BACK_END or topic not in used]
    return taken + results


def dot(parts, former=(), coordinator=""):
    """Returns the diagram in graphviz's language; what the former product has not is coloured. A
    coordinator's title makes it that of the composition in one process."""
    old_parts, old_edges = set(former), set(edges(former))
    lines = []
    for group in FILLS:
        boxes = [box(part, new(part, old_parts), bool(coordinator)) for part in parts
                 if part.group == group]
        if boxes:
            lines.append(cluster(group, boxes, FILLS[group]))
    if coordinator:
        lines = [cluster(coordinator, lines, "#f4f5f7")]
    lines += ends(parts, former)
    called = {part.name for part in parts} if coordinator else set()
    lines += [arrow(start, topics, end, new_edge, {start, end} <= called)
              for (start, end, new_edge), topics in bundled(edges(parts), old_edges).items()]
    return "".join([GRAPH, *lines]) + "}\n"


def new(entry, old):
    return bool(old) and entry not in old


def bundled(links, old):
    """Returns the topics by (from, to, whether they are new): one arrow for the results."""
    bundles = {}
    for start, topic, end in links:
        bundles.setdefault((start, end, new((start, topic, end), old)), []).append(topic)
    return bundles


def cluster(title, boxes, fill):
    return (f'  subgraph "cluster {title}" {{ label="{title}"; labeljust=l; margin=14; '
            f'style="rounded,filled"; color="{fill}";\n{"".join(boxes)}  }}\n')


def box(part, is_new, is_inside):
    """A component; one inside the meta-coordinator is no nodelet of its own."""
    plugin = f'<font point-size="10" color="{MUTED}">{html.escape(part.plugin)}</font>'
    label = (f'<<font point-size="10" color="{MUTED}">«component»</font><br/>'
             f"<b>{html.escape(part.name)}</b>{'' if is_inside else '<br/>' + plugin}>")
    return node(part.name, label, 'shape=component, style=filled, fillcolor="white", '
                'margin="0.25,0.12"', is_new)


def ends(parts, former):
    """Returns the boxes of sensors, all in the first column, and of who uses the results."""
    links, old = edges(parts), {name for link in edges(former) for name in link}
    sensors = {start: topic for start, topic, _ in links if start.startswith("sensor ")}
    boxes = "".join(node(name, SENSORS.get(topic, topic), END, new(name, old))
                    for name, topic in sensors.items())
    robot = node(RESULTS, RESULTS, END, False)
    return [f"  {{ rank=source;\n{boxes}  }}\n", f"  {{ rank=sink;\n{robot}  }}\n"]


def node(name, label, style, is_new):
    colour = f', color="{NEW}", penwidth=1.8' if is_new else ""
    text = label if label.startswith("<") else f'"{label}"'
    return f'    "{name}" [label={text}, {style}{colour}];\n'


def arrow(start, topics, end, is_new, is_call):
    """Topics; dashed where the meta-coordinator hands the same data on, by set() and get."""
    label = r"\n".join(topics)
    colour = f', color="{NEW}", fontcolor="{NEW}", penwidth=1.6' if is_new else ""
    dashes = ", style=dashed" if is_call else ""
    return f'  "{start}" -> "{end}" [label="{label}"{dashes}{colour}];\n'


def coordinator_title():
    name, plugin = nodelet(INPROCESS)
    return f"{name} ({plugin}): the meta-coordinator; dashed: a call, no topic"


def draw(product, path, model, former=None, composition="pubsub"):
    """Writes the diagram of a product as SVG, PNG, PDF or in graphviz's language, by the file's
    name; what the product `former` has not is coloured."""
    write(path, dot(components(product, model), components(former, model) if former else (),
                    coordinator_title() if composition == "inprocess" else ""))


def write(path, text):
    """Writes a text in graphviz's language, or what graphviz makes of it, by the file's name."""
    kind = path.suffix[1:]
    if kind not in FORMATS:
        raise ProductError(f"{path} ends with none of: {', '.join('.' + name for name in FORMATS)}")
    try:
        if kind != "dot":
            text = subprocess.run(["dot", f"-T{kind}"], input=text.encode(), check=True,
                                  stdout=subprocess.PIPE).stdout
        path.write_bytes(text if kind != "dot" else text.encode())
    except FileNotFoundError as error:
        missing = "there is no program dot; install graphviz" if error.filename == "dot" else str(
            f"cannot write {path}: {error.strerror}")
        raise ProductError(missing) from error
    except (OSError, subprocess.CalledProcessError) as error:
        raise ProductError(f"cannot draw {path}: {error}") from error
