# SPDX-License-Identifier: AGPL-3.0-or-later
"""A computed value beside its reference, and whether it is near enough."""

import dataclasses
import fnmatch


@dataclasses.dataclass
class Row:
    """`uncertainty` is one standard deviation of the reference, or what its digits leave open; None: not known.
    `plot`, `curve` and `x` put the row into a plot; `run`, `probe`, `index` and `band` say where its value stands."""

    label: str
    value: float
    reference: float
    uncertainty: float | None = None
    plot: str = ""
    curve: str = ""
    x: float | None = None
    run: str = ""
    probe: str = ""
    index: str = ""
    band: str = ""
    column: str = "fluence"

    @property
    def difference(self):
        return self.value - self.reference

    @property
    def relative(self):
        return self.difference / abs(self.reference) if self.reference else None

    @property
    def sigmas(self):
        """The difference in units of the reference's own uncertainty."""
        return self.difference / self.uncertainty if self.uncertainty else None


@dataclasses.dataclass
class Line:
    """A computed curve of a plot, drawn through the rows of the same name."""

    plot: str
    curve: str
    x: list
    y: list


@dataclasses.dataclass
class Judged:
    """A row with what its tolerance allows; None where the row is only reported."""

    row: Row
    allowed: float | None
    reason: str

    @property
    def share(self):
        """Of what is allowed: at most 1 where the row meets its reference."""
        return None if self.allowed is None else abs(self.row.difference) / self.allowed

    @property
    def met(self):
        return self.allowed is None or abs(self.row.difference) <= self.allowed

    @property
    def verdict(self):
        return "" if self.allowed is None else "PASS" if self.met else "miss"


def judge(row, tolerances):
    """By the last tolerance whose pattern matches the label. What is allowed is its part of the reference (relative)
    or a number (absolute), and three times the reference's own uncertainty."""
    chosen = [entry for entry in tolerances if fnmatch.fnmatchcase(row.label, entry["of"])]
    if not chosen or not {"relative", "absolute"} & chosen[-1].keys():
        return Judged(row, None, chosen[-1].get("reason", "") if chosen else "")
    entry = chosen[-1]
    allowed = entry.get("relative", 0) * abs(row.reference) + entry.get("absolute", 0) + 3 * (row.uncertainty or 0)
    return Judged(row, allowed, entry.get("reason", ""))
