# SPDX-License-Identifier: AGPL-3.0-or-later
"""Pairs of cases whose answers must be the same, or follow from each other, and the comparison of their results."""
