# SPDX-License-Identifier: AGPL-3.0-or-later
"""Which properties there are, which scenes have them, and the planted error that each has to notice."""

import dataclasses
import typing

from twins import ports, properties, shared_light, tolerances


@dataclasses.dataclass
class Property:
    check: typing.Callable
    holds: typing.Callable    # whether a scene has it
    planted: typing.Callable  # of a scene the error of all that shines

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


def _has_patches_alone(scene):
    """A void without mirrors and glossy walls, where the noise of `path_rays` is several percent."""
    smooth = any({"specular", "glossy"} & wall.keys() for wall in scene.case["walls"].values())
    return "radiosity" in scene.features and not smooth


def _refines(scene):
    return scene.case["directions"]["set"] == "ldfe-sq"


def _geometric(scene):
    return BEYOND * properties.by_geometry(scene)


def _iterated(_):
    return BEYOND * tolerances.ITERATION


def _estimated(_):
    """Noise and the errors of coarse cells hide less."""
    return 1.0


BEYOND = 10  # times what is allowed of a value that is the largest of its quantity
PROPERTIES = [
    Property(properties.turned, _always, _geometric),
    Property(properties.mirrored, _always, _geometric),
    Property(properties.rotated, _rotates, _geometric),
    Property(properties.scaled, _always, _iterated),
    Property(properties.millimetres, _always, _geometric),
    Property(properties.renumbered, _always, _geometric),
    Property(properties.permuted, _always, _iterated),
    Property(properties.split, _has_bands, _geometric),
    Property(properties.superposed, _adds, _iterated),
    Property(properties.reciprocal, _is_reciprocal, _iterated),
    Property(properties.reciprocal_photons, _is_reciprocal, _estimated),
    Property(properties.moved_photons, _rotates, _estimated),
    Property(properties.moved_radiosity, _has_patches_alone, lambda _: BEYOND * tolerances.RAYS),
    Property(properties.finer, _refines, _estimated),
]
