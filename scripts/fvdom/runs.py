# SPDX-License-Identifier: AGPL-3.0-or-later
"""Runs of one process, and the processor time that they take."""

import dataclasses
import os
import subprocess
import time


@dataclasses.dataclass(frozen=True)
class Seconds:
    """Seconds of one process: of the processor (user and system) and of the clock."""
    processor: float
    clock: float


class RunFailed(Exception):
    """A program that ended with an error; its message holds the end of the log."""


def timed(command, folder, log, environment, limit=1800):
    """Runs a program to its end and returns its Seconds."""
    begin = time.monotonic()
    with open(log, "w", encoding="utf-8") as out:
        process = subprocess.Popen(["timeout", str(limit), *map(str, command)], cwd=folder, env=environment,
                                   stdout=out, stderr=subprocess.STDOUT)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        end = log.read_text(encoding="utf-8", errors="replace")[-2000:]
        raise RunFailed(f"{command[0]} ended with {process.returncode}; the end of {log}:\n{end}")
    return Seconds(usage.ru_utime + usage.ru_stime, time.monotonic() - begin)
