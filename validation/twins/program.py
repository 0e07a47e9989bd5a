# SPDX-License-Identifier: AGPL-3.0-or-later
"""Runs of the program."""

import subprocess
import time

from differential.case_text import case_text
from suite.result import Result

from twins import grid


FIRST = "first"


class Failed(Exception):
    """A run that did not end, or not well."""


class TooSlow(Exception):
    """A run beyond the limit of time."""


class Program:
    """The program with a folder for what it reads and writes, and the tables beside a case.

    Runs named FIRST are those of the scene itself. `known` are their results by the text of the case, or the errors that ended
    them: one run for all twins."""

    def __init__(self, path, folder, files, limit, known):
        self.path = path
        self.folder = folder
        self.limit = limit
        self.known = known
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in files.items():
            (folder / name).write_text(text, encoding="utf-8")

    def mesh(self, case):
        """The mesh of the primitives of a case."""
        path = self.write("primitives", case)
        output = self.folder / "mesh.vtu"
        self._call(["mesh", str(path), "-o", str(output)], "mesh", (0,))
        return grid.read(output)

    def on_grid(self, name, case, mesh):
        """The result of a case on a finished mesh in place of its primitives."""
        mesh.write(self.folder / f"{name}.msh")
        return self.run(name, case | {"mesh": {"file": f"{name}.msh"}})

    def run(self, name, case, options=("--no-estimate",)):
        text = case_text(case)
        if name != FIRST:
            return self._result(name, case, options)
        if text not in self.known:
            try:
                self.known[text] = self._result(name, case, options)
            except (Failed, TooSlow) as error:
                self.known[text] = error
        if isinstance(self.known[text], Exception):
            raise self.known[text]
        return self.known[text]

    def _result(self, name, case, options):
        path, output = self.write(name, case), self.folder / name
        started = time.monotonic()
        self._call(["run", str(path), *options, "--output", str(output), "--progress", "none"], name, (0, 1))
        result = Result(name, output, time.monotonic() - started)
        if not result.summary["converged"]:
            raise Failed(f"{name}: not converged")
        return result

    def write(self, name, case):
        path = self.folder / f"{name}.toml"
        path.write_text(case_text(case), encoding="utf-8")
        return path

    def _call(self, arguments, name, allowed):
        try:
            done = subprocess.run([str(self.path), *arguments], check=False, capture_output=True, text=True, timeout=self.limit)
        except subprocess.TimeoutExpired as error:
            raise TooSlow(f"{name}: more than {self.limit:g} s") from error
        if done.returncode not in allowed:
            lines = (done.stderr or done.stdout).strip().splitlines() or [""]
            raise Failed(f"{name}: exit code {done.returncode}: {lines[-1]}")
