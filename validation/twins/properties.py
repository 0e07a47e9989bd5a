# SPDX-License-Identifier: AGPL-3.0-or-later
"""The properties: each solves a scene and its twin, and returns their differences. `part` is the planted error of the twin."""

import math

from differential import values
from suite.result import read_rows

from twins import answer, difference, motion, permuted_case, planted, ports, shared_light, tolerances
from twins.moved_case import moved_case
from twins.program import FIRST

PHOTONS = {"method": "photons", "photons": 5e4, "probe_photons": 5e3, "threads": 1}


def _moved(scene, program, how, part, tolerance):
    """The scene on a mesh, and its image on the image of the mesh."""
    first = program.mesh(scene.case)
    second = first.moved(how)
    one = answer.read(program.on_grid(FIRST, scene.case, first), first)
    case = planted.stronger(moved_case(scene.case, how), part)
    return difference.by_size(one.moved(how), answer.read(program.on_grid("second", case, second), second), tolerance)


def by_geometry(scene):
    return tolerances.RAYS if scene.along_rays else tolerances.ITERATION


def turned(scene, program, part):
    """Rotated by multiples of 90 degrees: the direction set is mapped onto itself."""
    return _moved(scene, program, motion.rotated_by_90(scene.draw, scene.upright), part, by_geometry(scene))


def mirrored(scene, program, part):
    """Mirrored in a coordinate plane or a diagonal one, or in a point: the direction set is mapped onto itself."""
    return _moved(scene, program, motion.mirrored(scene.draw, scene.upright), part, by_geometry(scene))


def rotated(scene, program, part):
    """Rotated by any angle and shifted, the direction set with it."""
    return _moved(scene, program, motion.rotated(scene.draw, scene.upright), part, by_geometry(scene))


def scaled(scene, program, part):
    """By a power of two: no product is rounded otherwise, along rays neither."""
    return _moved(scene, program, motion.scaled(2.0 ** scene.draw.one_of((-10, -3, 4, 10))), part, tolerances.ITERATION)


def millimetres(scene, program, part):
    """By 1000, which rounds."""
    return _moved(scene, program, motion.scaled(1000.0), part, by_geometry(scene))


def renumbered(scene, program, part):
    """Vertices, cells and faces of the mesh, regions and walls in another order."""
    first = program.mesh(scene.case)
    second = first.shuffled(scene.draw)
    one = answer.read(program.on_grid(FIRST, scene.case, first), first)
    two = answer.read(program.on_grid("second", planted.stronger(scene.case, part), second), second)
    return difference.by_size(one, two, by_geometry(scene))


def permuted(scene, program, part):
    """Tables of the case file and bands in another order, on the same mesh."""
    mesh = program.mesh(scene.case)
    case = permuted_case.permuted(planted.stronger(scene.case, part), scene.draw)
    one, two = (answer.read(program.run(name, case), mesh) for name, case in ((FIRST, scene.case), ("second", case)))
    return difference.by_size(one, two, tolerances.ITERATION)


def split(scene, program, part):
    """Each band alone. All bands share the rays, which are divided until every band is settled: alone it has others."""
    mesh, names = program.mesh(scene.case), scene.case["bands"]["names"]
    together, rows = answer.read(program.run(FIRST, scene.case), mesh), []
    for k, name in enumerate(names):
        case = planted.stronger(permuted_case.with_bands(scene.case, [k]), part)
        alone = answer.read(program.run(name, case), mesh)
        rows += difference.by_size(together.band(name), alone, by_geometry(scene))
    return rows


def superposed(scene, program, part):
    """All that shines, and each of two parts of it alone."""
    case = shared_light.with_more(scene)
    mesh, emitters = program.mesh(case), scene.draw.shuffled(shared_light.emitters(case))
    one, two = (answer.read(program.run(name, shared_light.only(planted.stronger(case, part), kept)), mesh)
                for name, kept in (("some", emitters[0::2]), ("others", emitters[1::2])))
    return difference.by_size(answer.read(program.run("all", case), mesh), one.plus(two), tolerances.ITERATION)


def _reciprocal(scene, program, part, solves, allow):
    case, regions = ports.with_boxes(scene)
    pair = scene.draw.shuffled(ports.candidates(case, regions))[:2]
    there, back = (program.run(name, planted.stronger(ports.shining(case, port), more) | {"solve": solve})
                   for name, port, more, solve in zip(("there", "back"), pair, (0.0, part), solves))
    one, two = ports.received(there, pair[1]), ports.received(back, pair[0])
    where = " and ".join(name for _, name in pair)
    return [difference.Difference(where, "received", band, one[band][0], two[band][0], allow(one[band], two[band]), 1)
            for band in one]


def reciprocal(scene, program, part):
    """Light from a region or wall a to b, and from b to a: the discrete equations are reciprocal too (docs/theory/adjoint.md).

    What reaches a port in the shadow may be a trifle below zero, and is the same from both sides."""
    return _reciprocal(scene, program, part, [scene.case["solve"]] * 2, lambda one, two: tolerances.ITERATION * max(abs(one[0]), abs(two[0])))


def _by_photons():
    return [PHOTONS | {"seed": seed} for seed in (1, 2)]


def reciprocal_photons(scene, program, part):
    """The same by photons."""
    return _reciprocal(scene, program, part, _by_photons(), lambda one, two: tolerances.PHOTONS * math.hypot(one[1], two[1]))


def moved_photons(scene, program, part):
    """Rotated by any angle or mirrored, or scaled, with other random numbers."""
    draw, first = scene.draw, program.mesh(scene.case)
    how = draw.one_of((motion.rotated(draw, scene.upright), motion.mirrored(draw, scene.upright), motion.scaled(1000.0)))
    cases = scene.case, planted.stronger(moved_case(scene.case, how), part)
    one, two = (answer.read(program.on_grid(name, case | {"solve": solve}, mesh)) for name, case, solve, mesh in
                zip((FIRST, "second"), cases, _by_photons(), (first, first.moved(how))))
    return difference.by_error(one.moved(how), two, tolerances.PHOTONS)


def moved_radiosity(scene, program, part):
    """Rotated by any angle: rays between patches that an obstacle may separate go elsewhere."""
    scene.case["solve"] = {"method": "radiosity", "threads": 1}
    return _moved(scene, program, motion.rotated(scene.draw, scene.upright), part, tolerances.RAYS)


def _within(first, second, errors):
    """Differences with ERRORS of the given errors allowed; those are estimates, so small ones count as the floor."""
    floors = values.floors_of(first)
    return [difference.Difference(*key, value, second[key][0], tolerances.ERRORS * math.hypot(errors[key], floors[key[1:]]), 1)
            for key, (value, _) in first.items()]


def finer(scene, program, part):
    """On cells of an eighth of the volume and four times the directions: a change within the stated errors."""
    base = program.run("base", scene.case, ("--estimate",))
    fine = planted.stronger(scene.case, part)
    fine["mesh"]["max_volume"] /= 8
    fine["directions"]["order"] *= 2
    known = values.values_of(program.run("fine", fine))
    stated = {(row["where"], row["quantity"], row["band"]): row for row in read_rows(base.folder / "estimate.csv")}
    found = {key: (float(row["value"]), 0.0) for key, row in stated.items() if key in known}
    errors = values.errors_from(found, {key: (value + float(stated[key]["error"]), 0.0) for key, (value, _) in found.items()}, 1)
    return _within(found, known, errors)
