# SPDX-License-Identifier: AGPL-3.0-or-later
"""The mesh of a geometry by the program, and what is wrong with its end or its volumes."""

import dataclasses
import math
import os
import re
import resource
import signal
import subprocess
import threading

from geometry.scene import SNAP

PATIENCE = 20      # times the limit, on the clock: for what waits, or a machine with much other work
DEVIATIONS = 7     # standard errors of a volume by lines
DIGITS = 1e-5      # relative: volumes are printed with six digits
MESHED, REFUSED, SLOW, FAULT = "meshed", "refused", "slow", "FAULT"


@dataclasses.dataclass
class Outcome:
    scene: object
    state: str
    seconds: float   # of the processor, children included
    cells: int = 0
    text: str = ""


def judge(scene, folder, options):
    """Writes the case, meshes it and returns the outcome."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in {"case.toml": scene.text, **scene.files}.items():
        (folder / name).write_text(text, encoding="utf-8")
    command = [str(options.program), "check", "--mesh", "case.toml"]
    code, seconds, out, err = _run(command, folder, options.limit)
    if code in (-signal.SIGKILL, -signal.SIGXCPU) or seconds > options.limit:
        return Outcome(scene, SLOW, seconds, _cells(out), _message(err))
    if code == 2:
        return Outcome(scene, REFUSED if _names_place(_message(err)) else FAULT, seconds, 0, _message(err))
    if code != 0:
        return Outcome(scene, FAULT, seconds, 0, f"exit code {code}: {_message(err)}")
    wrong = _wrong_volumes(scene, _regions(out))
    return Outcome(scene, FAULT if wrong else MESHED, seconds, _cells(out), wrong)


def _run(command, folder, limit):
    """Exit code, seconds of the processor, standard output and error. The limit holds for each process."""
    most = (int(limit) + 1, resource.RLIM_INFINITY)
    with open(folder / "out", "w+", encoding="utf-8") as out, open(folder / "err", "w+", encoding="utf-8") as err:
        process = subprocess.Popen(command, cwd=folder, stdout=out, stderr=err, start_new_session=True,
                                   preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, most))
        timer = threading.Timer(PATIENCE * limit, os.killpg, (process.pid, signal.SIGKILL))
        timer.start()
        _, status, usage = os.wait4(process.pid, 0)
        timer.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        err.seek(0)
        return process.returncode, usage.ru_utime + usage.ru_stime, out.read(), err.read()


def _message(err):
    return " ".join(line.strip() for line in err.splitlines() if not re.match(r" *[a-z]+: \d+ s so far", line))


def _names_place(message):
    """Whether a refusal names the line of the case, a file beside it or a place."""
    place = r"\([-+.e\d]+, [-+.e\d]+, [-+.e\d]+\)"
    return bool(re.search(r"\.toml:\d+|\w\.(stl|obj|off|ply|smesh|vti)|" + place, message))


def _cells(out):
    found = re.search(r"^(\d+) cells,", out, re.MULTILINE)
    return int(found[1]) if found else 0


def _regions(out):
    """Volumes by region, and of all of them."""
    table = re.search(r"^  region +cells +volume.*\n((?:  \S+ +\d+ +\S+\n)+)", out, re.MULTILINE)
    rows = [line.split() for line in table[1].splitlines()] if table else []
    return {name: float(volume) for name, _, volume in rows}


def _wrong_volumes(scene, found):
    if not found:
        return "no volumes printed"
    if scene.volumes is None:
        return ""
    expected = scene.volumes()
    total = found.pop("sum", None)
    if total is None:
        total = sum(found.values())
    size = sum(volume.value for volume in expected.values())
    wrong = []
    for name in sorted({*expected, *found}):
        value, allowed = _expected(expected.get(name), scene)
        if abs(found.get(name, 0.0) - value) > allowed:
            wrong.append(f"volume of {name}: {found.get(name, 0.0):.9g}, expected {value:.9g} within {allowed:.1g}")
    allowed = DIGITS * size + sum(_expected(volume, scene)[1] for volume in expected.values())
    if abs(total - size) > allowed:
        wrong.append(f"volume of all: {total:.9g}, expected {size:.9g} within {allowed:.1g}")
    return "; ".join(wrong)


def _expected(volume, scene):
    """Value, and the difference that rounding, snapping and the lines explain."""
    if volume is None:
        return 0.0, 0.0
    moved = 4 * SNAP * scene.size * volume.area
    return volume.value, DIGITS * volume.value + moved + DEVIATIONS * math.sqrt(volume.variance)
