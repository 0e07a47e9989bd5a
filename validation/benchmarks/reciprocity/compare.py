# SPDX-License-Identifier: AGPL-3.0-or-later
"""Mean fluence in one box from a power of 1 in the other, both ways."""

from suite.row import Row


def compare(runs):
    return [Row("mean fluence, there and back", runs["there"].region("other", "fluence_mean"),
                runs["back"].region("one", "fluence_mean"))]
