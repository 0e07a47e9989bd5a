# SPDX-License-Identifier: AGPL-3.0-or-later
"""The text of a case file from nested dictionaries."""

import json

INLINE_FROM = 2  # [first.second] are tables of their own; deeper ones are written on one line


def case_text(case):
    return "\n".join([*_lines([], case), ""]).lstrip("\n")


def _lines(path, table):
    nested = {key: value for key, value in table.items() if len(path) < INLINE_FROM and _is_table(value)}
    found = [f"{_key(key)} = {_value(value)}" for key, value in table.items() if key not in nested]
    for key, value in nested.items():
        inner = [*path, _key(key)]
        name = ".".join(inner)
        for entry in value if isinstance(value, list) else [value]:
            found += ["", f"[[{name}]]" if isinstance(value, list) else f"[{name}]", *_lines(inner, entry)]
    return found


def _is_table(value):
    return isinstance(value, dict) or (isinstance(value, list) and value and isinstance(value[0], dict))


def _key(key):
    return key if key.replace("_", "").replace("-", "").isalnum() else json.dumps(key)


def _value(value):
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{_key(key)} = {_value(entry)}" for key, entry in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(_value, value)) + "]"
    return json.dumps(value)
