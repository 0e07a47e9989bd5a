# SPDX-License-Identifier: AGPL-3.0-or-later
"""Radiative transport by discrete ordinates on tetrahedra.

    import etendue
    case = etendue.load("room.toml")
    case["media"]["air"]["scattering"] = [0.3, 0.2, 0.1]
    solution = etendue.solve(case)
    solution.fluence.mean(axis=1)
"""

from collections.abc import Callable, Mapping
from typing import Any

from etendue._etendue import version
from etendue.case import Case, checked, load
from etendue.errors import FileError, InputError, NotFiniteError, Stopped
from etendue.mesh import Mesh, from_meshio, read_mesh
from etendue.solution import Picture, Solution

from etendue import _etendue

__all__ = ["Case", "FileError", "InputError", "Mesh", "NotFiniteError", "Picture", "Solution", "Stopped", "check", "command",
           "from_meshio", "load", "mesh", "read_mesh", "solve", "version"]
__version__ = version()


def solve(case: Mapping[str, Any], mesh: _etendue.Mesh | None = None, threads: int = 0,
          progress: Callable[[dict[str, Any]], object] | bool | None = None) -> Solution:
    """Meshes and solves a case. Not converging is a result, marked in the solution.

    case      a Case, or a dictionary with the tree of a case file
    mesh      replaces the table "mesh" of the case
    threads   0: as the case says
    progress  called where a stage begins and after every sweep, with a dictionary: stage, sweep, residual (of each band),
              tolerance, seconds, seconds_left; where it returns False the iteration ends. True prints a line for each.

    Other threads of Python run meanwhile. Ctrl-C ends the solve within a sweep.
    Raises InputError, FileError and NotFiniteError.
    """
    found = checked(case, mesh)
    if progress and progress is not True and not callable(progress):
        raise TypeError(f"progress: {progress!r} cannot be called; give a function, or True to print")
    shown = _print_progress if progress is True else progress if callable(progress) else None
    return Solution(_etendue.solve(found, mesh, threads, shown), case if isinstance(case, Case) else Case(case))


def check(case: Mapping[str, Any], mesh: _etendue.Mesh | None = None) -> None:
    """Finds all that a solve refuses before its first sweep. Raises InputError."""
    found = checked(case, mesh)
    _etendue.check(found, found.mesh() if mesh is None else mesh)


def mesh(case: Mapping[str, Any]) -> _etendue.Mesh:
    """The mesh of a case: its geometry filled with tetrahedra, or its mesh file."""
    return checked(case).mesh()


def command(*arguments: object) -> tuple[int, str, str]:
    """Does what the program does with these arguments; returns (exit code, output, errors).

        etendue.command("study", "room.toml")
    """
    return _etendue.command([str(argument) for argument in arguments])


def _print_progress(state: dict[str, Any]) -> None:
    residual = f" {state['sweep']}, residual {max(state['residual']):.1e}" if state["residual"] else ""
    print(f"{state['stage']}{residual}", flush=True)
