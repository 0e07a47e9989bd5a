# SPDX-License-Identifier: AGPL-3.0-or-later
"""Cases as dictionaries."""

import copy
import os
import pathlib
import tomllib
from collections.abc import Iterable, Mapping
from typing import Any

from etendue import _etendue, toml


class Case(dict[str, Any]):
    """A case: the tree of the case file as a dictionary, with the keys that docs/user/keys.md lists.

    `file` is where it was read from; paths in the case start in its folder, and its name is in messages."""

    def __init__(self, tree: Mapping[str, Any] | Iterable[tuple[str, Any]] = (), file: str | os.PathLike[str] = "case.toml",
                 **tables: Any) -> None:
        super().__init__(tree, **tables)
        self.file = pathlib.Path(file)
        self._read: dict[str, Any] | None = None

    def copy(self) -> "Case":
        """Another case that can be changed apart from this one."""
        other = Case(copy.deepcopy(dict(self)), self.file)
        other._read = self._read
        return other

    def resolved(self) -> "Case":
        """The case with all defaults filled in. Raises InputError."""
        return Case(tomllib.loads(checked(self).resolved_toml), self.file)

    def to_toml(self) -> str:
        return toml.dumps(self)


def load(file: str | os.PathLike[str], overrides: Iterable[str] = ()) -> Case:
    """Reads a case file, and checks it: raises InputError with all faults and their lines, and FileError.

    `overrides` change keys: "solve.tolerance=1e-8"."""
    found = _etendue.Case.from_file(file, list(overrides))
    text = pathlib.Path(file).read_text(encoding="utf-8")
    if overrides:
        return Case(tomllib.loads(found.resolved_toml), file)
    case = Case(tomllib.loads(text), file)
    case._read = copy.deepcopy(dict(case))  # while it is unchanged messages have the file's lines
    return case


def checked(case: Mapping[str, Any], mesh: _etendue.Mesh | None = None) -> _etendue.Case:
    """The case as the library has it; `mesh` replaces the table of the case."""
    if not isinstance(case, Case):
        case = Case(case)
    if mesh is None and case._read is not None and case._read == dict(case):
        return _etendue.Case.from_file(case.file, [])
    tree = {key: value for key, value in case.items() if mesh is None or key != "mesh"}
    return _etendue.Case.from_text(toml.dumps(tree), mesh, case.file, [])
