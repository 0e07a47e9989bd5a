# SPDX-License-Identifier: AGPL-3.0-or-later
"""What a slab behind two smooth surfaces absorbs of diffuse light, lets through, and emits.

With the cosine mu inside, Fresnel's reflectance R(mu) and e = exp(-tau/mu), light that has entered passes the slab again and again,
1 - e of it absorbed each time and R of the rest turned back. Of the incident power are

    absorbed  integral of 2 n^2 mu (1 - R)(1 - e)/(1 - R e) dmu,    outflow  integral of 2 n^2 mu (1 - R)^2 e/(1 - R e) dmu

over the cone mu > sqrt(1 - 1/n^2) that is not reflected totally. A slab that emits tau in all, so the radiance 1/(4 pi) in the thick
limit, loses half of the first through its two faces, without the n^2 (Kirchhoff)."""

import numpy

from suite.row import Row

NODES = 400


def fresnel(mu, n):
    """Reflectance of unpolarised light inside at the cosine mu above the critical one."""
    behind = numpy.sqrt(1 - n ** 2 * (1 - mu ** 2))
    across, along = (n * mu - behind) / (n * mu + behind), (mu - n * behind) / (mu + n * behind)
    return (across ** 2 + along ** 2) / 2


def powers(n, tau):
    """Absorbed and leaving parts of the incident light. 1 - R begins like a root: mu = c + (1 - c) t^2 takes it away."""
    t, weight = numpy.polynomial.legendre.leggauss(NODES)
    t, weight = (1 + t) / 2, weight / 2
    critical = numpy.sqrt(1 - 1 / n ** 2)
    mu = critical + (1 - critical) * t ** 2
    weight = weight * 2 * t * (1 - critical)
    r, e = fresnel(mu, n), numpy.exp(-tau / mu)
    enters = 2 * n ** 2 * mu * (1 - r) / (1 - r * e) * weight
    return float(numpy.sum(enters * (1 - e))), float(numpy.sum(enters * (1 - r) * e))


def compare(runs):
    rows = []
    for result in runs.values():
        name, n = (part.removeprefix("index ") for part in result.name.split(", "))
        photons = result.summary.get("photons")
        for k, band in enumerate(result.bands):
            kind, tau = band.split()
            absorbed, outflow = powers(float(n), float(tau))
            balance = result.summary["balance"][k]
            error = photons["balance_error"][k] if photons else {"absorbed": None, "outflow": None}
            where = f"n = {n}, tau = {tau}, {name}, {kind}"
            if kind == "hot":
                rows.append(Row(f"emitted and leaving, {where}", balance["outflow"], absorbed / float(n) ** 2 / 2, error["outflow"]))
                continue
            plot = {"plot": "absorbed part, n = 1.5", "curve": name, "x": float(tau)} if n == "1.5" else {}
            rows.append(Row(f"absorbed part, {where}", balance["absorbed"], absorbed, error["absorbed"], **plot))
            rows.append(Row(f"leaving part, {where}", balance["outflow"], outflow, error["outflow"]))
    return rows
