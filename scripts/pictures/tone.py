# SPDX-License-Identifier: AGPL-3.0-or-later
"""From radiance to the colours of a display, and back."""

import numpy

LARGEST = 0.995  # of full white: what is brighter cannot be told apart on the way back


def as_rgb(values):
    """Three components: red, green and blue bands as they are, one band as grey."""
    if values.shape[1] == 3:
        return values
    return numpy.repeat(values[:, :1], 3, axis=1)


def display_values(radiance, bright):
    """Numbers 0..255. `bright` is the radiance that comes out at half of full white; the curve 1 - 2^(-x) lets
    brighter ones approach full white without clipping."""
    linear = 1 - numpy.exp2(-numpy.maximum(radiance, 0) / bright)
    return numpy.rint(255 * encode_srgb(linear)).astype(numpy.uint8)


def linear_values(display, bright):
    """The radiance that display_values shows so."""
    return -numpy.log2(1 - numpy.minimum(decode_srgb(display / 255), LARGEST)) * bright


def encode_srgb(linear):
    """Transfer function of IEC 61966-2-1."""
    return numpy.where(linear <= 0.0031308, 12.92 * linear,
                       1.055 * numpy.maximum(linear, 0.0031308) ** (1 / 2.4) - 0.055)


def decode_srgb(value):
    return numpy.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4)
