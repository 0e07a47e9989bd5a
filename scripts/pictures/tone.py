# SPDX-License-Identifier: AGPL-3.0-or-later
"""From radiance to the colours of a display."""

import numpy


def as_rgb(values):
    """Three components: red, green and blue bands as they are, one band as grey."""
    if values.shape[1] == 3:
        return values
    return numpy.repeat(values[:, :1], 3, axis=1)


def tone_map(radiance, white):
    """Display values 0..255. `white` is the radiance that comes out at 80 % of the display's white; the curve
    1 - exp(-x) lets brighter ones approach full white without clipping."""
    linear = 1 - numpy.exp(-numpy.log(5) * numpy.maximum(radiance, 0) / white)
    return numpy.rint(255 * encode_srgb(linear)).astype(numpy.uint8)


def encode_srgb(linear):
    """Transfer function of IEC 61966-2-1."""
    return numpy.where(linear <= 0.0031308, 12.92 * linear,
                       1.055 * numpy.maximum(linear, 0.0031308) ** (1 / 2.4) - 0.055)
