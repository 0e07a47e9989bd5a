# SPDX-License-Identifier: AGPL-3.0-or-later
"""A set-up sketch from the case itself: a cut through its primitives, walls by what they do, probes as points."""

import tomllib

from matplotlib import patches, pyplot

from suite.plots import save

AXES = "xyz"
FILLS = ["#dce9f5", "#f8e3cf", "#d9efe3", "#f3dcea", "#fbf0cc", "#e3e3e3"]
HATCHES = ["", "//", "..", "xx", "\\\\", "++"]


def draw_sketch(result, options, column=None, sheet=None):
    """The cut `normal` = `at` through the primitives, the layers of a column or the regions of a sheet; None for another mesh from a file."""
    case = tomllib.loads(result.summary["case"])
    if column:
        case["mesh"] = {"box": layers(column)}
        case["probe"] = []
    if sheet:
        case["mesh"] = {"box": [{"region": r["name"], "min": [*r["min"], 0], "max": [*r["max"], sheet["thickness"]]}
                                for r in sheet["regions"]]}
    mesh = case["mesh"]
    if not any(kind in mesh for kind in ("box", "sphere", "cylinder")):
        return None
    cut = Cut(options.get("normal", "y"), options.get("at"), case)
    figure, axes = pyplot.subplots(figsize=(4.4, 4), layout="constrained")
    axes.grid(False)
    for box in mesh.get("box", []):
        cut.add_box(axes, box)
    for sphere in mesh.get("sphere", []):
        cut.add_sphere(axes, sphere)
    for cylinder in mesh.get("cylinder", []):
        cut.add_cylinder(axes, cylinder)
    cut.add_sides(axes)
    cut.add_probes(axes, case.get("probe", []))
    axes.set_xlabel(AXES[cut.across[0]])
    axes.set_ylabel(AXES[cut.across[1]])
    axes.set_title(f"cut {cut.normal} = {cut.at:g}", fontsize="small")
    axes.autoscale_view()
    if cut.stretched():
        axes.set_aspect("auto")
    else:
        axes.set_aspect("equal")
    axes.legend(fontsize="x-small", loc="upper center", bbox_to_anchor=(0.5, -0.16), ncols=2)
    return save(figure)


def layers(column):
    """A column's parts as boxes, drawn a third as wide as all of them are high."""
    width = (column[-1]["to"] - column[0]["from"]) / 3
    walls = {"xmin": "side", "xmax": "side", "ymin": "side", "ymax": "side"}
    return [{"region": part["region"], "min": [0, 0, part["from"]], "max": [width, width, part["to"]], "walls": walls}
            for part in column]


