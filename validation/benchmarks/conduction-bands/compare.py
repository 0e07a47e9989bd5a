# SPDX-License-Identifier: AGPL-3.0-or-later
"""The temperature by finite volumes (suite.heated_slab)."""

from suite import bordbar, planck
from suite.emitting_slab import HEIGHTS
from suite.heated_slab import Slab, extrapolated
from suite.row import Row

SOURCE = 30000.0  # [W/m^3]
EDGES = {"short": (1e-9, 3e-6), "long": (3e-6, 1.0)}  # [m]


def values(slab):
    radiated, conducted = slab.radiated(), slab.conducted()
    found = {"heat flux into zmin": -radiated[0], "heat flux into zmax": radiated[-1],
             "conducted into zmin": -conducted[0], "conducted into zmax": conducted[-1]}
    if slab.cooling:
        found["temperature of zmax"] = slab.kelvin[-1]
    for b, band in enumerate(slab.bands):
        fluence = band.fluence @ band.blackbody(slab.kelvin)
        found |= {f"fluence at {z:g} m, {b}": fluence[round(z * (len(fluence) - 1))] for z in HEIGHTS}
    return found


def exact(gases, conductivity, cooling):
    """Errors are of second order in the width of the cells."""
    return extrapolated(*(values(Slab(gases, conductivity, cooling, SOURCE, cells).solve()) for cells in (60, 120)))


TWO_BANDS = [(kappa, lambda kelvin, band=band: planck.radiance(kelvin, *EDGES[band])) for band, kappa in (("short", 0.5), ("long", 4.0))]
FLUE_GAS = [(0.3 + 0.3 * bordbar.absorption(gas), lambda kelvin, gas=gas: bordbar.blackbody(kelvin, gas)) for gas in range(5)]
COOLING = {"h": 200.0, "ambient": 300.0, "heat_flux": 5000.0}
CASES = {  # bands, conductivity [W/(m K)], what cools the upper plate
    "two bands": (TWO_BANDS, 0.0, None),
    "flue gas": (FLUE_GAS, 20.0, None),
    "cooled plate": (TWO_BANDS, 20.0, COOLING),
}


def compare(runs):
    found = []
    for name, (gases, conductivity, cooling) in CASES.items():
        result, wanted = runs[name], exact(gases, conductivity, cooling)
        for key, reference in wanted.items():
            if conductivity or not key.startswith("conducted"):
                found.append(Row(f"{key}, {name}", value_of(result, key), reference))
    return found


def value_of(result, key):
    if key.startswith("heat flux"):
        return result.heat(key.split()[-1], "density")
    if key.startswith("temperature"):
        return result.heat(key.split()[-1], "temperature")
    if key.startswith("conducted"):
        return result.heat(key.split()[-1], "conducted")
    height, band = key.removeprefix("fluence at ").split(" m, ")
    return result.at((0.5, 0.5, float(height)), result.bands[int(band)])["fluence"]
