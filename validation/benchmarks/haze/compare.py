# SPDX-License-Identifier: AGPL-3.0-or-later
"""Reflected and transmitted part of the incident light; bands are mean cosines."""

from suite.slabs import compare_parts


def compare(runs):
    return compare_parts(runs["case"], "slab_diffuse.csv", lambda row: (row["w"], row["tau"]) == ("0.99", "10.0"), "g",
                         "reflected and transmitted part")
