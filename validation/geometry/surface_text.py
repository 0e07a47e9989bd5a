# SPDX-License-Identifier: AGPL-3.0-or-later
"""Surface files: STL, OBJ, OFF, PLY and TetGen's .smesh."""


def add_surface(scene, ending, points, polygons):
    """The file beside the case, and its key."""
    if ending == "stl":
        polygons = [(polygon[0], polygon[i], polygon[i + 1])
                    for polygon in polygons for i in range(1, len(polygon) - 1)]
    scene.mesh["surface"] = f"surface.{ending}"
    scene.files[scene.mesh["surface"]] = surface_text(ending, points, polygons)
    if scene.draw.chance(0.2):
        scene.mesh["up"] = "y"


def surface_text(ending, points, polygons):
    """Of points and polygons, lists of numbers of points; STL takes triangles alone."""
    return {"stl": _stl, "obj": _obj, "off": _off, "ply": _ply, "smesh": _smesh}[ending](points, polygons)


def _place(point):
    return " ".join(repr(float(x)) for x in point)


def _stl(points, polygons):
    facets = ["facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {_place(points[p])}\n" for p in polygon)
              + "endloop\nendfacet\n" for polygon in polygons]
    return "solid body\n" + "".join(facets) + "endsolid body\n"


def _obj(points, polygons):
    return "".join(f"v {_place(point)}\n" for point in points) + "".join(
        "f " + " ".join(str(p + 1) for p in polygon) + "\n" for polygon in polygons)


def _off(points, polygons):
    return f"OFF\n{len(points)} {len(polygons)} 0\n" + _lists(points, polygons)


def _ply(points, polygons):
    place = "".join(f"property double {axis}\n" for axis in "xyz")
    return (f"ply\nformat ascii 1.0\nelement vertex {len(points)}\n{place}element face {len(polygons)}\n"
            "property list uchar int vertex_indices\nend_header\n" + _lists(points, polygons))


def _lists(points, polygons):
    return "".join(_place(point) + "\n" for point in points) + "".join(
        f"{len(polygon)} " + " ".join(map(str, polygon)) + "\n" for polygon in polygons)


def _smesh(points, polygons):
    numbered = "".join(f"{number} {_place(point)}\n" for number, point in enumerate(points))
    facets = "".join(f"{len(polygon)} " + " ".join(map(str, polygon)) + " 1\n" for polygon in polygons)
    return f"{len(points)} 3 0 0\n{numbered}{len(polygons)} 1\n{facets}0\n0\n"
