# SPDX-License-Identifier: AGPL-3.0-or-later
"""The last observed order of the fluence's L2 error, and the error of a linear solution."""

from suite.row import Row


def compare(runs):
    rows = [row for row in runs["mesh"].study["rows"] if row["quantity"] == "fluence_L2"]
    exact = runs["linear"].summary["exact"]
    return [Row("order of fluence, L2", min(2.0, rows[-1]["order"]), 2.0),
            Row("error of a linear solution, L2", largest(exact), 0.0)]


def largest(exact):
    """Of all bands."""
    return max(entry["fluence_L2"] for entry in (exact if isinstance(exact, list) else [exact]))
