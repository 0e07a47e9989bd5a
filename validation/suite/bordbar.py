# SPDX-License-Identifier: AGPL-3.0-or-later
"""Gray gases of Bordbar, Wecel and Hyppanen (2014) for twice as much water vapour as carbon dioxide."""

import math

import numpy

MOLAR_RATIO = 2.0
STEFAN_BOLTZMANN = 5.670374419e-8
# By power of the molar ratio (first index), gas, power of T/1200 K: to seven decimals, from another code than those of the solver.
WEIGHT = numpy.array([
    [[0.7412956, -0.9412652, 0.8531866, -0.3342806, 0.0431436], [0.1552073, 0.6755648, -1.1253940, 0.6040543, -0.1105453],
     [0.2550242, -0.6065428, 0.8123855, -0.4532290, 0.0869309], [-0.0345199, 0.4112046, -0.5055995, 0.2317509, -0.0375491]],
    [[-0.5244441, 0.2799577, 0.0823075, 0.1474987, -0.0688622], [-0.4862117, 1.4092710, -0.5913199, -0.0553385, 0.0464663],
     [0.3805403, 0.3494024, -1.1020090, 0.6784475, -0.1306996], [0.2656726, -0.5728350, 0.4579559, -0.1656759, 0.0229520]],
    [[0.5822860, -0.7672319, 0.5289430, -0.4160689, 0.1109773], [0.3668088, -1.3834490, 0.9085441, -0.1733014, -0.0016129],
     [-0.4249709, 0.1853509, 0.4046178, -0.3432603, 0.0741446], [-0.1225365, 0.2924490, -0.2616436, 0.1052608, -0.0160047]],
    [[-0.2096994, 0.3204027, -0.2468463, 0.1697627, -0.0420861], [-0.1055508, 0.4575210, -0.3334201, 0.0791608, -0.0035398],
     [0.1429446, -0.1013694, -0.0811822, 0.0883088, -0.0202929], [0.0300151, -0.0798076, 0.0764841, -0.0321935, 0.0050463]],
    [[0.0242031, -0.0391017, 0.0310940, -0.0204066, 0.0049188], [0.0105857, -0.0501976, 0.0384236, -0.0098934, 0.0006121],
     [-0.0157408, 0.0130244, 0.0062981, -0.0084152, 0.0020110], [-0.0028205, 0.0079966, -0.0079084, 0.0033870, -0.0005364]]])
# By gas, power of the molar ratio [1/(m atm)].
ABSORPTION = numpy.array([
    [0.0340429, 0.0652305, -0.0463685, 0.0138684, -0.0014450], [0.3509457, 0.7465138, -0.5293090, 0.1594423, -0.0166326],
    [4.5707400, 2.1680670, -1.4989010, 0.4917165, -0.0542999], [109.81690, -50.923590, 23.432360, -5.1638920, 0.4393889]])
POWERS = MOLAR_RATIO ** numpy.arange(5)


def blackbody(kelvin, gas):
    """Radiance of a blackbody that a gas has; the clear gas, number 0, has what the others leave."""
    weights = numpy.einsum("k,kgj,j...->g...", POWERS, WEIGHT, numpy.array([(kelvin / 1200) ** j for j in range(5)]))
    weight = 1 - weights.sum(axis=0) if gas == 0 else weights[gas - 1]
    return weight * STEFAN_BOLTZMANN * kelvin ** 4 / math.pi


def absorption(gas):
    """By the partial pressure of both [1/(m atm)]."""
    return 0.0 if gas == 0 else float(ABSORPTION[gas - 1] @ POWERS)
