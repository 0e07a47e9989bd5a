# SPDX-License-Identifier: AGPL-3.0-or-later
"""Solutions."""

import base64
import dataclasses
import html
import struct
import zlib

import numpy

from etendue import _etendue


@dataclasses.dataclass(frozen=True)
class Picture:
    """A picture of a camera. Rows begin at the top."""

    radiance: numpy.ndarray  #: (height, width, bands) [power/(length^2 sr)]
    srgb: numpy.ndarray  #: (height, width, 3) 0 to 255, by the camera's exposure and tone

    def png(self):
        """The picture as a file, in bytes."""
        return png(self.srgb)

    def _repr_png_(self):
        return self.png()


class Solution:
    """A solution of a case. Fields are shown, not copied: arrays keep the solution alive and cannot be written to."""

    def __init__(self, found, case):
        self._found = found
        self.case = case  #: as it was solved

    mesh = property(lambda self: self._found.mesh)
    bands = property(lambda self: self._found.bands)
    method = property(lambda self: self._found.method, doc='"gmres", "photons", …')
    converged = property(lambda self: self._found.converged)
    notes = property(lambda self: self._found.notes, doc="Choices that were made, with their reasons.")
    fluence = property(lambda self: self._found.fluence, doc="(cells, 4 vertices, bands) [power/length^2]")
    net_flux = property(lambda self: self._found.net_flux, doc="(cells, 4 vertices, 3, bands) [power/length^2]")
    irradiance = property(lambda self: self._found.irradiance, doc="(boundary faces, 3 vertices, bands), arriving [power/length^2]")
    exitance = property(lambda self: self._found.exitance, doc="(boundary faces, 3 vertices, bands), sent in [power/length^2]")
    iterations = property(lambda self: self._found.iterations(), doc="Sweeps, residual and convergence of each band.")
    balance = property(lambda self: self._found.balances(), doc="Powers of each band [power].")
    walls = property(lambda self: self._found.walls(), doc="Totals of each wall and band.")
    regions = property(lambda self: self._found.regions(), doc="Totals of each region and band.")
    probes = property(lambda self: self._found.probes(), doc="The case's probes, for each point and band.")
    sensors = property(lambda self: self._found.sensors(), doc="The rows of sensors.csv.")

    @property
    def sweeps(self):
        return max((band["sweeps"] for band in self.iterations), default=0)

    def fluence_at(self, points):
        """(points, bands) [power/length^2], as probes read it; NaN outside of the mesh. `points` has shape (n, 3)."""
        return self._found.fluence_at(numpy.atleast_2d(numpy.asarray(points, dtype=float)))

    def render(self, camera):
        """The picture of a camera of the case, by its name."""
        return Picture(*self._found.render(camera))

    def to_pandas(self, table):
        """A table as pandas.DataFrame: "walls", "regions", "probes", "sensors", "balance" or "iterations"."""
        if table not in ("walls", "regions", "probes", "sensors", "balance", "iterations"):
            raise ValueError(f'{table!r}: use "walls", "regions", "probes", "sensors", "balance" or "iterations"')
        import pandas  # not needed otherwise

        return pandas.DataFrame(getattr(self, table))

    def to_vtk(self, file):
        """Writes fields.vtu: fluence, net flux and coefficients in every cell."""
        self._found.write_fields(file)

    def write(self, directory):
        """Writes every file that `etendue run` writes, but pictures."""
        self._found.write(directory)

    def __repr__(self):
        state = "converged" if self.converged else "not converged"
        return f"<etendue.Solution: {self.mesh.cell_count} cells, {', '.join(self.bands)}, {state}>"

    def _repr_html_(self):
        cameras = self.case.get("camera", [])
        image = ""
        if cameras:
            data = base64.b64encode(self.render(cameras[0]["name"]).png()).decode()
            image = f'<img src="data:image/png;base64,{data}" alt="{html.escape(cameras[0]["name"], quote=True)}">'
        return f"<p>{html.escape(repr(self))}</p>{image}{_html_table(self.balance)}"


def _html_table(rows):
    text = "".join(f"<th>{html.escape(key)}</th>" for key in rows[0])
    for row in rows:
        cells = (f"{value:.6g}" if isinstance(value, float) else str(value) for value in row.values())
        text += "</tr><tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in cells)
    return f"<table><tr>{text}</tr></table>"


def png(rgb):
    """Bytes of a PNG of an array (height, width, 3) of bytes (RFC 2083)."""
    height, width, _ = rgb.shape
    rows = numpy.insert(numpy.ascontiguousarray(rgb).reshape(height, 3 * width), 0, 0, axis=1)  # each begins with its filter: none

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows.tobytes())) + chunk(b"IEND", b"")
