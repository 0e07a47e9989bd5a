# SPDX-License-Identifier: AGPL-3.0-or-later
"""An error in one of two twins: all that shines is stronger by a part."""

import copy

STRENGTHS = ("radiance", "irradiance", "power", "emission", "power_density")


def stronger(case, part):
    found = copy.deepcopy(case)
    walls = found["walls"].values()
    for entry in [*found["media"].values(), *walls, *(wall["beam"] for wall in walls if "beam" in wall), *found.get("light", [])]:
        for key in STRENGTHS:
            if key in entry:
                entry[key] = _times(entry[key], 1 + part)
    return found


def _times(value, factor):
    if isinstance(value, list):
        return [_times(entry, factor) for entry in value]
    return f"{factor!r} * ({value})" if isinstance(value, str) else factor * value
