# SPDX-License-Identifier: AGPL-3.0-or-later
"""Random geometries that are hard to mesh, and the judgment of what the program makes of them."""
