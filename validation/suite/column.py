# SPDX-License-Identifier: AGPL-3.0-or-later
"""A column of flat layers, six tetrahedra in each, for problems of one dimension: as Gmsh mesh.

Cells are as wide as the column and as flat as the solution wants them; sides are walls "side", ends "zmin" and "zmax"."""

import itertools

import numpy

# The cube's six tetrahedra along its diagonal (Kuhn): every layer is cut alike, so neighbours fit.
PATHS = list(itertools.permutations(((1, 0, 0), (0, 1, 0), (0, 0, 1))))


def heights(part):
    """Planes of a part { region, from, to, layers, fine }: finer towards its start, its end, both, or even."""
    t = numpy.linspace(0, 1, part["layers"] + 1)
    power = part.get("power", 2)
    spaced = {"start": t ** power, "end": 1 - (1 - t) ** power, "none": t,
              "both": numpy.where(t < 0.5, (2 * t) ** power / 2, 1 - (2 - 2 * t) ** power / 2)}[part.get("fine", "none")]
    return part["from"] + (part["to"] - part["from"]) * spaced


def write(path, parts, width):
    planes, regions = [parts[0]["from"]], []
    for part in parts:
        planes += list(heights(part)[1:])
        regions += [part["region"]] * part["layers"]
    names = list(dict.fromkeys(regions))
    walls = ["side", "zmin", "zmax"]
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(names) + 3)]
    lines += [f'2 {k + 1} "{name}"' for k, name in enumerate(walls)]
    lines += [f'3 {k + 4} "{name}"' for k, name in enumerate(names)]
    lines += ["$EndPhysicalNames", "$Nodes", str(4 * len(planes))]
    lines += [f"{vertex(x, y, k) + 1} {width * x:.17g} {width * y:.17g} {z:.17g}"
              for k, z in enumerate(planes) for y in (0, 1) for x in (0, 1)]
    elements = [(2, tag, face) for tag, face in faces(len(planes) - 1)]
    elements += [(4, names.index(region) + 4, cell) for k, region in enumerate(regions) for cell in cells(k)]
    lines += ["$EndNodes", "$Elements", str(len(elements))]
    lines += [f"{number + 1} {kind} 2 {tag} {tag} {' '.join(str(v + 1) for v in vertices)}"
              for number, (kind, tag, vertices) in enumerate(elements)]
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join([*lines, "$EndElements", ""]), encoding="ascii")


def vertex(x, y, k):
    return 4 * k + 2 * y + x


def cells(k):
    """The six tetrahedra of layer k, of positive volume."""
    for path in PATHS:
        corner, found = (0, 0, 0), [vertex(0, 0, k)]
        for step in path:
            corner = tuple(a + b for a, b in zip(corner, step))
            found.append(vertex(corner[0], corner[1], k + corner[2]))
        odd = numpy.linalg.det(numpy.array(path)) < 0
        yield [found[0], found[2], found[1], found[3]] if odd else found


def faces(layers):
    """Wall number and vertices of each triangle on the outside: faces that only one cell has."""
    count = {}
    for k in range(layers):
        for cell in cells(k):
            for face in itertools.combinations(cell, 3):
                count[tuple(sorted(face))] = count.get(tuple(sorted(face)), 0) + 1
    for face, times in count.items():
        if times == 1:
            layer = {v // 4 for v in face}
            yield (2 if layer == {0} else 3 if layer == {layers} else 1), face
