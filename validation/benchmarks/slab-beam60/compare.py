# SPDX-License-Identifier: AGPL-3.0-or-later
"""Reflected and transmitted part of the incident light; bands are albedos."""

from suite.slabs import compare_thicknesses


def compare(runs):
    return compare_thicknesses(runs, "slab_beam0.5.csv")
