# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sentences from Kconfig: why a feature cannot be had, what a dependency asks for."""

import kconfiglib


def reason(symbol, describe):
    """Returns the sentences of those dependencies of a feature that the others do not give."""
    unmet = [term for term in kconfiglib.split_expr(symbol.direct_dep, kconfiglib.AND)
             if kconfiglib.expr_value(term) == 0]
    return "; ".join(sentence(term, describe) for term in unmet) or \
        f"{describe(symbol)} does not go with the other features"


def sentence(term, describe):
    """Returns the help text of what is lacking, without its full stop."""
    helps = [node.help for node in getattr(term, "nodes", []) if node.help]
    if helps:
        return " ".join(helps[0].split()).rstrip(".")
    return f"it needs {requirement(term, describe)}"


def requirement(expression, describe):
    """Returns an expression in the words of a command line: backend=ekf or backend=pf."""
    words = []
    for term in kconfiglib.split_expr(expression, kconfiglib.OR):
        factors = [describe(factor) if isinstance(factor, kconfiglib.Symbol)
                   else kconfiglib.expr_str(factor)
                   for factor in kconfiglib.split_expr(term, kconfiglib.AND)]
        words.append(" and ".join(factors))
    return " or ".join(words)
