# SPDX-License-Identifier: AGPL-3.0-or-later
"""Reflected and transmitted part of the incident light; bands are albedos."""

from suite.slabs import compare_parts

def compare(runs):
    return compare_parts(runs["case"], "slab_diffuse.csv", lambda row: (row["g"], row["tau"]) == ("0.5", "2.0"), "w",
                         "reflected and transmitted part")
