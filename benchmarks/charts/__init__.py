# SPDX-License-Identifier: GPL-3.0-or-later
"""The charts that benchmarks/plot draws, and what they share"""


def newest(rows, keys):
    """The last of the rows that agree in all keys, in order of first appearance"""
    found = {}
    for row in rows:
        found[tuple(row.get(k) for k in keys)] = row
    return list(found.values())


def number(text):
    """Its value, or None"""
    try:
        return float(text)
    except (TypeError, ValueError):
        return None


def groups(rows, key):
    """{key(row): rows}, in order of first appearance"""
    result = {}
    for row in rows:
        result.setdefault(key(row), []).append(row)
    return result
