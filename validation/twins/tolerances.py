# SPDX-License-Identifier: AGPL-3.0-or-later
"""How much the answers of twins may differ, as a part of the largest value of the quantity in the scene, and why."""

SOLVE = 1e-9  # of every run
# The discrete equations of twins are the same: they differ by the error of the iteration, and rounding.
ITERATION = 10 * SOLVE
# Light along rays is integrated by rules that take corners of cells and lamps in their order, and pieces until errors are below
# 1e-3 of a face (docs/user/lights.md): a moved lamp takes other points. Also allowed to the balance by etendue-differential.
RAYS = 5e-3
# Standard errors of the difference of two runs of photons: beyond are 4e-8 of all values.
PHOTONS = 5.5
# Estimated errors of two runs that differ in cells, directions or rays, as in etendue-differential.
ERRORS = 4
