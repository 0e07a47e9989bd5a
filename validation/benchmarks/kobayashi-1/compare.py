# SPDX-License-Identifier: AGPL-3.0-or-later
"""Fluence at the points of the benchmark's lines."""

from suite.kobayashi import compare  # noqa: F401
