# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Part circles: DLR's circles on a floor, the ids that were given by hand not looked at."""
from slam_eval.bench.association.policies import DEFINITIONS, run_all, table_of
from slam_eval.bench.harness.programs import data_folder
from slam_eval.bench.harness.runs import import_log
from slam_eval.bench.harness.table import Section

GAP = 200  # steps out of sight after which a landmark that is seen again closes a loop


def first_loop(bag):
    """The stamp [ns] at which a landmark is seen that was out of sight for GAP steps."""
    import rosbag  # takes a while, and few benchmarks need it
    last = {}
    with rosbag.Bag(str(bag)) as log:
        arrays = log.read_messages(["/observations"])
        for step, (_, message, _) in enumerate(arrays):
            for z in message.observations:
                if z.id >= 0 and step - last.get(z.id, step) > GAP:
                    return message.header.stamp.to_nsec()
                last[z.id] = step
    return None


def measure(context):
    """The section of this part."""
    section = Section("Circles on a floor, ids withheld")
    file = context.options.circles or data_folder("circles") / "map.circles"
    if not file.is_file():
        section.paragraphs.append(f"Left out: there is no file {file} of the DLR data set "
                                  "(--circles FILE or $SLAM_DATA_DIR name another one).")
        return section
    bag = import_log(context, "circles", ["circles", file])
    loop = first_loop(bag)
    lines = run_all(context, "circles", bag, section, "circles", loop)
    section.paragraphs += [table_of(lines), DEFINITIONS,
                           "Pairings are judged up to the first loop closure; 99 % precision and "
                           "95 % recall are the aim there. Ghosts are those of the whole log."]
    return section