class Cut:
    def __init__(self, normal, at, case):
        self.normal = normal
        self.case = case
        self.axis = AXES.index(normal)
        self.across = [k for k in range(3) if k != self.axis]
        boxes = [box for box in case["mesh"].get("box", []) if "region" in box]
        self.low = [min((box["min"][k] for box in boxes), default=0) for k in range(3)]
        self.high = [max((box["max"][k] for box in boxes), default=0) for k in range(3)]
        self.at = (self.low[self.axis] + self.high[self.axis]) / 2 if at is None else at
        self.fills = {}

    def stretched(self):
        width, height = (self.high[k] - self.low[k] for k in self.across)
        return min(width, height) < 0.15 * max(width, height)

    def _style(self, region):
        """Regions of the same matter look alike and share an entry of the legend."""
        if region is None:
            return {"facecolor": "white", "edgecolor": "0.2", "hatch": "xxx"}
        matter = self._matter(region)
        new = matter not in self.fills
        number = self.fills.setdefault(matter, len(self.fills))
        style = {"facecolor": FILLS[number % len(FILLS)], "edgecolor": "0.5", "linewidth": 0.7,
                 "hatch": HATCHES[number // len(FILLS) % len(HATCHES)]}
        return style | {"label": f"{region.split('-')[0]}: {matter}"} if new else style

    def _matter(self, region):
        medium = self.case["media"].get(region, self.case["media"].get("*", {}))
        words = [f"{symbol} {short(medium[key])}" for key, symbol in
                 (("absorption", "σa"), ("scattering", "σs"), ("extinction", "σt"), ("albedo", "albedo"),
                  ("emission", "q"), ("power_density", "4πq"), ("power", "power")) if medium.get(key)]
        return ", ".join(words) or "void"

    def add_box(self, axes, box):
        if not box["min"][self.axis] - 1e-12 <= self.at <= box["max"][self.axis] + 1e-12:
            return
        a, b = self.across
        axes.add_patch(patches.Rectangle((box["min"][a], box["min"][b]), box["max"][a] - box["min"][a],
                                         box["max"][b] - box["min"][b], **self._style(box.get("region"))))

    def add_sphere(self, axes, sphere):
        squared = sphere["radius"] ** 2 - (sphere["center"][self.axis] - self.at) ** 2
        if squared > 0:
            center = [sphere["center"][k] for k in self.across]
            self._note(center, squared ** 0.5)
            axes.add_patch(patches.Circle(center, squared ** 0.5, **self._style(sphere.get("region"))))

    def add_cylinder(self, axes, cylinder):
        """Cut across its axis or along it."""
        a, b = self.across
        start, end, radius = cylinder["from"], cylinder["to"], cylinder["radius"]
        if start[a] == end[a] and start[b] == end[b]:
            self._note((start[a], start[b]), radius)
            axes.add_patch(patches.Circle((start[a], start[b]), radius, **self._style(cylinder.get("region"))))
            return
        along = a if start[a] != end[a] else b
        other = b if along == a else a
        corner = [0.0, 0.0]
        corner[self.across.index(along)] = min(start[along], end[along])
        corner[self.across.index(other)] = start[other] - radius
        sizes = [0.0, 0.0]
        sizes[self.across.index(along)] = abs(end[along] - start[along])
        sizes[self.across.index(other)] = 2 * radius
        self._note(corner, 0)
        axes.add_patch(patches.Rectangle(corner, *sizes, **self._style(cylinder.get("region"))))

    def _note(self, center, radius):
        for place, k in zip(center, self.across):
            self.low[k], self.high[k] = min(self.low[k], place - radius), max(self.high[k], place + radius)

    def add_sides(self, axes):
        """The four outer sides of the boxes, drawn as what their walls do."""
        a, b = self.across
        left, right, bottom, top = self.low[a], self.high[a], self.low[b], self.high[b]
        lines = {AXES[a] + "min": ([left, left], [bottom, top]), AXES[a] + "max": ([right, right], [bottom, top]),
                 AXES[b] + "min": ([left, right], [bottom, bottom]), AXES[b] + "max": ([left, right], [top, top])}
        shown = set()
        if not self.case["mesh"].get("box"):
            return
        for side, (x, y) in lines.items():
            style, label = self._side(side)
            axes.plot(x, y, **style, label=None if label in shown else label, clip_on=False)
            shown.add(label)

    def _side(self, side):
        names = [box["walls"][side] for box in self.case["mesh"].get("box", []) if side in box.get("walls", {})]
        wall = self.case["walls"].get(names[-1] if names else side, self.case["walls"].get("*", {}))
        if wall.get("specular"):
            return {"color": "#0072B2", "linestyle": (0, (4, 2)), "linewidth": 2}, "mirror"
        if wall.get("radiance") or wall.get("beam"):
            return {"color": "#D55E00", "linewidth": 4}, "lit: radiance" if wall.get("radiance") else "lit: beam"
        if wall.get("diffuse"):
            return {"color": "#009E73", "linewidth": 3}, f"diffuse {short(wall['diffuse'])}"
        return {"color": "black", "linewidth": 1.5}, "black, cold"

    def add_probes(self, axes, probes):
        for number, probe in enumerate(probes):
            points = probe.get("points") or [probe["line"]["from"], probe["line"]["to"]]
            axes.plot([p[self.across[0]] for p in points], [p[self.across[1]] for p in points],
                      "." if "points" in probe else ".:", color="black", markersize=4, linewidth=0.8,
                      label="values compared" if number == 0 else None)


def short(value):
    """A number, a formula, or a list of them by its ends."""
    if isinstance(value, list):
        return short(value[0]) if len(set(map(str, value))) == 1 else f"{short(value[0])} … {short(value[-1])}"
    text = value if isinstance(value, str) else f"{value:g}"
    return text if len(text) < 26 else text[:23] + "…"
