# SPDX-License-Identifier: AGPL-3.0-or-later
"""The last observed order of the fluence's L2 error, and the error of a linear solution."""

from suite.row import Row


def compare(runs):
    smooth = runs["mesh"]
    exact = runs["linear"].summary["exact"]
    families = [Row(f"order of fluence, L2, {family}", min(expected, last_order(runs[family])), expected)
                for family, expected in (("jump", 0.5), ("kink", 1.5), ("bend", 2.0))]
    return [Row("order of fluence, L2", min(2.0, last_order(smooth)), 2.0),
            Row("order of means of cells, L2", min(2.0, last_order(smooth, "fluence_mean_L2")), 2.0),
            Row("order of what is absorbed", min(3.0, last_order(smooth, "region:medium:absorbed")), 3.0),
            Row("order of fluence, L2, constant elements", min(1.0, last_order(runs["constant"])), 1.0),
            Row("order of fluence, L2, directions", min(4.0, last_order(runs["directions"])), 4.0), *families,
            Row("error of a linear solution, L2", largest(exact), 0.0)]


def last_order(run, quantity="fluence_L2"):
    order = [row for row in run.study["rows"] if row["quantity"] == quantity][-1]["order"]
    if order is None:
        raise ValueError(f"{run.name}: the iteration errs by more than a tenth of the error of {quantity}")
    return order


def largest(exact):
    """Of all bands."""
    return max(entry["fluence_L2"] for entry in (exact if isinstance(exact, list) else [exact]))
