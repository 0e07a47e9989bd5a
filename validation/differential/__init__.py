# SPDX-License-Identifier: AGPL-3.0-or-later
"""Random scenes solved by ordinates, photons and radiosity, and the comparison of their results."""
