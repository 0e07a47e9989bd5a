# SPDX-License-Identifier: AGPL-3.0-or-later
"""Power absorbed by each region beside photons."""

from suite.result import read_reference
from suite.row import Row


def compare(runs):
    return [Row(f"{name}: {row['region']}", result.region(row["region"], "absorbed"), float(row["absorbed"]), float(row["sd"]))
            for name, result in runs.items() for row in read_reference("tissue.csv")]
