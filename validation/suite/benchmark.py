# SPDX-License-Identifier: AGPL-3.0-or-later
"""One folder of validation/benchmarks: what is run, with what it is compared, and how near it must be."""

import importlib.util
import itertools
import pathlib
import tomllib

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "benchmarks"
KEYS = {"title", "group", "text", "source", "references", "quick", "not_yet", "missed", "run", "tolerance", "chance", "plot", "picture", "sketch"}
CHANCE_KEYS = {"misses", "share", "reason"}
RUN_KEYS = {"name", "case", "set", "when", "balance", "study", "for", "column", "width", "sheet"}


class Benchmark:
    def __init__(self, folder):
        self.name = folder.name
        self.folder = folder
        with open(folder / "benchmark.toml", "rb") as file:
            self.data = tomllib.load(file)
        self._check(self.data, KEYS)
        self.title = self.data["title"]
        self.group = self.data["group"]
        self.text = self.data["text"].strip()
        self.source = self.data.get("source", "")
        self.references = self.data.get("references", [])
        self.quick = self.data.get("quick", True)
        self.not_yet = self.data.get("not_yet", "")
        self.missed = self.data.get("missed", "")
        self.tolerances = self.data.get("tolerance", [])
        # Of values with a random error, how many may miss, and by how much at most, of what is allowed.
        self.chance = self.data.get("chance", {"misses": 0, "share": 1.0, "reason": ""})
        self._check(self.chance, CHANCE_KEYS)
        self.plots = self.data.get("plot", [])
        self.pictures = self.data.get("picture", [])
        self.sketch = self.data.get("sketch", {})
        for run in self.data.get("run", []):
            self._check(run, RUN_KEYS)
        for tolerance in self.tolerances:
            if "reason" not in tolerance:
                raise SystemExit(f"{folder / 'benchmark.toml'}: the tolerance of {tolerance['of']} gives no reason")

    def _check(self, table, accepted):
        unknown = table.keys() - accepted
        if unknown:
            raise SystemExit(f"{self.folder / 'benchmark.toml'}: {', '.join(sorted(unknown))}: unknown; accepted are "
                             f"{', '.join(sorted(accepted))}")

    def runs(self, full):
        """Those of the quick or of the full set; `when` says to which a run belongs, without it to both."""
        wanted = "full" if full or not self.quick else "quick"
        return [one for run in self.data.get("run", []) if run.get("when", wanted) == wanted for one in expand(run)]

    def module(self):
        """compare.py of the folder: compare(runs) gives rows, lines(runs), if there is one, curves for the plots."""
        spec = importlib.util.spec_from_file_location(f"compare_{self.name.replace('-', '_')}", self.folder / "compare.py")
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        return module


def expand(run):
    """With for = { a = [1, 2], b = [3] } the runs with {a} and {b} in name and set replaced by each combination."""
    values = run.get("for", {})
    for chosen in itertools.product(*values.values()):
        words = dict(zip(values, chosen))
        yield run | {key: replace(run[key], words) for key in ("name", "set") if key in run}


def replace(text, words):
    if isinstance(text, list):
        return [replace(part, words) for part in text]
    for word, value in words.items():
        text = text.replace("{" + word + "}", str(value))
    return text


def read_all():
    """By name, in the order of the front page: groups, then names."""
    found = [Benchmark(path.parent) for path in FOLDER.glob("*/benchmark.toml")]
    return {entry.name: entry for entry in sorted(found, key=lambda e: (e.group, e.name))}
