# SPDX-License-Identifier: AGPL-3.0-or-later
"""A case with its tables and bands in another order, or with one of its bands alone."""

import copy

# Lists of these keys are places and directions; all others have an entry for each band.
VECTORS = ("position", "direction", "along", "normal", "axis", "points", "size", "walls", "mix", "coefficients")


def permuted(case, draw):
    order = draw.shuffled(range(len(case["bands"]["names"])))
    found = with_bands(case, order)
    for key in ("media", "walls"):
        found[key] = {name: found[key][name] for name in draw.shuffled(found[key])}
    for key in ("light", "probe"):
        if key in found:
            found[key] = draw.shuffled(found[key])
    return {key: found[key] for key in ["title", *draw.shuffled([key for key in found if key != "title"])]}


def with_bands(case, numbers):
    """The case with these bands in this order."""
    found = copy.deepcopy(case)
    found["bands"] = {"names": [case["bands"]["names"][k] for k in numbers]}
    for key in ("media", "walls"):
        found[key] = _chosen(found[key], numbers)
    if "light" in found:
        found["light"] = [_chosen(light, numbers) for light in found["light"]]
    return found


def _chosen(table, numbers):
    found = {}
    for key, value in table.items():
        if isinstance(value, dict):
            value = _chosen(value, numbers)
        elif isinstance(value, list) and key not in VECTORS:
            value = [value[k] for k in numbers]
            value = value if len(value) > 1 else value[0]
        found[key] = value
    return found
