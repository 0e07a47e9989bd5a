# SPDX-License-Identifier: AGPL-3.0-or-later
"""The part of the light that leaves the cylinder."""

from suite.row import Row


def compare(runs):
    gas = runs["case"]
    escaped = 1 - gas.region("gas", "absorbed") / gas.region("gas", "emitted")
    return [Row("escape probability", escaped, 0.914256, 2.4e-5)]
