# SPDX-License-Identifier: AGPL-3.0-or-later
"""What etendue-validate is made of: benchmarks, their runs, the comparison and the report."""
