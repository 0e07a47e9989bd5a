# SPDX-License-Identifier: AGPL-3.0-or-later
"""Runs of a small case, each with another mark in the names of its bands, which all its files hold."""
import subprocess
import time

from .directories import Fault

CASE = """title = "Killed"
[mesh]
max_volume = 0.02
[[mesh.box]]
region = "smoke"
min = [0, 0, 0]
max = [1, 1, 1]
walls = { zmin = "floor" }
[bands]
names = ["mark0x", "mark0y"]
[media.smoke]
absorption = [0.1, 0.2]
scattering = 1.0
[walls.floor]
radiance = [1.0, 0.8]
[walls."*"]
diffuse = 0.5
[directions]
set = "product"
order = 2
[solve]
threads = 1
[[probe]]
name = "middle"
points = [[0.5, 0.5, 0.5]]
[[sensor]]
name = "floor"
kind = "irradiance"
position = [0.5, 0.5, 0.01]
normal = [0, 0, 1]
[[camera]]
name = "view"
position = [0.5, 0.5, 0.9]
look_at = [0.5, 0.5, 0.1]
up = [0, 1, 0]
pixels = [32, 32]
"""
LIMIT = 600  # [s], of one run
MARKS = 5


def write_case(folder):
    """The path of the case file."""
    path = folder / "case.toml"
    path.write_text(CASE, encoding="utf-8")
    return path


class Runs:
    """Starts runs. Each has another mark than the last one."""

    def __init__(self, program, case, saved, options=()):
        self.command = [program, "run", str(case), "--no-estimate", "--progress", "none", *options]
        self.saved = saved
        self.count = 0

    def begin(self, folder, restarts=True, **process):
        self.count += 1
        mark = self.count % MARKS
        options = ["--output", str(folder), "--set", f'bands.names=["mark{mark}x", "mark{mark}y"]']
        if self.count % 2:  # not every run has the same files
            options += ["--set", 'camera[0].name="other"', "--set", 'probe[0].name="other"']
        if restarts and self.count % 3 == 0:
            options += ["--set", f'solve.initial="{self.saved / str(mark) / "solution.vtu"}"']
        return subprocess.Popen(self.command + options, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                text=True, **process)

    def whole(self, folder, restarts=True, **process):
        """Seconds of a run that is not killed."""
        begun = time.monotonic()
        run = self.begin(folder, restarts, **process)
        _, said = run.communicate(timeout=LIMIT)
        if run.returncode not in (0, 1):
            raise Fault(f"a run that was not killed ended with {run.returncode}: {said}")
        return time.monotonic() - begun

    def save_one_of_each(self):
        for _ in range(MARKS):
            self.whole(self.saved / str((self.count + 1) % MARKS), restarts=False)
