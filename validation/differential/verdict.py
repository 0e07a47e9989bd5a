# SPDX-License-Identifier: AGPL-3.0-or-later
"""Whether the methods agree, scene by scene and over all of them."""

import dataclasses
import statistics

BEYOND = 4        # units: a difference that errors do not explain
SHARE = 0.01      # of all values may be beyond, since errors are estimates
LIMIT = 8         # units: none may be beyond
# Of all values so many may have a wide bar: with more the comparison says little. With 1e6 photons they are 19 %, with 1e5 29 %.
WIDE_SHARE = {"full": 0.25, "quick": 0.35}


@dataclasses.dataclass
class Outcome:
    """The comparison of one scene: values, and the faults of its runs."""

    scene: object
    rows: list
    faults: list
    seconds: float

    @property
    def beyond(self):
        return [row for row in self.rows if abs(row.units) > BEYOND]

    def print(self, verbose):
        worst = max((abs(row.units) for row in self.rows), default=0)
        state = "ok" if not self.beyond and not self.faults else "look"
        title = self.scene.case["title"].partition(": ")[2]
        print(f"seed {self.scene.seed:4} {state:6} {len(self.beyond)} of {len(self.rows)} values beyond {BEYOND} units, "
              f"worst {worst:.1f}, median {median_units(self.rows):.2f}, {self.seconds:.1f} s  {title}", flush=True)
        for text in self.faults:
            print(f"    {text}")
        for row in self.rows if verbose else self.beyond:
            print("    " + row_text(row))


def row_text(row):
    return (f"{row.where:20} {row.quantity:12} {row.band:6} {row.method} {row.first:.5g}, photons {row.second:.5g}: "
            f"{row.units:+.1f} units (noise {row.noise:.1e}, mesh {row.mesh:.1e}, directions {row.directions:.1e})")


def median_units(rows):
    return statistics.median(abs(row.units) for row in rows) if rows else 0.0


def rows_of(outcomes):
    return [row for outcome in outcomes for row in outcome.rows]


def faults_of(outcomes):
    """Faults of the runs, and scenes of which nothing was compared."""
    return [fault for outcome in outcomes for fault in outcome.faults or ([] if outcome.rows else ["nothing compared"])]


def differ(rows):
    """Whether errors do not explain the differences."""
    beyond = sum(abs(row.units) > BEYOND for row in rows)
    return beyond > SHARE * len(rows) or max((abs(row.units) for row in rows), default=0) > LIMIT


def agrees(outcomes, seconds, full):
    """Prints the last lines and returns whether the set passes."""
    rows, faults = rows_of(outcomes), faults_of(outcomes)
    beyond, wide = sum(abs(row.units) > BEYOND for row in rows), sum(row.wide for row in rows)
    percent = 100 / max(1, len(rows))
    print(f"{len(outcomes)} scenes, {len(rows)} values, {seconds:.0f} s: {beyond} beyond {BEYOND} units "
          f"({percent * beyond:.2f} %), median {median_units(rows):.2f} units, {percent * wide:.1f} % with a bar above 3 %, "
          f"{len(faults)} faults")
    allowed = WIDE_SHARE["full" if full else "quick"]
    passed = not faults and not differ(rows) and wide <= allowed * len(rows)
    print(f"{'PASS' if passed else 'FAIL'}: allowed are {100 * SHARE:g} % beyond {BEYOND} units, none beyond {LIMIT}, "
          f"{100 * allowed:g} % with a bar above 3 %, and no fault")
    return passed


def notices(outcomes, error):
    """Prints and returns whether runs that went well differ by the planted error."""
    noticed = not faults_of(outcomes) and differ(rows_of(outcomes))
    print(f"{'PASS: the' if noticed else 'FAIL: no'} planted error of the {error} is noticed")
    return noticed
