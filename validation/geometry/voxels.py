# SPDX-License-Identifier: AGPL-3.0-or-later
"""Images of voxels: single ones, stairs that touch in edges and corners, and voxels that are flat or long."""

from geometry.volumes import Volume

NAMES = ("a", "b", "c")


def voxels(scene):
    draw = scene.draw
    count = [draw.integer(1, 6) for _ in range(3)]
    spacing = [draw.one_of((1.0, 1.0, draw.logarithmic(1e-4, 1))) for _ in range(3)]
    most = draw.integer(1, 4)
    labels = [draw.integer(0, most) for _ in range(count[0] * count[1] * count[2])]
    extent = " ".join(f"0 {n}" for n in count)
    scene.files["image.vti"] = (
        f'<VTKFile type="ImageData"><ImageData WholeExtent="{extent}" Origin="0 0 0" Spacing="{_text(spacing)}">'
        f'<Piece Extent="{extent}"><CellData Scalars="label"><DataArray type="Int32" Name="label" format="ascii">'
        f'{_text(labels)}</DataArray></CellData></Piece></ImageData></VTKFile>\n')
    listed = {name: label for label, name in enumerate(NAMES, 1) if label in labels} or {"a": 0}
    scene.mesh["labels"] = {"file": "image.vti", "regions": listed}
    voxel = spacing[0] * spacing[1] * spacing[2]
    scene.volumes = lambda: {name: Volume(labels.count(label) * voxel) for name, label in listed.items()}


def _text(values):
    return " ".join(map(str, values))


KINDS = {"voxels": voxels}
