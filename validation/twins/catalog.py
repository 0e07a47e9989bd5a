# SPDX-License-Identifier: AGPL-3.0-or-later
"""Which properties there are, which scenes have them, and the planted error that each has to notice."""

import dataclasses
import typing

from twins import ports, properties, shared_light, tolerances


@dataclasses.dataclass
class Property:
    check: typing.Callable
    holds: typing.Callable  # whether a scene has it
    planted: float          # error of all that shines

    @property
    def name(self):
        return self.check.__name__.replace("_", "-")


def _always(_):
    return True


def _rotates(scene):
    """Weights at walls that refract keep half ranges along x, y and z, and so are others after a rotation."""
    return not scene.refracting


def _adds(scene):
    """At glossy walls light of several lamps along rays is taken as one, by its mean direction (docs/theory/adjoint.md)."""
    return not (scene.glossy and scene.along_rays) and len(shared_light.emitters(shared_light.with_more(scene))) > 1


def _is_reciprocal(scene):
    """Not where absorption depends on the sense of a direction."""
    case, regions = ports.with_boxes(scene)
    even = not any("w" in str(medium.get("absorption", "")) for medium in case["media"].values())
    return even and len(ports.candidates(case, regions)) > 1


def _has_bands(scene):
    return len(scene.case["bands"]["names"]) > 1


def _uncoupled(scene):
    return "radiosity" in scene.features


def _refines(scene):
    return scene.case["directions"]["set"] == "ldfe-sq"


RAYS, ITERATION = 3 * tolerances.RAYS, 100 * tolerances.ITERATION
PROPERTIES = [
    Property(properties.turned, _always, RAYS),
    Property(properties.mirrored, _always, RAYS),
    Property(properties.rotated, _rotates, RAYS),
    Property(properties.scaled, _always, ITERATION),
    Property(properties.millimetres, _always, RAYS),
    Property(properties.renumbered, _always, RAYS),
    Property(properties.permuted, _always, ITERATION),
    Property(properties.split, _has_bands, RAYS),
    Property(properties.superposed, _adds, ITERATION),
    Property(properties.reciprocal, _is_reciprocal, ITERATION),
    Property(properties.reciprocal_photons, _is_reciprocal, 1.0),
    Property(properties.moved_photons, _rotates, 0.2),
    Property(properties.moved_radiosity, _uncoupled, 0.2),
    Property(properties.finer, _refines, 1.0),
]
