# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""YAML files in which each key stands once, and errors that name the place."""
import yaml

from slam_eval.io.errors import did_you_mean, UsageError


class _Loader(yaml.SafeLoader):
    """Refuses a key that stands in a map twice, of which YAML would take the last, and a list or a
    map as a key, which Python cannot look up."""

    def construct_mapping(self, node, deep=False):
        seen = set()
        for key, _ in node.value:
            if not isinstance(key, yaml.ScalarNode):
                raise yaml.constructor.ConstructorError(
                    None, None, f"at column {key.start_mark.column + 1} a list or a map stands as a "
                    "key; a key is one word or number", key.start_mark)
            if key.value in seen:
                raise yaml.constructor.ConstructorError(
                    None, None, f"the key '{key.value}' stands there a second time", key.start_mark)
            seen.add(key.value)
        return super().construct_mapping(node, deep)


def _text(path):
    if not path.is_file():
        raise UsageError(f"{path}: there is no such file; check the path")
    try:
        return path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        raise UsageError(f"{path}: cannot be read as a text file; check the path") from None


def load(path):
    """The map that a file holds. Raises UsageError."""
    try:
        content = yaml.load(_text(path), _Loader)
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        line = f":{mark.line + 1}" if mark else ""
        problem = getattr(error, "problem", None) or str(error)
        raise UsageError(f"{path}{line}: no valid YAML: {' '.join(problem.split())}") from None
    if not isinstance(content, dict):
        raise UsageError(f"{path}: not a map of keys and values")
    return content


def is_path(text):
    """Whether a value names a file by its path, rather than something by its name."""
    return "/" in text or text.endswith(".yaml")


class Reader:
    """Takes values out of a map, and says what is wrong with one. where: the file and the entry."""

    def __init__(self, where, content, known):
        self.where = where
        if not isinstance(content, dict):
            raise UsageError(f"{where}: '{content}' is not a map of keys and values")
        self._content = content
        for key in content:
            if key not in known:
                raise UsageError(f"{where}: there is no key '{key}'"
                                    f"{did_you_mean(key, known)}; there are: {', '.join(known)}")

    def __contains__(self, key):
        return self._content.get(key) is not None

    def error(self, sentence):
        """The error to raise for what a sentence says."""
        return UsageError(f"{self.where}: {sentence}")

    def raw(self, key, default=None):
        value = self._content.get(key)
        return default if value is None else value

    def text(self, key, default=None):
        """A text or a number as text; the default where there is none."""
        value = self.raw(key, default)
        if isinstance(value, (dict, list, bool)):
            raise self.error(f"{key} is '{value}', which is no name")
        return value if value is None else str(value)

    def number(self, key, default=None):
        """A number above 0; the default where there is none."""
        value = self.raw(key, default)
        if value is None:
            return None
        if isinstance(value, bool) or not isinstance(value, (int, float)) or not (
                0 < value < float("inf")):
            raise self.error(f"{key} is '{value}', which is no number above 0")
        return value

    def many(self, key, default=()):
        """A list; one value counts as a list of it."""
        value = self.raw(key, list(default))
        if isinstance(value, dict):
            raise self.error(f"{key} is a map, where a list belongs")
        values = value if isinstance(value, list) else [value]
        if not values and key in self:
            raise self.error(f"the list {key} is empty")
        return values

    def map(self, key):
        """A map of names and values, empty where there is none."""
        value = self.raw(key, {})
        if not isinstance(value, dict):
            raise self.error(f"{key} is '{value}', where a map of parameters and values belongs")
        return value
