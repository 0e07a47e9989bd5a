# SPDX-License-Identifier: AGPL-3.0-or-later
"""The case of a scene with an error that the comparison has to notice: scattering is multiplied by FACTOR."""

import copy

from differential.case_text import case_text as text_of

FACTOR = 1.05


def case_text(scene):
    case = copy.deepcopy(scene.case)
    for medium in case["media"].values():
        _scale(medium)
    return text_of(case)


def _scale(medium):
    """More scattering, the same absorption."""
    if "albedo" in medium:
        extinction, albedo = _lists(medium.pop("extinction"), medium.pop("albedo"))
        medium["absorption"] = _entry([e * (1 - a) for e, a in zip(extinction, albedo)])
        medium["scattering"] = _entry([FACTOR * e * a for e, a in zip(extinction, albedo)])
    for key in ("kernel", "scattering"):
        if isinstance(medium.get(key), str):
            medium[key] = f"{FACTOR} * {medium[key]}"


def _lists(first, second):
    """Numbers or lists of numbers for each band as lists of one length."""
    bands = max(len(value) if isinstance(value, list) else 1 for value in (first, second))
    return [value if isinstance(value, list) else [value] * bands for value in (first, second)]


def _entry(values):
    return values[0] if len(values) == 1 else values
