# SPDX-License-Identifier: AGPL-3.0-or-later
"""Solutions."""

import base64
import dataclasses
import html
import importlib
import os
import struct
import zlib
from typing import Any

import numpy
from numpy.typing import ArrayLike, NDArray

from etendue import _etendue
from etendue.case import Case

Rows = list[dict[str, Any]]

TABLES = ("walls", "regions", "heat", "probes", "sensors", "balance", "iterations")


@dataclasses.dataclass(frozen=True)
class Picture:
    """A picture of a camera. Rows begin at the top."""

    radiance: NDArray[numpy.float64]  #: (height, width, bands) [power/(length^2 sr)]
    srgb: NDArray[numpy.uint8]  #: (height, width, 3) 0 to 255, by the camera's exposure and tone

    def png(self) -> bytes:
        """The picture as a file, in bytes."""
        return png(self.srgb)

    def _repr_png_(self) -> bytes:
        return self.png()


class Solution:
    """A solution of a case. Fields are shown, not copied: arrays keep the solution alive and cannot be written to."""

    def __init__(self, found: _etendue.Solution, case: Case) -> None:
        self._found = found
        self.case = case  #: as it was solved

    @property
    def mesh(self) -> _etendue.Mesh:
        return self._found.mesh

    @property
    def bands(self) -> list[str]:
        return self._found.bands

    @property
    def method(self) -> str:
        """"gmres", "photons", …"""
        return self._found.method

    @property
    def converged(self) -> bool:
        return self._found.converged

    @property
    def notes(self) -> list[str]:
        """Choices that were made, with their reasons."""
        return self._found.notes

    @property
    def fluence(self) -> NDArray[numpy.float64]:
        """(cells, 4 vertices, bands) [power/length^2]"""
        return self._found.fluence

    @property
    def net_flux(self) -> NDArray[numpy.float64]:
        """(cells, 4 vertices, 3, bands) [power/length^2]"""
        return self._found.net_flux

    @property
    def irradiance(self) -> NDArray[numpy.float64]:
        """(boundary faces, 3 vertices, bands), arriving [power/length^2]"""
        return self._found.irradiance

    @property
    def exitance(self) -> NDArray[numpy.float64]:
        """(boundary faces, 3 vertices, bands), sent in [power/length^2]"""
        return self._found.exitance

    @property
    def cell_temperature(self) -> NDArray[numpy.float64]:
        """(cells,) at centroids [K]; 0 where there is none."""
        return self._found.cell_temperature()

    @property
    def wall_temperature(self) -> NDArray[numpy.float64]:
        """(boundary faces, 3 vertices) [K]; 0 where there is none."""
        return self._found.wall_temperature()

    @property
    def iterations(self) -> Rows:
        """Sweeps, residual and convergence of each band."""
        return self._found.iterations()

    @property
    def balance(self) -> Rows:
        """Powers of each band [power]."""
        return self._found.balances()

    @property
    def walls(self) -> Rows:
        """Totals of each wall and band."""
        return self._found.walls()

    @property
    def regions(self) -> Rows:
        """Totals of each region and band."""
        return self._found.regions()

    @property
    def heat(self) -> Rows:
        """Heat of each wall and region [W], and mean temperatures [K]."""
        return self._found.heat()

    @property
    def probes(self) -> Rows:
        """The case's probes, for each point and band."""
        return self._found.probes()

    @property
    def sensors(self) -> Rows:
        """The rows of sensors.csv."""
        return self._found.sensors()

    @property
    def sweeps(self) -> int:
        return max((band["sweeps"] for band in self.iterations), default=0)

    def fluence_at(self, points: ArrayLike) -> NDArray[numpy.float64]:
        """(points, bands) [power/length^2], as probes read it; NaN outside of the mesh. `points` has shape (n, 3)."""
        return self._found.fluence_at(numpy.atleast_2d(numpy.asarray(points, dtype=float)))

    def render(self, camera: str) -> Picture:
        """The picture of a camera of the case, by its name."""
        return Picture(*self._found.render(camera))

    def to_pandas(self, table: str) -> Any:
        """A table as pandas.DataFrame: "walls", "regions", "heat", "probes", "sensors", "balance" or "iterations"."""
        if table not in TABLES:
            raise ValueError(f"{table!r}: use one of {', '.join(TABLES)}")
        pandas = importlib.import_module("pandas")  # not needed otherwise
        return pandas.DataFrame(getattr(self, table))

    def to_vtk(self, file: str | os.PathLike[str]) -> None:
        """Writes fields.vtu: fluence, net flux and coefficients in every cell."""
        self._found.write_fields(file)

    def write(self, directory: str | os.PathLike[str]) -> None:
        """Writes every file that `etendue run` writes, but pictures."""
        self._found.write(directory)

    def __repr__(self) -> str:
        state = "converged" if self.converged else "not converged"
        return f"<etendue.Solution: {self.mesh.cell_count} cells, {', '.join(self.bands)}, {state}>"

    def _repr_html_(self) -> str:
        cameras = self.case.get("camera", [])
        image = ""
        if cameras:
            data = base64.b64encode(self.render(cameras[0]["name"]).png()).decode()
            image = f'<img src="data:image/png;base64,{data}" alt="{html.escape(cameras[0]["name"], quote=True)}">'
        return f"<p>{html.escape(repr(self))}</p>{image}{_html_table(self.balance)}"


def _html_table(rows: Rows) -> str:
    text = "".join(f"<th>{html.escape(key)}</th>" for key in rows[0])
    for row in rows:
        cells = (f"{value:.6g}" if isinstance(value, float) else str(value) for value in row.values())
        text += "</tr><tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in cells)
    return f"<table><tr>{text}</tr></table>"


def png(rgb: NDArray[numpy.uint8]) -> bytes:
    """Bytes of a PNG of an array (height, width, 3) of bytes (RFC 2083)."""
    height, width, _ = rgb.shape
    rows = numpy.insert(numpy.ascontiguousarray(rgb).reshape(height, 3 * width), 0, 0, axis=1)  # each begins with its filter: none

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows.tobytes())) + chunk(b"IEND", b"")
