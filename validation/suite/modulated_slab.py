# SPDX-License-Identifier: AGPL-3.0-or-later
"""Modulated light in a slab, by eigenvectors of double-Gauss ordinates with a complex extinction."""

import numpy


def parts(rate, albedo, thickness, angles=32):
    """R and T as complex numbers: of light that enters alike from all directions of a half space and changes as
    exp(rate t), with sigma_t = c = 1 and isotropic scattering.

    mu du/dz + (1 + rate) u = albedo / 2 sum of w u has the solutions v exp(lambda z), with the eigenvectors of
    (albedo / 2 1 w^T - (1 + rate)) / mu. Each is scaled to be 1 where it is largest, and they fit the light that enters.
    """
    nodes, weights = numpy.polynomial.legendre.leggauss(angles)
    mu, w = (nodes + 1) / 2, weights / 2
    both, pair = numpy.concatenate([mu, -mu]), numpy.concatenate([w, w])
    matrix = (albedo / 2 * numpy.ones((2 * angles, 1)) * pair - (1 + rate) * numpy.eye(2 * angles)) / both[:, None]
    values, vectors = numpy.linalg.eig(matrix)
    at_start = numpy.exp(-numpy.where(values.real > 0, values, 0) * thickness)
    at_end = numpy.exp(numpy.where(values.real > 0, 0, values) * thickness)
    entering = numpy.concatenate([vectors[:angles] * at_start, vectors[angles:] * at_end])
    amplitudes = numpy.linalg.solve(entering, numpy.concatenate([numpy.ones(angles), numpy.zeros(angles)]))
    back = vectors[angles:] @ (at_start * amplitudes)
    through = vectors[:angles] @ (at_end * amplitudes)
    flux = (mu * w).sum()
    return {"R": (mu * w) @ back / flux, "T": (mu * w) @ through / flux}
