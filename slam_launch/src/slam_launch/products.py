# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Products: their files against the feature model, finding and writing them."""

import dataclasses
import pathlib
import re

import yaml

from . import command_line, config_files, parameters, ports
from .errors import ProductError
from .feature_model import mentioned, text

WRITTEN = """\
# A product of the SLAM product line; `{check} {name}` checks it.
"""
IN_FILES = {"detector": "none"}  # what leaving a key out of a product file means, where the model
#                                  has another default


@dataclasses.dataclass(frozen=True)
class Product:
    """A valid product: what a product file holds, or would hold."""

    name: str       # empty where there is no file
    content: dict
    features: dict  # complete
    path: pathlib.Path = None


def read(path, model):
    """Returns the product of a file. Whatever is wrong with it is told with its path."""
    content = config_files.load(path)
    given = {key: value_text(value) for key, value in content.items()
             if key in model.groups and value is not None}
    for key, value in IN_FILES.items():
        if key in model.groups:
            given.setdefault(key, value)
    try:
        features = model.require_valid(given)
        require_sections(content, features, model)
    except ProductError as error:
        raise ProductError(f"{path}: {error}") from error
    return Product(path.stem, content, features, path)


def value_text(value):
    """YAML's true is the text true, as in an argument."""
    return value if isinstance(value, (list, str)) else str(value).lower()


def require_sections(content, features, model):
    """Refuses parameters of features that are not chosen."""
    for section, values in content.items():
        needed = model.needed_by(section, features) if isinstance(values, dict) else None
        if needed:
            name = ".".join([section, *list(values)[:1]])
            raise ProductError(f"{name} is a parameter of {needed}, which is not chosen: the "
                               f"product is {text(features)}")


def require_parameters(product, overrides=()):
    """Refuses parameters that components could not read, of the product's file and of
    SECTION.KEY=VALUE that count instead of its values."""
    if product.path:
        parameters.require_valid_file(product.path, overrides)
    else:
        parameters.require_valid_overrides(overrides, product.content["libraries"])


def find(name_or_file, model):
    return read(config_files.find("products", name_or_file), model)


def named(model, report=lambda fault: None):
    """Returns every valid product that has a name; what is wrong with other files is reported."""
    found = []
    for path in config_files.files("products").values():
        try:
            found.append(read(path, model))
        except ProductError as fault:
            report(fault)
    return found


def is_own(product):
    """Whether the user has written a product, by `./slam new` or in an editor."""
    return product.path is not None and product.path.parent == config_files.user_products()


def has_parameters(product, model):
    """Whether a product's file holds more than features, a name and a sentence."""
    plain = without_file(product.features, model).content
    return any(plain.get(key) != value for key, value in product.content.items()
               if key not in ("product", "sentence", *product.features))


def without_file(features, model, name=""):
    """Returns the product with these features, as it would stand in a file."""
    content = {"version": config_files.VERSION, "product": name or "_".join(
        value for value in features.values() if value not in ("true", "false", "none")),
               "sentence": f"The product {text(features)}.", **yaml_features(features),
               "libraries": model.strings("LIBRARY_", features), "seed": 1}
    return Product(name, content, dict(features))


def yaml_features(features):
    """Returns features as a product file has them; a module that is left out is not in it, since
    another package's is not known without that package's library."""
    return {key: True if value == "true" else value for key, value in mentioned(features).items()}


def with_features(features, model):
    """Returns the first named product with these features, or one that differs in what can be
    swapped, given these; else a product without a name. Features mean the same to everybody: the
    user's own products are only found by their names."""
    known = [product for product in named(model) if not is_own(product)]
    for same in (lambda product: product.features,
                 lambda product: {**product.features, **swappable(features)}):
        for product in known:
            if same(product) == features:
                return swapped(product, features)
    return without_file(features, model)


def swappable(features):
    """Returns the detectors, the association and the modules: the rest of a product is the same
    with another."""
    return {key: value for key, value in features.items()
            if key in ("detector", "second_detector", "association") or value in ("true", "false")}


def swapped(product, features):
    """Returns a product with the detectors, the association and the modules of other features."""
    changed = swappable(features)
    kept = {key: value for key, value in product.content.items() if key not in changed}
    return dataclasses.replace(product, content={**kept, **yaml_features(changed)},
                               features={**product.features, **changed})


def split_arguments(words):
    """Returns the features and the parameters ({section: {key: text}}) of KEY=VALUE arguments."""
    features, sections = {}, {}
    for word in words:
        key, equals, value = word.partition("=")
        key = key.rstrip(":")
        section, dot, field = key.rpartition(".")
        if not equals or not key or not value or dot and not (section and field):
            raise ProductError(f"'{word}' is not KEY=VALUE")
        target = sections.setdefault(section, {}) if dot else features
        name = field if dot else key
        if name in target:
            raise ProductError(f"{key} is given twice, as {target[name]} and as {value}; a product "
                               f"has exactly one")
        target[name] = value
    return features, sections


def make(name, words, model):
    """Returns the product that KEY=VALUE arguments describe."""
    given, sections = split_arguments(words)
    require_features(given, model)
    product = without_file(model.require_valid(given), model, name)
    for section, values in sections.items():
        if section in product.content:
            raise ProductError(f"{section}.{next(iter(values))} is no parameter: {section} stands "
                               "for itself in a product file, it is no section")
        product.content[section] = {key: parsed(f"{section}.{key}", value)
                                    for key, value in values.items()}
    require_sections(product.content, product.features, model)
    parameters.require_valid_parameters(
        [f"{section}.{key}={value}" for section, values in sections.items()
         for key, value in values.items()], product.content["libraries"])
    ports.require_joined(product)
    return product


def require_features(given, model):
    """Refuses features that the model does not have; names the parameters that were meant."""
    for key in given:
        meant = [] if key in model.groups else parameters.of_name(key)
        if meant:
            raise ProductError(f"there is no feature '{key}'; {' and '.join(meant)} "
                               f"{'is a parameter' if len(meant) == 1 else 'are parameters'} of "
                               "that name, given with the section")


def parsed(key, value):
    """Returns the value of an argument as a product file would have it."""
    if re.fullmatch(r"[-+]?0\d+", value):  # an octal number in YAML
        raise ProductError(f"{key}={value} is no value: a number does not begin with 0")
    try:
        return yaml.safe_load(value)
    except yaml.YAMLError as error:
        raise ProductError(f"{key}={value} is no value: {' '.join(str(error).split())}") from error


def write(product):
    """Writes a product into the user's folder, for everybody who looks a name up; returns where."""
    if not re.fullmatch(r"[A-Za-z]\w*", product.name, re.ASCII):
        raise ProductError(f"'{product.name}' is no name of a product: letters, digits and _, a "
                           "letter first")
    taken = config_files.files("products").get(product.name)
    if taken:
        raise ProductError(f"there is a product '{product.name}' already, {taken}; give another "
                           "name, or remove that file")
    folder = config_files.user_products()
    path = folder / f"{product.name}.yaml"
    try:
        folder.mkdir(parents=True, exist_ok=True)
        path.write_text(WRITTEN.format(name=product.name, check=command_line.command("check")) +
                        yaml.safe_dump(product.content, sort_keys=False, width=100),
                        encoding="utf-8")
    except OSError as error:
        raise ProductError(f"cannot write {path}: {error.strerror}") from error
    return path
