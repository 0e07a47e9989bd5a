# SPDX-License-Identifier: AGPL-3.0-or-later
"""The last observed order of the fluence's L2 error, and the error of a linear solution."""

from suite.row import Row


def compare(runs):
    exact = runs["linear"].summary["exact"]
    families = [Row(f"order of fluence, L2, {family}", min(expected, last_order(runs[family])), expected)
                for family, expected in (("jump", 0.5), ("kink", 1.5), ("bend", 2.0))]
    return [Row("order of fluence, L2", min(2.0, last_order(runs["mesh"])), 2.0), *families,
            Row("error of a linear solution, L2", largest(exact), 0.0)]


def last_order(run):
    return [row for row in run.study["rows"] if row["quantity"] == "fluence_L2"][-1]["order"]


def largest(exact):
    """Of all bands."""
    return max(entry["fluence_L2"] for entry in (exact if isinstance(exact, list) else [exact]))
