# SPDX-License-Identifier: AGPL-3.0-or-later
"""Dictionaries as TOML. (The standard library reads TOML but does not write it.)"""

import json
import re
from collections.abc import Iterator, Mapping
from typing import Any

BARE = re.compile(r"[A-Za-z0-9_-]+")


def dumps(table: Mapping[str, Any]) -> str:
    """TOML of a dictionary of strings, numbers, booleans, lists and dictionaries; numpy's numbers and arrays too."""
    return "".join(f"{key_of(key)} = {value_of(value)}\n" for key, value in table.items() if not is_table(value)) + \
        "".join(text for key, value in table.items() if is_table(value) for text in tables_of((key,), value))


def is_table(value: Any) -> bool:
    return isinstance(value, dict) or (isinstance(value, (list, tuple)) and len(value) > 0 and
                                       all(isinstance(entry, dict) for entry in value))


def tables_of(path: tuple[str, ...], value: Any) -> Iterator[str]:
    """Of a dictionary [path], and of a list of them [[path]]."""
    name = ".".join(map(key_of, path))
    for table in [value] if isinstance(value, dict) else value:
        yield f"\n[{name}]\n" if isinstance(value, dict) else f"\n[[{name}]]\n"
        for key, entry in table.items():
            if not is_table(entry):
                yield f"{key_of(key)} = {value_of(entry)}\n"
        for key, entry in table.items():
            if is_table(entry):
                yield from tables_of((*path, key), entry)


def key_of(key: Any) -> str:
    if not isinstance(key, str):
        raise TypeError(f"{key!r}: a key of a case is a string")
    return key if BARE.fullmatch(key) else json.dumps(key)


def value_of(value: Any) -> str:
    if hasattr(value, "tolist"):  # numpy
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return {"inf": "inf", "-inf": "-inf", "nan": "nan"}.get(repr(value), repr(value))
    if isinstance(value, int):
        return repr(value)
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key_of(key)} = {value_of(entry)}" for key, entry in value.items()) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(value_of, value)) + "]"
    if hasattr(value, "__fspath__"):
        value = value.__fspath__()
    if isinstance(value, str):
        # JSON's escapes are TOML's but for DEL, which TOML wants escaped.
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    raise TypeError(f"{value!r}: a value of a case is a text, a number, a boolean, a list or a dictionary")
