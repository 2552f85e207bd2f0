# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""[SECTION.]KEY=VALUE of a launch or a run, which count instead of the files' values."""

import re

from . import command_line, products
from .errors import ProductError
from .feature_model import text

WORD = r"[^.=]+(\.[^=]+)?=.+"


def split(words):
    """Returns the values, as texts, by [SECTION.]KEY; each has one."""
    values = {}
    for word in words:
        if not re.fullmatch(WORD, word):
            raise ProductError(f"'{word}' is set, which is not [SECTION.]KEY=VALUE")
        key, _, value = word.partition("=")
        if key in values:
            raise ProductError(f"{key} is set twice, to {values[key]} and to {value}; set it once")
        values[key] = value
    return values


def sections(values):
    """Returns the sections, each with the first key that is set."""
    names = [key.rpartition(".") for key in values]
    return {section: {key: None} for section, _, key in reversed(names) if section}


def require_no_feature(values, model):
    """Refuses features where each is an argument of its own, which also chooses what starts."""
    for key in values:
        if key in model.groups:
            raise ProductError(f"set:={key}={values[key]} is a feature, not a parameter: give "
                               f"{key}:={values[key]}")


def applied(product, words, model):
    """Returns the product that a run of this one is: its detectors, its association and its modules
    can be set, all other features are what it is."""
    values = split(words)
    features = {key: value for key, value in values.items() if key in model.groups}
    model.require_known(features)
    for key, value in features.items():
        if key not in products.swappable(product.features) and value != product.features[key]:
            raise ProductError(f"{key}={value} cannot be set, since the product {product.name} is "
                               f"{text(product.features)}; name a product that has it "
                               f"('{command_line.command('products')}' lists them)")
    changed = model.require_valid({**product.features, **features})
    products.require_sections(sections(values), changed, model)
    return products.swapped(product, changed)
