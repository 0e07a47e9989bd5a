# SPDX-License-Identifier: AGPL-3.0-or-later
"""Exceptions of the module."""

from collections.abc import Iterable


class InputError(ValueError):
    """The case, the mesh or an argument is wrong. The text has one line for each fault.

    `faults` is a list of (file, line, text); the file is empty and the line 0 where there is none."""

    def __init__(self, text: str, faults: Iterable[tuple[str, int, str]] = ()) -> None:
        super().__init__(text)
        self.faults = list(faults)


class FileError(OSError):
    """A file could not be read or written."""


class NotFiniteError(ArithmeticError):
    """A solution is not finite: the problem has no steady state that numbers can hold."""


class Stopped(RuntimeError):
    """A solve was stopped within a sweep: there is no result."""
