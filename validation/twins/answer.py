# SPDX-License-Identifier: AGPL-3.0-or-later
"""All numbers of a run, as those of a twin have to be."""

import dataclasses
import re

import numpy
from differential.values import entries_of

from twins import vtu_arrays

# Quantities of the tables, and the power of the factor of scale that they change with.
TABLES = {"walls": ("wall", {"irradiance_mean": 0, "incoming": 2, "outgoing": 2, "net": 2}),
          "regions": ("region", {"fluence_mean": 0, "absorbed": 2, "emitted": 2}),
          "probes": ("probe", {"fluence": 0, "irradiance": 0})}
# Differences of two quantities are judged by the size of these, of which they are the rest.
SIZES = {"net": "incoming", "net_flux": "fluence in cells"}


@dataclasses.dataclass
class Answer:
    """Numbers by (quantity, band): places, values [place], standard errors [place]."""

    values: dict

    def moved(self, motion):
        """What the case that the motion moved has to answer."""
        powers = {name: power for _, columns in TABLES.values() for name, power in columns.items()}
        found = {}
        for key, (places, values, errors) in self.values.items():
            factor = motion.scale ** powers.get(key[0], 0)
            if key[0] == "net_flux":
                values = values @ motion.matrix.T
            found[key] = (places, factor * values, factor * errors)
        return Answer(found)

    def band(self, name):
        return Answer({key: entry for key, entry in self.values.items() if key[1] == name})

    def plus(self, other):
        return Answer({key: (places, values + other.values[key][1], numpy.hypot(errors, other.values[key][2]))
                       for key, (places, values, errors) in self.values.items()})

    def size(self, key):
        """Of a quantity in a band: the largest value of any place."""
        _, values, _ = self.values.get((SIZES.get(key[0], key[0]), key[1])) or self.values[key]
        return float(numpy.abs(values).max(initial=0))


def read(result, mesh=None):
    """The answer of a run; fluence and flux of each cell with it, where its mesh is given."""
    found = {}
    for name, where, quantity, row, value in entries_of(result, TABLES):
        key = (quantity if name != "probe" else f"{quantity} at probes", row["band"])
        found.setdefault(key, {})[where] = value
    found = {key: _sorted(entry) for key, entry in found.items()}
    return Answer(found | (_fields(result, mesh) if mesh else {}))


def _sorted(entry):
    places = sorted(entry)
    return numpy.array(places), *(numpy.array([entry[place][k] for place in places]) for k in (0, 1))


def _fields(result, mesh):
    arrays, bands = vtu_arrays.read(result.folder / "fields.vtu"), result.bands
    vertices = arrays["connectivity"].reshape(-1, 4)
    corners = arrays["points"][vertices]
    places = numpy.array([f"cell {k}" for k in range(len(corners))])
    fluence = mesh.by_label(corners, arrays["fluence"].reshape(-1, len(bands))[vertices])
    found = {("fluence in cells", band): (places, fluence[:, :, k], numpy.zeros((len(places), 4))) for k, band in enumerate(bands)}
    for name, values in arrays.items():
        match = re.fullmatch(r"net_flux_?(.*)", name)
        if match:
            values = mesh.by_label(corners, values[vertices])
            found["net_flux", match[1] or bands[0]] = (places, values, numpy.zeros(values.shape))
    return found
