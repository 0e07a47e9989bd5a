# SPDX-License-Identifier: AGPL-3.0-or-later
"""Cases of a scene with an error that the comparison has to notice, by what is wrong in them."""

import copy

from differential.case_text import case_text as text_of

FACTOR = 1.05     # of the scattering coefficient, with the absorption as it is
ASYMMETRY = 0.1   # less than g of every Henyey-Greenstein phase function


def case_text(scene, error):
    case = copy.deepcopy(scene.case)
    for medium in case["media"].values():
        ERRORS[error](medium)
    return text_of(case)


def _scatter_more(medium):
    if "albedo" in medium:
        extinction, albedo = _lists(medium.pop("extinction"), medium.pop("albedo"))
        medium["absorption"] = _entry([e * (1 - a) for e, a in zip(extinction, albedo)])
        medium["scattering"] = _entry([FACTOR * e * a for e, a in zip(extinction, albedo)])
    for key in ("kernel", "scattering"):
        if isinstance(medium.get(key), str):
            medium[key] = f"{FACTOR} * {medium[key]}"


def _deflect_more(medium):
    if medium.get("phase", {}).get("model") == "henyey-greenstein":
        medium["phase"]["g"] -= ASYMMETRY


ERRORS = {"scattering": _scatter_more, "asymmetry": _deflect_more}


def _lists(first, second):
    """Numbers or lists of numbers for each band as lists of one length."""
    bands = max(len(value) if isinstance(value, list) else 1 for value in (first, second))
    return [value if isinstance(value, list) else [value] * bands for value in (first, second)]


def _entry(values):
    return values[0] if len(values) == 1 else values
