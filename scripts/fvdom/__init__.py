# SPDX-License-Identifier: AGPL-3.0-or-later
"""The comparison of scripts/compare_fvdom: scenes, exact fluxes, meshes, runs of both programs, and tables."""
