# SPDX-License-Identifier: AGPL-3.0-or-later
"""Powers absorbed and fluence beside the capsule; of a quarter, 0.02 thick, made those of the whole, 1 thick."""

from suite.result import read_reference
from suite.row import Row

WHOLE = 4 / 0.3


def compare(runs):
    h = runs["case"]
    computed = {
        "absorption capsule (": WHOLE * (h.region("capsule", "absorbed") + h.region("core", "absorbed")),
        "absorption capsule core": WHOLE * h.region("core", "absorbed"),
        "absorption top and bottom walls": WHOLE * h.region("top", "absorbed"),
        "phi mean in 0.05x0.05 box": h.region("probe", "fluence_mean"),
        "total outflow": WHOLE * (h.wall("xmax", "incoming") + h.wall("ymax", "incoming")),
        "total inflow": WHOLE * h.wall("xmax", "outgoing"),
    }
    found = []
    for row in read_reference("hohlraum.csv"):
        value = next(value for start, value in computed.items() if row["quantity"].startswith(start))
        exact = row["sd"] == "exact"
        found.append(Row(row["quantity"], value, float(row["value"]), 5e-7 if exact else float(row["sd"])))
    return found
