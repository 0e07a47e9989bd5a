# SPDX-License-Identifier: AGPL-3.0-or-later
"""Files of a field at several times, joined to a moving picture: what scripts/view makes of a .pvd file."""

import argparse
import pathlib
import tempfile
import xml.etree.ElementTree

import numpy
from PIL import Image
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

from pictures.results import array, read_vtk
from pictures.view import View

MILLISECONDS = 80  # of a frame
SHOWN = 99.5  # per cent of all values are within the colours


def frames_of(path):
    """[(time, file)] of a collection."""
    found = xml.etree.ElementTree.parse(path).iter("DataSet")
    frames = [(float(frame.get("timestep")), path.parent / frame.get("file")) for frame in found]
    if not frames:
        raise SystemExit(f"view: {path}: has no frames")
    return frames


def common_range(frames, options):
    """From 0 to what nearly all values of all frames are below."""
    values = [array(read_vtk(vtkXMLUnstructuredGridReader(), file).GetPointData(), options.array or "fluence")[:, 0]
              for _, file in frames]
    return 0.0, float(numpy.percentile(numpy.concatenate(values), SHOWN))


def in_common_colours(pictures):
    """The pictures in one palette, which a moving PNG has, made of some of them."""
    some = pictures[:: max(1, len(pictures) // 8)]
    width, height = pictures[0].size
    sheet = Image.new("RGB", (width, height * len(some)))
    for place, picture in enumerate(some):
        sheet.paste(picture, (0, place * height))
    palette = sheet.quantize(256, dither=Image.Dither.NONE)
    return [picture.quantize(palette=palette, dither=Image.Dither.NONE) for picture in pictures]


def film(options):
    frames = frames_of(options.file)
    options.range = options.range or common_range(frames, options)
    with tempfile.TemporaryDirectory() as folder:
        pictures = []
        for number, (time, file) in enumerate(frames):
            own = argparse.Namespace(**vars(options))
            own.file, own.output = file, pathlib.Path(folder) / f"{number}.png"
            own.label = f"t = {time:.4g}"
            View(own).show()
            with Image.open(own.output) as picture:
                pictures.append(picture.convert("RGB"))
        pictures = in_common_colours(pictures)
        pictures[0].save(options.output, save_all=True, append_images=pictures[1:], duration=MILLISECONDS, loop=0)
