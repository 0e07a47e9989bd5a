# SPDX-License-Identifier: AGPL-3.0-or-later
"""Directories that runs write results into, and whether they are whole."""
import json
import re

MARK = re.compile(rb"mark(\d+)[xy]")
# What stays beside the results of another run: the user's, and the log of a run that failed.
KEPT = ("note.txt", "log-failed.txt", ".replaced-files")
NOTE = "what the user wrote\n"


class Fault(Exception):
    """A directory that is not whole."""


def is_hidden_part(path):
    return path.name.startswith(".") and path.name.endswith(".part")


def marks_in(folder):
    """The runs whose files are in a directory: {number: [names]}."""
    marks = {}
    for path in folder.iterdir():
        if path.name in KEPT or path.is_dir() or is_hidden_part(path):
            continue
        for mark in set(MARK.findall(path.read_bytes())):
            marks.setdefault(mark, []).append(path.name)
    return marks


def check_summary(folder):
    """True where there are results."""
    path = folder / "summary.json"
    if not path.exists():
        return False
    try:
        summary = json.loads(path.read_text(encoding="utf-8"))
    except ValueError as error:
        raise Fault(f"{path} is torn: {error}") from error
    for key in ("files", "converged", "balance", "case"):
        if key not in summary:
            raise Fault(f"{path} has no {key}")
    missing = [name for name in summary["files"] if not (folder / name).exists()]
    if missing:
        raise Fault(f"{path} lists files that are not there: {missing}")
    return True


class Target:
    """A directory of results with what a user put there."""

    def __init__(self, folder, with_directory):
        self.folder = folder
        self.with_directory = with_directory
        self.had_results = False
        folder.mkdir()
        (folder / "note.txt").write_text(NOTE, encoding="utf-8")
        if with_directory:
            (folder / "mine").mkdir()
            (folder / "mine" / "note.txt").write_text(NOTE, encoding="utf-8")

    def check(self):
        marks = marks_in(self.folder)
        if len(marks) > 1:
            raise Fault(f"{self.folder} has files of {len(marks)} runs: {marks}")
        has_results = check_summary(self.folder)
        if self.had_results and not has_results and not self.with_directory:
            raise Fault(f"{self.folder} had results and has none: {sorted(p.name for p in self.folder.iterdir())}")
        self.had_results = has_results
        notes = [self.folder / "note.txt"] + ([self.folder / "mine" / "note.txt"] if self.with_directory else [])
        for note in notes:
            if note.read_text(encoding="utf-8") != NOTE:
                raise Fault(f"{note} has changed")


def hidden_parts(folder):
    return [path for path in folder.rglob("*") if is_hidden_part(path)]
