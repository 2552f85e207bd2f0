# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Product files and robot files: reading them, and finding them by name."""

import os
import pathlib
import stat

import yaml

from . import packages
from .errors import did_you_mean, ProductError

VERSION = 1  # of both kinds of files
MOST_VALUES = 200_000  # as the programs without ROS have it
MOST_DEPTH = 32


class Loader(yaml.SafeLoader):
    """Refuses a key that stands in a map twice, as the programs without ROS do, and files out of
    all bounds: an alias counts as all that it stands for.

    Keys are texts, numbers as well: the parameter server knows no others.
    """

    def __init__(self, stream):
        super().__init__(stream)
        self.open = []  # the anchors of the lists and maps that are being read; None without
        self.values = 0  # so far
        self.sizes = {}  # of what has an anchor

    def compose_node(self, parent, index):
        event = self.peek_event()
        before = self.values
        self.values += self.sizes.get(event.anchor, 0) \
            if isinstance(event, yaml.events.AliasEvent) else 1
        if isinstance(event, yaml.events.AliasEvent) and event.anchor in self.open:
            self.refuse("an alias stands within what it refers to", event)
        if self.values > MOST_VALUES:
            self.refuse(f"it holds more than {MOST_VALUES} values, each alias counted as what it "
                        "stands for", event)
        if len(self.open) > MOST_DEPTH:
            self.refuse(f"lists and maps are nested more than {MOST_DEPTH} deep", event)
        self.open.append(event.anchor)
        node = super().compose_node(parent, index)
        self.open.pop()
        if event.anchor is not None and not isinstance(event, yaml.events.AliasEvent):
            self.sizes[event.anchor] = self.values - before
        return node

    @staticmethod
    def refuse(sentence, event):
        raise yaml.composer.ComposerError(None, None, sentence, event.start_mark)

    def construct_mapping(self, node, deep=False):
        seen = set()
        for key, _ in node.value:
            name = str(key.value)
            if name in seen:
                raise yaml.constructor.ConstructorError(
                    None, None, f"{name} stands there a second time", key.start_mark)
            seen.add(name)
        return {str(key): value for key, value in super().construct_mapping(node, deep).items()}


def require_regular(name, path, folder=False):
    """Refuses what is no regular file: to read a pipe would take for good."""
    try:
        mode = os.stat(path).st_mode
    except OSError:
        raise ProductError(f"{name}: there is no such file") from None
    if not stat.S_ISREG(mode) and not (folder and stat.S_ISDIR(mode)):
        raise ProductError(f"{name} is a folder, a pipe or a device, not a regular file")


def load(path):
    """Returns the content of a product file or robot file of this version."""
    require_regular(path, path)
    try:
        content = yaml.load(path.read_text(encoding="utf-8"), Loader)
    except (OSError, UnicodeDecodeError, yaml.YAMLError) as error:
        raise ProductError(f"cannot read {path}: {' '.join(str(error).split())}") from error
    if not isinstance(content, dict):
        raise ProductError(f"{path} is not a map of keys and values")
    require_version(path, content.get("version"))
    return content


def require_version(path, version):
    if version == VERSION:
        return
    if isinstance(version, int) and version > VERSION:
        raise ProductError(f"{path} has version {version}, which is newer than this program, "
                           f"which reads version {VERSION}: update the program, or write the file "
                           "anew")
    raise ProductError(f"{path} has {'no version' if version is None else f'version {version}'}; "
                       f"this program reads version {VERSION}")


def user_products():
    """Returns the folder of the products that `./slam new` and `./slam menu` write."""
    root = os.environ.get("XDG_CONFIG_HOME") or pathlib.Path.home() / ".config"
    return pathlib.Path(root) / "slam" / "products"


def files(kind):
    """Returns the path of each file of a kind (products, robots) by name; the shipped ones first,
    then those of other packages, then the user's own."""
    folders = [packages.share() / kind]
    if kind == "products":
        folders += [*packages.exported("products"), user_products()]
    found = {}
    for folder in folders:
        for path in sorted(folder.glob("*.yaml")):
            found.setdefault(path.stem, path)
    return found


def is_path(text):
    return "/" in text or text.endswith(".yaml")


def find(kind, text):
    """Returns the path that a NAME or FILE stands for."""
    if is_path(text):
        return pathlib.Path(text).expanduser()
    known = files(kind)
    if text in known:
        return known[text]
    raise ProductError(f"there is no {kind[:-1]} '{text}'{did_you_mean(text, known)}; there are: "
                       f"{', '.join(known)}; a file's name holds a / or ends with .yaml")
