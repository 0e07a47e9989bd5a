# SPDX-License-Identifier: AGPL-3.0-or-later
"""A case that is solved in a moment."""

import pathlib

TEXT = (pathlib.Path(__file__).parent.parent / "app/api/small_case.toml").read_text(encoding="utf-8")
